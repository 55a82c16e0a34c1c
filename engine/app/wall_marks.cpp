#include "engine/app/wall_marks.h"

#include <utility>

#include "engine/app/whole_structures.h"
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

void mark_wall_depths(odontoscope::Model& model, const std::vector<NamedSurface>& surfaces, const Progress& progress) {
  const std::vector<NamedMesh> whole = whole_structures(surfaces);
  const std::vector<Cavity> cavities = cavities_in(looked_at(whole));
  if (cavities.empty()) throw UsageError("--wall-depth: there is no void inside", what_a_void_takes);
  std::vector<std::pair<std::string, CentreLines>> lined;
  for (const Cavity& cavity : cavities)
    lined.emplace_back(wall_of(cavity, model).structure,
                       centre_lines(cavity, {tooth_axis(looked_at(whole)).along}, progress));
  std::vector<LinedWall> walls;
  for (const auto& [structure, lines] : lined) walls.push_back({&structure, &lines});
  odontoscope::mark_wall_depths(model, walls);
}

}  // namespace odontoscope::app
