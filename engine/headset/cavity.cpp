#include "engine/headset/cavity.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <optional>

namespace odontoscope {

namespace {

struct PartBox {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
};

PartBox box_of(const ModelPart& part) {
  PartBox box;
  for (const glm::vec3& position : part.positions) {
    box.low = glm::min(box.low, position);
    box.high = glm::max(box.high, position);
  }
  return box;
}

bool lies_within(const PartBox& inner, const PartBox& outer) {
  return glm::all(glm::greaterThan(inner.low, outer.low)) && glm::all(glm::lessThan(inner.high, outer.high));
}

SurfaceMesh surface_of(const ModelPart& part, const glm::dvec3& origin_mm) {
  SurfaceMesh surface;
  for (const glm::vec3& position : part.positions) {
    const glm::dvec3 mm = origin_mm + glm::dvec3(position) / metres_per_mm;
    surface.points.push_back({mm.x, mm.y, mm.z});
  }
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) surface.triangles.push_back({part.indices[i], part.indices[i + 1], part.indices[i + 2]});
  return surface;
}

std::optional<VisitedCavity> cavity_of(const ModelPart& part, const glm::dvec3& origin_mm) {
  VisitedCavity cavity{part.structure, !part.cavity, Walls(surface_of(part, origin_mm)), {}, 0};
  const std::optional<Roomiest> roomiest = roomiest_place(cavity.walls);
  if (!roomiest) return std::nullopt;
  cavity.middle = roomiest->at;
  cavity.room_mm = roomiest->clearance;
  return cavity;
}

}  // namespace

std::vector<VisitedCavity> cavities_of(const Model& model) {
  std::vector<PartBox> boxes;
  for (const ModelPart& part : model.parts) boxes.push_back(box_of(part));
  std::vector<VisitedCavity> cavities;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const ModelPart& part = model.parts[i];
    const bool enclosed = std::any_of(boxes.begin(), boxes.end(), [&](const PartBox& outer) { return lies_within(boxes[i], outer); });
    if (part.indices.empty() || !(part.cavity || enclosed)) continue;
    if (std::optional<VisitedCavity> cavity = cavity_of(part, model.origin_mm)) cavities.push_back(std::move(*cavity));
  }
  std::stable_sort(cavities.begin(), cavities.end(), [](const VisitedCavity& a, const VisitedCavity& b) { return a.room_mm > b.room_mm; });
  return cavities;
}

Scene seen_from_inside(const Scene& scene, const Model& model, const VisitedCavity& cavity) {
  Scene inside = scene;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const std::string& structure = model.parts[i].structure;
    Look* look = inside.look_of(structure);
    if (!look) look = &inside.looks.emplace_back(Look{structure, usual_colour(structure, i)});
    look->visible = structure == cavity.structure;
    if (!look->visible) continue;
    look->as_body = cavity.filled;
    look->opacity = 1;
  }
  inside.section.reset();
  inside.overlays = {};
  return inside;
}

}  // namespace odontoscope
