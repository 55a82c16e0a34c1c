#include "engine/scene/model.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/scene/glm_vector.h"
#include "engine/scene/normals.h"
#include "recon/core/error.h"
#include "recon/radiograph/tissue.h"

namespace odontoscope {

namespace {

constexpr double least_radius_mm = 1e-6;

Box bounds(const std::vector<NamedSurface>& surfaces) {
  Box box{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  for (const NamedSurface& named : surfaces)
    for (const Triangle& triangle : named.surface.triangles)
      for (const PointIndex index : triangle) {
        box.low = glm::min(box.low, vec(named.surface.points[index]));
        box.high = glm::max(box.high, vec(named.surface.points[index]));
      }
  return box;
}

double radius_around(const glm::dvec3& centre, const std::vector<NamedSurface>& surfaces) {
  double radius = least_radius_mm;
  for (const NamedSurface& named : surfaces)
    for (const Triangle& triangle : named.surface.triangles)
      for (const PointIndex index : triangle)
        radius = std::max(radius, glm::distance(centre, vec(named.surface.points[index])));
  return radius;
}

/// A vertex of the part is a point of the surface together with one of its normals.
ModelPart make_part(const NamedSurface& named, const glm::dvec3& origin_mm, double crease_deg) {
  ModelPart part;
  part.structure = named.structure;
  part.solid = named.solid.empty() ? named.structure : named.solid;
  part.cavity = named.cavity;
  if (const auto tissue = tissue_called(part.solid))
    part.attenuation = linear_attenuation(*tissue, effective_energy_kev(usual_kv));
  const std::vector<glm::vec3> normals = corner_normals(named.surface, crease_deg);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> first_of(named.surface.points.size(), none);  // vertex made last for a point
  std::vector<std::uint32_t> next;                                         // and the one before it
  part.indices.reserve(3 * named.surface.triangles.size());
  for (std::size_t corner = 0; corner < normals.size(); ++corner) {
    const PointIndex point = named.surface.triangles[corner / 3][corner % 3];
    std::uint32_t vertex = first_of[point];
    while (vertex != none && part.normals[vertex] != normals[corner]) vertex = next[vertex];
    if (vertex == none) {
      vertex = static_cast<std::uint32_t>(part.positions.size());
      part.positions.emplace_back(metres_per_mm * (vec(named.surface.points[point]) - origin_mm));
      part.normals.push_back(normals[corner]);
      next.push_back(first_of[point]);
      first_of[point] = vertex;
    }
    part.indices.push_back(vertex);
  }
  return part;
}

}  // namespace

Model make_model(const std::vector<NamedSurface>& surfaces, double crease_deg) {
  const bool empty = std::all_of(surfaces.begin(), surfaces.end(),
                                 [](const NamedSurface& named) { return named.surface.triangles.empty(); });
  if (empty)
    throw InputError("nothing-to-show", {}, "there is no triangle to show", "Give a model that has a surface.");
  Model model;
  model.bounds_mm = bounds(surfaces);
  model.origin_mm = model.bounds_mm.centre();
  model.radius_mm = radius_around(model.origin_mm, surfaces);
  for (const NamedSurface& named : surfaces) model.parts.push_back(make_part(named, model.origin_mm, crease_deg));
  return model;
}

}  // namespace odontoscope
