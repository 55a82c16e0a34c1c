#include "engine/viewer/names/canals.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/navigate/ride.h"
#include "recon/core/lower_case.h"

namespace odontoscope {

double canal_slack_mm(const Camera& camera, const Area& area, float scale) {
  constexpr double slack_pixels = 5;
  const double depth = std::max(depth_of(camera, camera.target), 1e-6);
  return slack_pixels * scale * 2 * half_height_at(camera, depth) / std::max(area.height, 1.0);
}

SightLine from_before(SightLine sight, const Camera& camera, const Model& model) {
  if (camera.projection == Camera::Projection::parallel)
    sight.origin -= (glm::length(sight.origin - model.bounds_mm.centre()) + 2 * model.radius_mm) * sight.direction;
  return sight;
}

std::string name_of(const CanalPick& pick, const FlightSpaces& spaces) {
  return pick.in_chamber ? "pulp chamber" : rideable(spaces.cavities[pick.cavity].lines)[pick.line]->name;
}

std::string pulp_of(const LoadedModel& shown, std::size_t cavity) {
  const auto pulp = std::find_if(shown.model.parts.begin(), shown.model.parts.end(), [](const ModelPart& part) {
    return !part.cavity && lower_case(part.structure).find("pulp") != std::string::npos;
  });
  return pulp != shown.model.parts.end() ? pulp->structure : shown.flight->cavities[cavity].structure;
}

}  // namespace odontoscope
