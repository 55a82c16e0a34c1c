#include "engine/navigate/labels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/navigate/ride.h"
#include "engine/navigate/screen.h"
#include "engine/scene/glm_vector.h"

namespace odontoscope {

namespace {}  // namespace

std::vector<FlightLabel> labels_inside(const FlightSpace& space) {
  std::vector<FlightLabel> labels;
  const auto lines = rideable(space.lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CentreLine& line = *lines[i];
    const bool canal = i < space.lines.canals.size();
    if (canal && line.orifice > 0)
      labels.push_back({vec(line.points[std::min(line.orifice, line.points.size() - 1)].at), line.name, i});
    labels.push_back({vec(line.points.back().at), canal ? "apex, " + line.name : line.name, i});
  }
  if (space.lines.has_chamber && !lines.empty())
    labels.push_back({vec(space.lines.chamber), "pulp chamber", std::nullopt});
  return labels;
}

std::vector<FlightLabel> labels_outside(const Model& model, const FlightSpaces& spaces) {
  std::vector<FlightLabel> labels;
  const AnatomicalFrame tooth;
  for (const ModelPart& part : model.parts) {
    if (part.cavity || part.positions.empty()) continue;
    std::vector<std::size_t> order(part.positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto towards_cheek = [&](std::size_t i) { return glm::dot(glm::dvec3(part.positions[i]), tooth.buccal); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return towards_cheek(a) > towards_cheek(b); });
    constexpr std::size_t tries = 150;
    const std::size_t stride = std::max<std::size_t>(1, order.size() / tries);
    for (std::size_t k = 0; k < order.size(); k += stride) {
      const glm::dvec3 at = model.origin_mm + glm::dvec3(part.positions[order[k]]) / metres_per_mm;
      if (!spaces.outdoors(at + 2 * spaces.rules.clearance * glm::dvec3(part.normals[order[k]])))
        continue;  // another structure covers it
      labels.push_back({at, part.structure, std::nullopt});
      break;
    }
  }
  return labels;
}

std::vector<SeenLabel> seen_labels(const std::vector<FlightLabel>& labels, const Camera& camera, double aspect,
                                   const Walls& walls, double slack) {
  std::vector<SeenLabel> seen;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto place = place_of(camera, labels[i].at);
    if (!place || std::abs(place->x) > aspect || std::abs(place->y) > 1) continue;
    const glm::dvec3 way = labels[i].at - camera.position;
    const double distance = glm::length(way);
    if (!(distance > slack)) continue;  // one is there
    if (walls.free_distance(camera.position, way / distance, distance) < distance - slack) continue;
    seen.push_back({i, *place, distance});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const SeenLabel& a, const SeenLabel& b) { return a.distance < b.distance; });
  return seen;
}

}  // namespace odontoscope
