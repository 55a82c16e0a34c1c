#include "recon/cavity/wall_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t leaf_size = 4;

double along(const Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

inline double square_distance(const Point3& p, const Point3& low, const Point3& high) {
  const double x = std::max(std::max(low.x - p.x, p.x - high.x), 0.0), y = std::max(std::max(low.y - p.y, p.y - high.y), 0.0),
               z = std::max(std::max(low.z - p.z, p.z - high.z), 0.0);
  return x * x + y * y + z * z;
}

/// Barycentric coordinates of the nearest point of a triangle: s towards b, t towards c. Which feature it lies on: 0 to 2 a corner, 3 to 5 the edge
/// from corner k - 3, 6 the inside. After C. Ericson, "Real-Time Collision Detection", 5.1.5.
struct OnTriangle {
  double s = 0, t = 0;
  int feature = 0;
};
inline OnTriangle nearest_on(const Direction& ab, const Direction& ac, const Direction& ap) {
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {0, 0, 0};
  const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const double d3 = d1 - bb, d4 = d2 - bc;
  if (d3 >= 0 && d4 <= d3) return {1, 0, 1};
  const double d5 = d1 - bc, d6 = d2 - cc;
  if (d6 >= 0 && d5 <= d6) return {0, 1, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0, 3};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6), 5};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - w, w, 4};
  }
  const double whole = 1 / (va + vb + vc);
  return {vb * whole, vc * whole, 6};
}

Direction unit(const Direction& v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : Direction{};
}

}  // namespace

WallTree::WallTree(const SurfaceMesh& wall) : triangles_(wall.triangles) {
  const std::size_t count = wall.triangles.size();
  std::vector<Direction> normals(count);
  vertex_normals_.resize(wall.points.size());
  std::vector<Point3> centres(count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::array corners = {wall.points[wall.triangles[t][0]], wall.points[wall.triangles[t][1]], wall.points[wall.triangles[t][2]]};
    normals[t] = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Direction u = unit(corners[(k + 1) % 3] - corners[k]), v = unit(corners[(k + 2) % 3] - corners[k]);
      Direction& sum = vertex_normals_[wall.triangles[t][k]];
      sum = sum + std::acos(std::clamp(dot(u, v), -1.0, 1.0)) * normals[t];
    }
    centres[t] = {(corners[0].x + corners[1].x + corners[2].x) / 3, (corners[0].y + corners[1].y + corners[2].y) / 3,
                  (corners[0].z + corners[1].z + corners[2].z) / 3};
  }
  const EdgeMates edges = edge_mates(wall);
  edge_normals_.resize(3 * count);
  for (std::size_t h = 0; h < 3 * count; ++h) {
    const HalfEdge mate = edges.mate[h];
    edge_normals_[h] = mate < 3 * count ? normals[h / 3] + normals[mate / 3] : normals[h / 3];
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(count);
  nodes_.emplace_back();
  divide(0, 0, static_cast<std::uint32_t>(count), centres, wall, order);
  faces_.reserve(count);
  for (const std::uint32_t t : order) {
    const Triangle& corners = wall.triangles[t];
    const Point3& a = wall.points[corners[0]];
    faces_.push_back({a, wall.points[corners[1]] - a, wall.points[corners[2]] - a, normals[t], t});
  }
}

void WallTree::divide(std::uint32_t node, std::uint32_t first, std::uint32_t count, const std::vector<Point3>& centres, const SurfaceMesh& wall,
                      std::vector<std::uint32_t>& order) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const PointIndex v : wall.triangles[order[i]]) {
      const Point3& p = wall.points[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  if (count <= leaf_size) {
    nodes_[node] = {low, high, first, count};
    return;
  }
  const Direction size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::nth_element(order.begin() + first, order.begin() + first + half, order.begin() + first + count, [&](std::uint32_t a, std::uint32_t b) {
    const double u = along(centres[a], axis), v = along(centres[b], axis);
    return u != v ? u < v : a < b;
  });
  const std::uint32_t left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {low, high, left, 0};
  nodes_.emplace_back();
  nodes_.emplace_back();
  divide(left, first, half, centres, wall, order);
  divide(left + 1, first + half, count - half, centres, wall, order);
}

/// Ends as soon as the wall is not farther than `enough`; looks no farther than `most`.
WallTree::Nearest WallTree::nearest(const Point3& from, double enough, double most) const {
  const double square_enough = enough * enough;
  struct Waiting {
    std::uint32_t node;
    double square;
  };
  std::array<Waiting, 64> stack;
  std::size_t waiting = 0;
  double best = most * most;
  const Face* face = nullptr;
  OnTriangle place;
  stack[waiting++] = {0, 0};
  while (waiting > 0 && best > square_enough) {
    const Waiting next_one = stack[--waiting];
    if (next_one.square >= best) continue;
    const Node& node = nodes_[next_one.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Face& here = faces_[i];
        const Direction ap = from - here.a;
        const OnTriangle on = nearest_on(here.ab, here.ac, ap);
        const double x = ap.x - on.s * here.ab.x - on.t * here.ac.x, y = ap.y - on.s * here.ab.y - on.t * here.ac.y,
                     z = ap.z - on.s * here.ab.z - on.t * here.ac.z;
        const double square = x * x + y * y + z * z;
        if (square < best) {
          best = square;
          face = &here;
          place = on;
        }
      }
      continue;
    }
    const double left = square_distance(from, nodes_[node.first].low, nodes_[node.first].high);
    const double right = square_distance(from, nodes_[node.first + 1].low, nodes_[node.first + 1].high);
    const bool left_first = left <= right;
    if (const double far = left_first ? right : left; far < best) stack[waiting++] = {node.first + (left_first ? 1 : 0), far};
    if (const double near = left_first ? left : right; near < best) stack[waiting++] = {node.first + (left_first ? 0 : 1), near};
  }
  Nearest found;
  if (face == nullptr) return found;
  found.distance = std::sqrt(best);
  found.triangle = face->number;
  const Direction on = place.s * face->ab + place.t * face->ac;
  found.at = {face->a.x + on.x, face->a.y + on.y, face->a.z + on.z};
  const std::size_t corner = static_cast<std::size_t>(place.feature % 3);
  const Direction& normal = place.feature == 6  ? face->normal
                            : place.feature < 3 ? vertex_normals_[triangles_[face->number][corner]]
                                                : edge_normals_[3 * face->number + corner];
  found.front = dot(from - found.at, normal) > 0;
  return found;
}

WallTree::Nearest WallTree::nearest(const Point3& from) const { return nearest(from, 0, std::numeric_limits<double>::infinity()); }

double WallTree::clearance_above(const Point3& from, double least, double most) const {
  constexpr double rounding = 1e-6;
  const Nearest found = nearest(from, least, (1 + rounding) * most);
  return found.distance > least && !found.front ? -found.distance : found.distance;
}

double WallTree::clearance(const Point3& from) const {
  const Nearest found = nearest(from);
  return found.front ? found.distance : -found.distance;
}

}  // namespace odontoscope
