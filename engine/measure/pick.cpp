#include "engine/measure/pick.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "engine/scene/turned_out.h"

namespace odontoscope {

namespace {

struct Plane {
  glm::dvec3 normal{0};
  double offset = 0;  // metres along the normal; beyond is cut away
};

std::optional<Plane> plane_of(const Scene& scene, const glm::dvec3& origin_mm) {
  if (!scene.section) return std::nullopt;
  const glm::dvec3 normal = glm::normalize(scene.section->normal);
  return Plane{normal, metres_per_mm * glm::dot(normal, scene.section->point_mm - origin_mm)};
}

/// Looks of the parts, and whether each can be hit.
struct Shown {
  bool hit = false, inside_out = false;
};

/// As caps are drawn: seen from the side that was cut away.
bool caps_face(const TreeRay& ray, const Plane& plane, const Scene& scene) {
  if (scene.camera.projection == Camera::Projection::parallel) return glm::dot(plane.normal, ray.direction) < 0;
  return glm::dot(plane.normal, ray.origin) > plane.offset;
}

std::vector<Shown> shown_parts(const Pickable& pickable, const Scene& scene, bool capped, const PickOptions& options) {
  std::vector<Shown> shown;
  for (const Pickable::Part& part : pickable.parts) {
    const Look* look = scene.look_of(part.structure);
    if (!look)
      shown.push_back({true, false});
    else
      shown.push_back({look->visible && look->opacity > 0 && look->opacity >= options.least_opacity,
                       turned_out(scene, *look, part.structure != part.solid, capped)});
  }
  return shown;
}

struct Cap {
  std::size_t part = 0;
  double distance = 0;
};

/// The cap that the ray meets, if it meets the plane from the side that was cut away. How often each solid goes round
/// the point of the plane is counted as CapPass does it: backs minus fronts behind the point.
std::optional<Cap> cap_along(const Pickable& pickable, const Plane& plane, const TreeRay& ray,
                             const std::vector<Shown>& shown) {
  const double slope = glm::dot(plane.normal, ray.direction);
  if (!(slope < 0)) return std::nullopt;
  const double distance = (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
  if (!(distance >= 0)) return std::nullopt;
  std::map<std::string, int> around;
  TreeRay behind = ray;
  behind.from = distance;
  pickable.tree.each(behind, [&](const Crossing& crossing) {
    around[pickable.parts[crossing.part].solid] += crossing.front ? -1 : 1;
  });
  std::optional<Cap> cap;
  for (std::size_t p = 0; p < pickable.parts.size(); ++p) {
    const Pickable::Part& part = pickable.parts[p];
    const auto found = around.find(part.structure);  // a solid is called after its outer surface
    if (part.structure != part.solid || !shown[p].hit || found == around.end() || found->second == 0) continue;
    if (!cap || part.box_volume <= pickable.parts[cap->part].box_volume) cap = Cap{p, distance};
  }
  return cap;
}

double box_volume(const ModelPart& part) {
  if (part.positions.empty()) return 0;
  glm::dvec3 low(part.positions.front()), high = low;
  for (const glm::vec3& position : part.positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 size = high - low;
  return size.x * size.y * size.z;
}

}  // namespace

Ray ray_through(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& size) {
  const glm::dvec3 view_direction = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(view_direction, camera.up));
  const glm::dvec3 up = glm::cross(right, view_direction);
  const double x = (2 * pixel.x / size.x - 1) * size.x / size.y, y = 1 - 2 * pixel.y / size.y;
  if (camera.projection == Camera::Projection::parallel)
    return {camera.position + 0.5 * camera.height_mm * (x * right + y * up), view_direction};
  const double slope = std::tan(glm::radians(camera.field_of_view_deg) / 2);
  return {camera.position, glm::normalize(view_direction + slope * (x * right + y * up))};
}

Pickable::Pickable(const Model& model, const Progress& progress) : tree(model, progress), origin_mm(model.origin_mm) {
  for (const ModelPart& part : model.parts) parts.push_back({part.structure, part.solid, box_volume(part)});
}

std::optional<Hit> pick(const Pickable& pickable, const Scene& scene, const Ray& ray, const PickOptions& options) {
  TreeRay along{metres_per_mm * (ray.origin_mm - pickable.origin_mm), ray.direction};
  // A parallel camera sees what lies behind its own place, too.
  if (scene.camera.projection == Camera::Projection::parallel) along.from = -std::numeric_limits<double>::infinity();
  const std::optional<Plane> plane = plane_of(scene, pickable.origin_mm);
  const std::vector<Shown> shown = shown_parts(pickable, scene, plane && caps_face(along, *plane, scene), options);
  const auto is_front = [&](const Crossing& crossing) { return crossing.front != shown[crossing.part].inside_out; };
  const auto counts = [&](const Crossing& crossing) {
    if (!shown[crossing.part].hit) return false;
    if (scene.back_faces == BackFaces::cull && !is_front(crossing)) return false;
    return !plane || glm::dot(plane->normal, along.origin + crossing.distance * along.direction) <= plane->offset;
  };
  const std::optional<Crossing> surface = pickable.tree.nearest(along, counts);
  const std::optional<Cap> cap = plane ? cap_along(pickable, *plane, along, shown) : std::nullopt;
  if (!surface && !cap) return std::nullopt;

  Hit hit;
  const bool on_cap = cap && (!surface || cap->distance <= surface->distance);
  const double distance = on_cap ? cap->distance : surface->distance;
  hit.part = on_cap ? cap->part : surface->part;
  hit.structure = pickable.parts[hit.part].structure;
  hit.point_mm = pickable.origin_mm + (along.origin + distance * along.direction) / metres_per_mm;
  hit.distance_mm = distance / metres_per_mm;
  if (on_cap) {
    hit.normal = plane->normal;
    return hit;
  }
  hit.triangle = surface->triangle;
  hit.front = is_front(*surface);
  hit.normal = pickable.tree.normal(surface->part, surface->triangle);
  if (glm::dot(hit.normal, ray.direction) > 0) hit.normal = -hit.normal;
  return hit;
}

}  // namespace odontoscope
