#include "recon/output/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/formats/write_glb.h"
#include "recon/formats/write_obj.h"
#include "recon/formats/write_ply.h"
#include "recon/formats/write_stl.h"
#include "recon/output/write_3mf.h"
#include "recon/output/write_inp.h"
#include "recon/output/write_msh.h"
#include "recon/output/write_vrml.h"
#include "recon/output/write_vtp.h"
#include "recon/output/write_vtu.h"

namespace odontoscope {
namespace {

/// Formats of surfaces, and of tetrahedra for reconstructions that have them.
template <class... What>
struct Format {
  std::string ending;
  std::string (*bytes)(const What&...);
};
using SurfaceFormat = Format<WrittenModel, GlbOptions>;
using TetrahedraFormat = Format<Reconstruction>;

/// A writer that has no options.
template <std::string (*write)(const WrittenModel&)>
std::string plain(const WrittenModel& model, const GlbOptions&) {
  return write(model);
}

const std::vector<SurfaceFormat>& surface_formats() {
  static const std::vector<SurfaceFormat> all{
      {".glb", glb_bytes},       {".stl", plain<stl_bytes>}, {".ply", plain<ply_bytes>},
      {".gltf", gltf_text},      {".obj", plain<obj_text>},  {".wrl", plain<vrml_text>},
      {".x3d", plain<x3d_text>}, {".vtp", plain<vtp_bytes>}, {".3mf", plain<threemf_bytes>}};
  return all;
}
const std::vector<TetrahedraFormat>& tetrahedra_formats() {
  static const std::vector<TetrahedraFormat> all{{".vtu", vtu_bytes}, {".msh", msh_text}, {".inp", inp_text}};
  return all;
}

template <class AFormat>
std::vector<std::string> endings_of(const std::vector<AFormat>& formats) {
  std::vector<std::string> endings;
  for (const AFormat& format : formats) endings.push_back(format.ending);
  return endings;
}

std::string ending_of(const std::filesystem::path& file) { return lower_case(file.extension().string()); }

/// Null if the file's ending is that of no such format.
template <class AFormat>
const AFormat* format_of(const std::filesystem::path& file, const std::vector<AFormat>& formats) {
  const std::string ending = ending_of(file);
  const auto format =
      std::find_if(formats.begin(), formats.end(), [&](const AFormat& f) { return f.ending == ending; });
  return format == formats.end() ? nullptr : &*format;
}

FileContent surface_file(const WrittenModel& model, const std::filesystem::path& file,
                         const std::vector<std::string>& endings, const GlbOptions& glb) {
  if (const auto* format = format_of(file, surface_formats())) return {file, format->bytes(model, glb)};
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

FileContent model_file(const Reconstruction& reconstruction, const std::filesystem::path& file, const GlbOptions& glb) {
  if (const auto* format = format_of(file, tetrahedra_formats())) return {file, format->bytes(reconstruction)};
  return surface_file(reconstruction, file, model_endings(), glb);
}

FileContent model_file(const DbReconstruction& reconstruction, const std::filesystem::path& file,
                       const GlbOptions& glb) {
  if (const auto* format = format_of(file, tetrahedra_formats())) {
    throw UsageError(fmt::format("{}: {} holds tetrahedra, and marching cubes makes none, only a surface",
                                 file.string(), format->ending),
                     fmt::format("Use one of {}", fmt::join(surface_endings(), ", ")));
  }
  return surface_file(reconstruction, file, surface_endings(), glb);
}

void write_model(const Reconstruction& reconstruction, std::span<const std::filesystem::path> files) {
  std::vector<FileContent> contents;
  for (const auto& file : files) contents.push_back(model_file(reconstruction, file));
  write_files(contents);
}

}  // namespace odontoscope
