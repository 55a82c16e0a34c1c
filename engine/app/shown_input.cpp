#include "engine/app/shown_input.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/foreign_input.h"
#include "engine/app/plain_input.h"
#include "engine/app/shown_values.h"
#include "engine/app/sniff.h"
#include "engine/app/tell_volume.h"
#include "engine/scene/shells.h"
#include "recon/core/read_file.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/exchange/contour_file.h"
#include "recon/formats/given_slices.h"
#include "recon/formats/read_mesh.h"
#include "recon/input/stack_json.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::app {
namespace {

constexpr std::string_view external_suffix = " external", cavity_suffix = " cavity";

/// Surfaces, and what overlays need besides them.
struct Found {
  std::vector<NamedSurface> surfaces;
  OverlaySource overlays;
  std::optional<Proven> proven = {};
  std::shared_ptr<const ValueGrid> values = {};
  std::optional<std::size_t> slices = {};
  std::optional<GreyAnchors> greys = {};
  std::vector<IsoOf> isos = {};
  bool only_voxels = false;
};

Found found_in(const ValidStack& stack, const DtWords& dt, Session& session, const StackCheck& check) {
  if (check) check(stack);
  Reconstruction made = reconstructed(stack, dt, session);
  Found found;
  found.overlays.contours = stack;
  found.proven = proven_by(made);
  found.slices = made.counts.slices;
  for (Solid& solid : made.solids) {
    add_shells(solid.structure, solid.surface, solid.report, found.surfaces);
    found.overlays.solids.push_back({solid.structure, std::move(solid.tetrahedra)});
  }
  return found;
}

/// Of the volume only what lies around its contours is kept, before the reconstruction needs the memory.
Found found_in_volume(const std::string& file, const VolumeWords& words, const DtWords& dt, Session& session,
                      const StackCheck& check) {
  auto volume = std::make_unique<Volume>();
  std::optional<ReportVolume> facts;
  ContourStack stack = contours_told(file, understood(words), session, volume.get(), &facts);
  const Box bounds = bounds_of(stack);
  std::optional<GreyAnchors> greys;
  if (words.voxels) greys = grey_anchors(*volume);
  auto values =
      std::make_shared<const ValueGrid>(value_grid(*volume, words.voxels ? with_margin(bounds, *volume) : bounds));
  volume.reset();
  Found found = found_in(validate(std::move(stack), session.progress()), dt, session, check);
  found.values = std::move(values);
  found.greys = greys;
  for (const auto& [structure, iso] : facts->isos) found.isos.push_back({structure, iso});
  return found;
}

Found found_in_voxels(const std::string& file, const VolumeWords& words, const DtWords& dt, Session& session) {
  refuse_for_mesh(dt, file);
  VoxelsAlone voxels = voxels_alone(file, words, {}, session);
  Found found;
  found.greys = voxels.greys;
  found.only_voxels = true;
  found.values = std::move(voxels.values);
  found.surfaces.push_back({"volume", box_surface(voxels.dense)});
  return found;
}

/// A mesh without a name is called after its file. Our own files name a solid's outside "S external" and its cavities
/// "S cavity", OBJ with an underscore.
NamedSurface surface_of(NamedMesh mesh, const std::string& file) {
  std::string name = mesh.name.empty() ? std::filesystem::path(file).stem().string() : mesh.name;
  if (name.size() > cavity_suffix.size() && (name.ends_with(cavity_suffix) || name.ends_with("_cavity"))) {
    const std::string solid = name.substr(0, name.size() - cavity_suffix.size());
    return {solid + std::string(cavity_suffix), std::move(mesh.surface), solid, true};
  }
  if (name.size() > external_suffix.size() && (name.ends_with(external_suffix) || name.ends_with("_external")))
    name.resize(name.size() - external_suffix.size());
  return {name, std::move(mesh.surface), name};
}

Found found_in(std::vector<NamedMesh> meshes, const std::string& file) {
  Found found;
  for (NamedMesh& mesh : meshes) found.surfaces.push_back(surface_of(std::move(mesh), file));
  return found;
}

[[noreturn]] void refuse(FileKind kind, const std::string& file) {
  if (kind == FileKind::volume)
    throw UsageError(fmt::format("{} is a volume, and nothing says where in it the surface lies", file),
                     "Give --iso T (or --iso auto) for an image, --label N for a label map");
  refuse_empty(file);
  Place place;
  place.file = file;
  throw InputError(
      "unknown-format", std::move(place),
      "this is no contour stack, no contour file of Reconstruct, CSL or RTSTRUCT, and no glTF, STL, PLY or OBJ mesh",
      "Give a file of one of these formats, or a volume with --iso");
}

Found found_in(const std::string& file, const VolumeWords& words, const DtWords& dt, Session& session,
               const StackCheck& check) {
  if (file.empty()) return found_in(validate(sample_tooth(ToothKind::molar), session.progress()), dt, session, check);
  if (words.any_level()) return found_in_volume(file, words, dt, session, check);
  if (words.voxels && looks_like_a_volume(file)) return found_in_voxels(file, words, dt, session);
  if (looks_like_a_volume(file)) refuse(FileKind::volume, file);
  const std::string bytes = read_file(file, limits::file_bytes, session.progress().stop);
  if (contour_file_kind(bytes)) return found_in(converted_told(file, {}, session), dt, session, check);
  const FileKind kind = kind_of(bytes, file);
  if (kind == FileKind::contour_stack)
    return found_in(validate(parse_stack(bytes, file), session.progress()), dt, session, check);
  if (auto meshes = meshes_in(kind, bytes, file)) {
    refuse_for_mesh(dt, file);
    for (const NamedMesh& mesh : *meshes) {
      for (const std::string& remark : mesh.remarks) session.console.say(fmt::format("{}: {}", file, remark));
    }
    Found found = found_in(std::move(*meshes), file);
    if (kind == FileKind::glb || kind == FileKind::gltf) found.slices = slices_given(bytes, file);
    return found;
  }
  refuse(kind, file);
}

}  // namespace

Shown shown_from(const std::string& file, const VolumeWords& words, const DtWords& dt, Session& session,
                 const StackCheck& check) {
  Found found = found_in(file, words, dt, session, check);
  session.progress().check();
  session.progress().tell("shade", 0.2);
  Shown shown{odontoscope::make_model(found.surfaces),
              std::move(found.overlays),
              std::move(found.surfaces),
              std::move(found.values),
              found.greys,
              std::move(found.isos),
              found.only_voxels,
              std::move(found.proven),
              found.slices};
  shown.overlays.faulty_edges = faulty_edges(shown.surfaces, shown.model);
  return shown;
}

}  // namespace odontoscope::app
