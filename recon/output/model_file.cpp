#include "recon/output/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/core/error.h"
#include "recon/output/write_glb.h"
#include "recon/output/write_ply.h"
#include "recon/output/write_stl.h"
#include "recon/output/write_vtu.h"

namespace odontoscope {
namespace {

std::string glb(const WrittenModel& model) { return glb_bytes(model); }

/// Formats of surfaces; .vtu holds tetrahedra, and so is for reconstructions that have them.
struct Format {
  std::string ending;
  std::string (*bytes)(const WrittenModel&);
};
const std::vector<Format>& surface_formats() {
  static const std::vector<Format> all{{".glb", glb}, {".stl", stl_bytes}, {".ply", ply_bytes}};
  return all;
}
constexpr const char* tetrahedra_ending = ".vtu";

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

std::string ending_of(const std::filesystem::path& file) { return lower_case(file.extension().string()); }

FileContent surface_file(const WrittenModel& model, const std::filesystem::path& file, const std::vector<std::string>& endings) {
  const auto& all = surface_formats();
  const std::string ending = ending_of(file);
  const auto format = std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.ending == ending; });
  if (format == all.end()) {
    throw UsageError(fmt::format("{}: the ending tells no model format", file.string()),
                     fmt::format("Use one of {}", fmt::join(endings, ", ")));
  }
  return {file, format->bytes(model)};
}

}  // namespace

const std::vector<std::string>& surface_endings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> list;
    for (const Format& format : surface_formats()) list.push_back(format.ending);
    return list;
  }();
  return endings;
}

const std::vector<std::string>& model_endings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> list = surface_endings();
    list.push_back(tetrahedra_ending);
    return list;
  }();
  return endings;
}

FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file) {
  if (ending_of(file) == tetrahedra_ending) return {file, vtu_bytes(reconstruction)};
  return surface_file(reconstruction, file, model_endings());
}

FileContent model_file(const DbReconstruction& reconstruction, const std::filesystem::path& file) {
  if (ending_of(file) == tetrahedra_ending) {
    throw UsageError(fmt::format("{}: .vtu holds tetrahedra, and marching cubes makes none, only a surface", file.string()),
                     fmt::format("Use one of {}", fmt::join(surface_endings(), ", ")));
  }
  return surface_file(reconstruction, file, surface_endings());
}

void write_model(const Reconstruction& reconstruction, std::span<const std::filesystem::path> files) {
  std::vector<FileContent> contents;
  for (const auto& file : files) contents.push_back(model_file(reconstruction, file));
  write_files(contents);
}

}  // namespace odontoscope
