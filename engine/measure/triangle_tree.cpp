#include "engine/measure/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/scene/glm_vector.h"
#include "recon/mesh/nearest_on_triangle.h"

namespace odontoscope {

namespace {

/// Boxes are widened by this part of the distance, so that rounding in the slab test never misses a triangle.
constexpr double box_slack = 1e-12;

double sheared_area(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

/// The ray's axes permuted so that z is its longest, and sheared so that it runs along z.
class Shear {
 public:
  explicit Shear(const TreeRay& ray) : origin_(ray.origin) {
    const glm::dvec3 size = glm::abs(ray.direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (x_ + 1) % 3;
    if (ray.direction[z_] < 0) std::swap(x_, y_);
    scale_ = 1 / ray.direction[z_];
    slope_x_ = ray.direction[x_] * scale_;
    slope_y_ = ray.direction[y_] * scale_;
  }

  glm::dvec3 operator()(const glm::vec3& place) const {
    const glm::dvec3 p = glm::dvec3(place) - origin_;
    return {p[x_] - slope_x_ * p[z_], p[y_] - slope_y_ * p[z_], scale_ * p[z_]};
  }

 private:
  glm::dvec3 origin_;
  int x_, y_, z_;
  double slope_x_, slope_y_, scale_;
};

struct Passage {
  double distance;
  bool front;
};

/// Does a triangle own its edge from `p` to `q`, its own side to the left? Of two neighbours that lie on different
/// sides of the edge one does, of two that lie on the same side (a silhouette) both or neither: the rule of
/// rasterisers.
bool owns(const glm::dvec3& p, const glm::dvec3& q) { return q.y != p.y ? q.y > p.y : q.x > p.x; }

/// Front: counter-clockwise as the ray comes. `edges_count`: all of the triangle's edges do, so that neighbours leave
/// no gap; otherwise only those that it owns, so that a closed surface is passed exactly as often in as out.
std::optional<Passage> passage(const Shear& shear, const std::array<glm::vec3, 3>& corners, bool edges_count) {
  const glm::dvec3 a = shear(corners[0]), b = shear(corners[1]), c = shear(corners[2]);
  const double u = sheared_area(c, b), v = sheared_area(a, c), w = sheared_area(b, a);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double sum = u + v + w;
  if (sum == 0) return std::nullopt;
  const auto counts = [&](double area, const glm::dvec3& p, const glm::dvec3& q) {
    return edges_count || area != 0 || (sum > 0 ? owns(p, q) : owns(q, p));
  };
  if (!counts(u, b, c) || !counts(v, c, a) || !counts(w, a, b)) return std::nullopt;
  return Passage{(u * a.z + v * b.z + w * c.z) / sum, sum > 0};
}

bool meets(const glm::vec3& low, const glm::vec3& high, const TreeRay& ray, const glm::dvec3& inverse, double to) {
  double enter = ray.from, leave = to;
  for (int axis = 0; axis < 3; ++axis) {
    double near = (low[axis] - ray.origin[axis]) * inverse[axis], far = (high[axis] - ray.origin[axis]) * inverse[axis];
    if (near > far) std::swap(near, far);
    // A ray within a box's face gives 0 * infinity; a comparison with NaN leaves the bound as it was.
    if (near > enter) enter = near;
    if (far < leave) leave = far;
  }
  return enter <= leave + box_slack * (std::abs(enter) + std::abs(leave));
}

}  // namespace

TriangleTree::TriangleTree(const Model& model, const Progress& progress) {
  std::vector<Corners> corners;
  for (std::uint32_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    place_of_.emplace_back(part.indices.size() / 3);
    for (std::uint32_t t = 0; t < part.indices.size() / 3; ++t) {
      const std::uint32_t a = part.indices[3 * t], b = part.indices[3 * t + 1], c = part.indices[3 * t + 2];
      corners.push_back({{part.positions[a], part.positions[b], part.positions[c]},
                         {part.normals[a], part.normals[b], part.normals[c]},
                         p,
                         t});
    }
  }
  if (corners.empty()) return;
  progress.tell("prepare picking", 0);
  std::vector<BoxTree<glm::vec3>::Bounds> bounds;
  bounds.reserve(corners.size());
  for (const auto& [at, normals, part, triangle] : corners)
    bounds.push_back({glm::min(glm::min(at[0], at[1]), at[2]), glm::max(glm::max(at[0], at[1]), at[2])});
  tree_ = BoxTree<glm::vec3>(bounds, [&](std::uint32_t) { progress.check(); });
  triangles_.reserve(corners.size());
  for (const std::uint32_t i : tree_.order()) {
    place_of_[corners[i].part][corners[i].triangle] = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(corners[i]);
  }
  progress.tell("prepare picking", 1);
}

template <class Visit>
void TriangleTree::walk(const TreeRay& ray, Edges edges, Visit visit) const {
  const Shear shear(ray);
  const glm::dvec3 inverse = 1.0 / ray.direction;
  double to = ray.to;
  tree_.along(
      ray.direction, [&](const glm::vec3& low, const glm::vec3& high) { return meets(low, high, ray, inverse, to); },
      [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
          const auto passed = passage(shear, triangles_[i].at, edges == Edges::count);
          if (passed && passed->distance >= ray.from && passed->distance <= to)
            to = visit(Crossing{triangles_[i].part, triangles_[i].triangle, passed->distance, passed->front}, to);
        }
        return true;
      });
}

std::optional<Crossing> TriangleTree::nearest(const TreeRay& ray,
                                              const std::function<bool(const Crossing&)>& counts) const {
  std::optional<Crossing> found;
  walk(ray, Edges::count, [&](const Crossing& crossing, double to) {
    const bool nearer = !found || crossing.distance < found->distance ||
                        (crossing.distance == found->distance &&
                         std::pair(crossing.part, crossing.triangle) < std::pair(found->part, found->triangle));
    if (!nearer || !counts(crossing)) return to;
    found = crossing;
    return crossing.distance;
  });
  return found;
}

void TriangleTree::each(const TreeRay& ray, const std::function<void(const Crossing&)>& visit) const {
  walk(ray, Edges::pass, [&](const Crossing& crossing, double to) {
    visit(crossing);
    return to;
  });
}

std::optional<NearestPoint> TriangleTree::nearest_point(const glm::dvec3& place,
                                                        const std::function<bool(std::uint32_t)>& counts,
                                                        double most) const {
  std::optional<NearestPoint> found;
  double least = most * most;
  tree_.nearest_first(place, least, 0, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t i = first; i < end; ++i) {
      const Corners& triangle = triangles_[i];
      if (!counts(triangle.part)) continue;
      const glm::dvec3 a(triangle.at[0]), u = glm::dvec3(triangle.at[1]) - a, v = glm::dvec3(triangle.at[2]) - a;
      const OnTriangle on = nearest_on_triangle(direction(u), direction(v), direction(place - a));
      const glm::dvec3 point = a + on.s * u + on.t * v;
      const double squared = glm::dot(point - place, point - place);
      if (squared >= least) continue;
      least = squared;
      found = NearestPoint{triangle.part, triangle.triangle, point, std::sqrt(squared)};
    }
  });
  return found;
}

glm::dvec3 TriangleTree::normal(std::uint32_t part, std::uint32_t triangle) const {
  const auto& at = triangles_[place_of_[part][triangle]].at;
  const glm::dvec3 a(at[0]);
  const glm::dvec3 across = glm::cross(glm::dvec3(at[1]) - a, glm::dvec3(at[2]) - a);
  const double size = glm::length(across);
  return size > 0 ? across / size : glm::dvec3(0);
}

glm::dvec3 TriangleTree::smooth_normal(std::uint32_t part, std::uint32_t triangle, const glm::dvec3& place) const {
  const glm::dvec3 flat = normal(part, triangle);
  const Corners& corners = triangles_[place_of_[part][triangle]];
  glm::dvec3 sum(0);
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 p(corners.at[(k + 1) % 3]), q(corners.at[(k + 2) % 3]);
    sum += glm::dot(glm::cross(q - p, place - p), flat) * glm::dvec3(corners.normals[k]);
  }
  const double size = glm::length(sum);
  return size > 0 ? sum / size : flat;
}

}  // namespace odontoscope
