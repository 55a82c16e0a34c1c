#include "recon/output/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/output/write_glb.h"
#include "recon/output/write_inp.h"
#include "recon/output/write_msh.h"
#include "recon/output/write_obj.h"
#include "recon/output/write_ply.h"
#include "recon/output/write_stl.h"
#include "recon/output/write_vrml.h"
#include "recon/output/write_vtp.h"
#include "recon/output/write_vtu.h"

namespace odontoscope {
namespace {

std::string glb(const WrittenModel& model) { return glb_bytes(model); }

std::string gltf(const WrittenModel& model) { return gltf_text(model); }

/// Formats of surfaces, and of tetrahedra for reconstructions that have them.
template <class Model>
struct Format {
  std::string ending;
  std::string (*bytes)(const Model&);
};
const std::vector<Format<WrittenModel>>& surface_formats() {
  static const std::vector<Format<WrittenModel>> all{{".glb", glb},       {".stl", stl_bytes}, {".ply", ply_bytes},
                                                     {".gltf", gltf},     {".obj", obj_text},  {".wrl", vrml_text},
                                                     {".x3d", x3d_text},  {".vtp", vtp_bytes}};
  return all;
}
const std::vector<Format<Reconstruction>>& tetrahedra_formats() {
  static const std::vector<Format<Reconstruction>> all{{".vtu", vtu_bytes}, {".msh", msh_text}, {".inp", inp_text}};
  return all;
}

template <class Model>
std::vector<std::string> endings_of(const std::vector<Format<Model>>& formats) {
  std::vector<std::string> endings;
  for (const Format<Model>& format : formats) endings.push_back(format.ending);
  return endings;
}

std::string ending_of(const std::filesystem::path& file) { return lower_case(file.extension().string()); }

/// Null if the file's ending is that of no such format.
template <class Model>
const Format<Model>* format_of(const std::filesystem::path& file, const std::vector<Format<Model>>& formats) {
  const std::string ending = ending_of(file);
  const auto format = std::find_if(formats.begin(), formats.end(), [&](const Format<Model>& f) { return f.ending == ending; });
  return format == formats.end() ? nullptr : &*format;
}

FileContent surface_file(const WrittenModel& model, const std::filesystem::path& file, const std::vector<std::string>& endings) {
  if (const auto* format = format_of(file, surface_formats())) return {file, format->bytes(model)};
  throw UsageError(fmt::format("{}: the ending tells no model format", file.string()),
                   fmt::format("Use one of {}", fmt::join(endings, ", ")));
}

}  // namespace

const std::vector<std::string>& surface_endings() {
  static const std::vector<std::string> endings = endings_of(surface_formats());
  return endings;
}

const std::vector<std::string>& tetrahedra_endings() {
  static const std::vector<std::string> endings = endings_of(tetrahedra_formats());
  return endings;
}

const std::vector<std::string>& model_endings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> list = surface_endings();
    list.insert(list.end(), tetrahedra_endings().begin(), tetrahedra_endings().end());
    return list;
  }();
  return endings;
}

FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file) {
  if (const auto* format = format_of(file, tetrahedra_formats())) return {file, format->bytes(reconstruction)};
  return surface_file(reconstruction, file, model_endings());
}

FileContent model_file(const DbReconstruction& reconstruction, const std::filesystem::path& file) {
  if (const auto* format = format_of(file, tetrahedra_formats())) {
    throw UsageError(fmt::format("{}: {} holds tetrahedra, and marching cubes makes none, only a surface", file.string(), format->ending),
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
