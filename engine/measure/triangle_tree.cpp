#include "engine/measure/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace odontoscope {

namespace {

constexpr std::uint32_t most_in_leaf = 4;
/// A tree over 2^32 triangles that is halved each time is 32 deep; one more for each level that is open on both sides.
constexpr int deepest = 64;
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

/// Does a triangle own its edge from `p` to `q`, its own side to the left? Of two neighbours that lie on different sides of the
/// edge one does, of two that lie on the same side (a silhouette) both or neither: the rule of rasterisers.
bool owns(const glm::dvec3& p, const glm::dvec3& q) { return q.y != p.y ? q.y > p.y : q.x > p.x; }

/// Front: counter-clockwise as the ray comes. `edges_count`: all of the triangle's edges do, so that neighbours leave no gap;
/// otherwise only those that it owns, so that a closed surface is passed exactly as often in as out.
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

double squared_distance(const glm::vec3& low, const glm::vec3& high, const glm::dvec3& place) {
  const glm::dvec3 outside = glm::max(glm::max(glm::dvec3(low) - place, place - glm::dvec3(high)), glm::dvec3(0));
  return glm::dot(outside, outside);
}

glm::dvec3 nearest_on_edge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& place) {
  const glm::dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  return squared > 0 ? a + std::clamp(glm::dot(place - a, along) / squared, 0.0, 1.0) * along : a;
}

glm::dvec3 nearest_on_triangle(const std::array<glm::vec3, 3>& corners, const glm::dvec3& place) {
  const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double squared = glm::dot(normal, normal);
  const auto inside = [&](const glm::dvec3& p, const glm::dvec3& q) { return glm::dot(glm::cross(q - p, place - p), normal) >= 0; };
  if (squared > 0 && inside(a, b) && inside(b, c) && inside(c, a)) return place - (glm::dot(place - a, normal) / squared) * normal;
  const glm::dvec3 candidates[3] = {nearest_on_edge(a, b, place), nearest_on_edge(b, c, place), nearest_on_edge(c, a, place)};
  return *std::min_element(candidates, candidates + 3,
                           [&](const glm::dvec3& p, const glm::dvec3& q) { return glm::distance(p, place) < glm::distance(q, place); });
}

}  // namespace

TriangleTree::TriangleTree(const Model& model, const Progress& progress) {
  std::vector<Corners> corners;
  for (std::uint32_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    place_of_.emplace_back(part.indices.size() / 3);
    for (std::uint32_t t = 0; t < part.indices.size() / 3; ++t) {
      const std::uint32_t a = part.indices[3 * t], b = part.indices[3 * t + 1], c = part.indices[3 * t + 2];
      corners.push_back({{part.positions[a], part.positions[b], part.positions[c]}, {part.normals[a], part.normals[b], part.normals[c]}, p, t});
    }
  }
  if (corners.empty()) return;
  std::vector<glm::vec3> centres;
  std::vector<std::uint32_t> order;
  for (const Corners& c : corners) {
    order.push_back(static_cast<std::uint32_t>(centres.size()));
    centres.push_back((c.at[0] + c.at[1] + c.at[2]) / 3.0f);
  }
  progress.tell("prepare picking", 0);
  nodes_.reserve(corners.size());
  nodes_.emplace_back();
  struct Open {
    std::uint32_t node, first, count;
  };
  std::vector<Open> open = {{0, 0, static_cast<std::uint32_t>(order.size())}};
  std::uint32_t done = 0;
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    divide(next.node, next.first, next.count, order, centres, corners);
    if (nodes_[next.node].count != 0) {
      done += next.count;
      if (done % 4096 < next.count) progress.check();
      continue;
    }
    const std::uint32_t half = next.count / 2;
    open.push_back({nodes_[next.node].first, next.first, half});
    open.push_back({nodes_[next.node].first + 1, next.first + half, next.count - half});
  }
  triangles_.reserve(order.size());
  for (const std::uint32_t i : order) {
    place_of_[corners[i].part][corners[i].triangle] = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(corners[i]);
  }
  progress.tell("prepare picking", 1);
}

/// Boxes the triangles and halves them at the median of the axis along which their centres spread most.
void TriangleTree::divide(std::uint32_t node, std::uint32_t first, std::uint32_t count, std::vector<std::uint32_t>& order,
                          const std::vector<glm::vec3>& centres, const std::vector<Corners>& corners) {
  constexpr float huge = std::numeric_limits<float>::max();
  glm::vec3 low(huge), high(-huge), centre_low(huge), centre_high(-huge);
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const glm::vec3& corner : corners[order[i]].at) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    centre_low = glm::min(centre_low, centres[order[i]]);
    centre_high = glm::max(centre_high, centres[order[i]]);
  }
  nodes_[node] = {low, high, first, count};
  if (count <= most_in_leaf) return;
  const glm::vec3 size = centre_high - centre_low;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const auto begin = order.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
  });
  nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  nodes_.emplace_back();
  nodes_.emplace_back();
}

template <class Visit>
void TriangleTree::walk(const TreeRay& ray, bool edges_count, Visit visit) const {
  if (nodes_.empty()) return;
  const Shear shear(ray);
  const glm::dvec3 inverse = 1.0 / ray.direction;
  double to = ray.to;
  std::uint32_t open[deepest];
  int depth = 0;
  open[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[open[--depth]];
    if (!meets(node.low, node.high, ray, inverse, to)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const auto passed = passage(shear, triangles_[i].at, edges_count);
      if (passed && passed->distance >= ray.from && passed->distance <= to)
        to = visit(Crossing{triangles_[i].part, triangles_[i].triangle, passed->distance, passed->front}, to);
    }
    if (node.count != 0) continue;
    // The child whose box begins nearer goes on top.
    const Node &left = nodes_[node.first], &right = nodes_[node.first + 1];
    const glm::dvec3 apart = glm::dvec3(right.low + right.high) - glm::dvec3(left.low + left.high);
    const bool left_first = glm::dot(apart, ray.direction) > 0;
    open[depth++] = left_first ? node.first + 1 : node.first;
    open[depth++] = left_first ? node.first : node.first + 1;
  }
}

std::optional<Crossing> TriangleTree::nearest(const TreeRay& ray, const std::function<bool(const Crossing&)>& counts) const {
  std::optional<Crossing> found;
  walk(ray, true, [&](const Crossing& crossing, double to) {
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
  walk(ray, false, [&](const Crossing& crossing, double to) {
    visit(crossing);
    return to;
  });
}

std::optional<NearestPoint> TriangleTree::nearest_point(const glm::dvec3& place, const std::function<bool(std::uint32_t)>& counts,
                                                        double most) const {
  std::optional<NearestPoint> found;
  double least = most * most;
  if (nodes_.empty()) return found;
  std::uint32_t open[deepest];
  int depth = 0;
  open[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[open[--depth]];
    if (squared_distance(node.low, node.high, place) > least) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Corners& triangle = triangles_[i];
      if (!counts(triangle.part)) continue;
      const glm::dvec3 point = nearest_on_triangle(triangle.at, place);
      const double squared = glm::dot(point - place, point - place);
      if (squared >= least) continue;
      least = squared;
      found = NearestPoint{triangle.part, triangle.triangle, point, std::sqrt(squared)};
    }
    if (node.count != 0) continue;
    const auto to_child = [&](std::uint32_t child) { return squared_distance(nodes_[child].low, nodes_[child].high, place); };
    const bool left_first = to_child(node.first) <= to_child(node.first + 1);
    open[depth++] = left_first ? node.first + 1 : node.first;
    open[depth++] = left_first ? node.first : node.first + 1;
  }
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
