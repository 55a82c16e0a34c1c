#include "engine/app/wall_marks.h"

#include <fmt/format.h>

#include <utility>

#include "engine/app/whole_structures.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"
#include "recon/cavity/centre_lines.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/error.h"

namespace odontoscope::app {

VoidWall wall_of(const Cavity& cavity, const odontoscope::Model& model) {
  const bool open = !cavity.mouths.empty();  // then the outer surface leads inside
  for (const ModelPart& part : model.parts)
    if (part.cavity != open && part.solid == cavity.structure) return {part.structure, false};
  return {cavity.structure, cavity.body};
}

void mark_walls(const Scene& scene, odontoscope::Model& model, const std::vector<NamedSurface>& surfaces,
                const Progress& progress) {
  if (!scene.wall_depth && !scene.wall_thickness) return;
  const char* const option = scene.wall_thickness ? "--wall-thickness" : "--wall-depth";
  const std::vector<NamedMesh> whole = whole_structures(surfaces);
  const std::vector<Cavity> cavities = cavities_in(looked_at(whole));
  if (cavities.empty()) throw UsageError(fmt::format("{}: there is no void inside", option), what_a_void_takes);
  std::vector<std::pair<std::string, CentreLines>> lined;
  for (const Cavity& cavity : cavities)
    lined.emplace_back(wall_of(cavity, model).structure,
                       centre_lines(cavity, {tooth_axis(looked_at(whole)).along}, progress));
  std::vector<LinedWall> walls;
  for (const auto& [structure, lines] : lined) walls.push_back({&structure, &lines});
  mark_wall_depths(model, walls);
  if (!scene.wall_thickness) return;
  mark_wall_thicknesses(model, progress);
  if (!tells_thickness(model))
    throw UsageError(
        "--wall-thickness: the void's wall has no outside to measure to",
        "Give the whole tooth: dentine with a cavity that is closed. A canal that is open at its end, and a "
        "pulp by itself, have none.");
}

}  // namespace odontoscope::app
