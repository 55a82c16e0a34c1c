#include "tests/ui/teeth.h"

#include <filesystem>
#include <map>

#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"
#include "engine/scene/shells.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::testing_support {

namespace {

LoadedModel loaded(const ContourStack& stack, const std::string& title) {
  const Reconstruction made = reconstruct(stack);
  std::vector<NamedSurface> surfaces;
  for (const Solid& solid : made.solids) add_shells(solid.structure, solid.surface, solid.report, surfaces);
  LoadedModel model;
  model.title = title;
  model.model = make_model(surfaces);
  model.overlays.contours = stack;
  FlightSpaces spaces = flight_spaces(surfaces, model.model);
  mark_wall_depths(model.model, spaces);
  mark_wall_thicknesses(model.model, spaces);
  model.flight = std::make_shared<const FlightSpaces>(std::move(spaces));
  model.pickable = std::make_shared<const Pickable>(model.model);
  model.scene = usual_scene(model.model, 1.2);
  model.certificate = {Certificate::Verdict::certified, "Certified: closed, manifold, facing outwards", {}};
  for (const NamedSurface& surface : surfaces) model.triangles += surface.surface.triangles.size();
  return model;
}

const std::filesystem::path& ct_file() {
  static const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  return file;
}

}  // namespace

LoadedModel sample_tooth_loaded(ToothKind kind) {
  static std::map<ToothKind, LoadedModel> made;
  auto known = made.find(kind);
  if (known == made.end())
    known = made.emplace(kind, loaded(sample_tooth(kind), std::string("Sample ") + name(kind))).first;
  return known->second;
}

bool ct_molar_there() { return !std::string(ODONTOSCOPE_DATA).empty() && std::filesystem::exists(ct_file()); }

LoadedModel ct_molar_loaded() {
  static const LoadedModel model =
      loaded(iso_contours(read_volume(ct_file().string()), {{120, "tooth"}}, {.min_area = 4}).stack, "CT molar");
  return model;
}

}  // namespace odontoscope::testing_support
