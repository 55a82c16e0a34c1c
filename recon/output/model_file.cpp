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

std::string glb(const Reconstruction& reconstruction) { return glb_bytes(reconstruction); }

struct Format {
  std::string ending;
  std::string (*bytes)(const Reconstruction&);
};
const std::vector<Format>& formats() {
  static const std::vector<Format> all{{".glb", glb}, {".stl", stl_bytes}, {".ply", ply_bytes}, {".vtu", vtu_bytes}};
  return all;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

const std::vector<std::string>& model_endings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> list;
    for (const Format& format : formats()) list.push_back(format.ending);
    return list;
  }();
  return endings;
}

FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file) {
  const std::string ending = lower_case(file.extension().string());
  const auto& all = formats();
  const auto format = std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.ending == ending; });
  if (format == all.end()) {
    throw UsageError(fmt::format("{}: the ending tells no model format", file.string()),
                     fmt::format("Use one of {}", fmt::join(model_endings(), ", ")));
  }
  return {file, format->bytes(reconstruction)};
}

void write_model(const Reconstruction& reconstruction, std::span<const std::filesystem::path> files) {
  std::vector<FileContent> contents;
  for (const auto& file : files) contents.push_back(model_file(reconstruction, file));
  write_files(contents);
}

}  // namespace odontoscope
