#include "recon/cavity/wall_tree.h"

#include <algorithm>
#include <cmath>

#include "recon/core/portable_math.h"
#include "recon/mesh/corners.h"
#include "recon/mesh/half_edges.h"
#include "recon/mesh/nearest_on_triangle.h"

namespace odontoscope {
namespace {

Direction unit(const Direction& v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : Direction{};
}

}  // namespace

WallTree::WallTree(const SurfaceMesh& wall) : triangles_(wall.triangles) {
  const std::size_t count = wall.triangles.size();
  std::vector<Direction> normals(count);
  vertex_normals_.resize(wall.points.size());
  std::vector<BoxTree<std::array<double, 3>>::Bounds> bounds(count);
  for (std::size_t t = 0; t < count; ++t) {
    const Corners corners = {wall.points[wall.triangles[t][0]], wall.points[wall.triangles[t][1]],
                             wall.points[wall.triangles[t][2]]};
    normals[t] = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Direction u = unit(corners[(k + 1) % 3] - corners[k]), v = unit(corners[(k + 2) % 3] - corners[k]);
      Direction& sum = vertex_normals_[wall.triangles[t][k]];
      sum = sum + portable::acos(std::clamp(dot(u, v), -1.0, 1.0)) * normals[t];
    }
    bounds[t] = box_round(corners);
  }
  const EdgeMates edges = edge_mates(wall);
  edge_normals_.resize(3 * count);
  for (std::size_t h = 0; h < 3 * count; ++h) {
    const HalfEdge mate = edges.mate[h];
    edge_normals_[h] = mate < 3 * count ? normals[h / 3] + normals[mate / 3] : normals[h / 3];
  }
  tree_ = BoxTree<std::array<double, 3>>(bounds);
  faces_.reserve(count);
  for (const std::uint32_t t : tree_.order()) {
    const Triangle& corners = wall.triangles[t];
    const Point3& a = wall.points[corners[0]];
    faces_.push_back({a, wall.points[corners[1]] - a, wall.points[corners[2]] - a, normals[t], t});
  }
}

/// Ends as soon as the wall is not farther than `enough`; looks no farther than `most`.
WallTree::Nearest WallTree::nearest(const Point3& from, double enough, double most) const {
  double best = most * most;
  const Face* face = nullptr;
  OnTriangle place;
  tree_.nearest_first(
      std::array{from.x, from.y, from.z}, best, enough * enough, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
          const Face& here = faces_[i];
          const Direction ap = from - here.a;
          const OnTriangle on = nearest_on_triangle(here.ab, here.ac, ap);
          const double x = ap.x - on.s * here.ab.x - on.t * here.ac.x, y = ap.y - on.s * here.ab.y - on.t * here.ac.y,
                       z = ap.z - on.s * here.ab.z - on.t * here.ac.z;
          const double square = x * x + y * y + z * z;
          if (square < best) {
            best = square;
            face = &here;
            place = on;
          }
        }
      });
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

WallTree::Nearest WallTree::nearest(const Point3& from) const {
  return nearest(from, 0, std::numeric_limits<double>::infinity());
}

double WallTree::clearance_above(const Point3& from, double least, double most) const {
  Point3 shown_by;
  return clearance_above(from, least, most, shown_by);
}

double WallTree::clearance_above(const Point3& from, double least, double most, Point3& shown_by) const {
  constexpr double rounding = 1e-6;
  const Nearest found = nearest(from, least, (1 + rounding) * most);
  if (std::isfinite(found.distance)) shown_by = found.at;
  return found.distance > least && !found.front ? -found.distance : found.distance;
}

double WallTree::clearance(const Point3& from) const {
  const Nearest found = nearest(from);
  return found.front ? found.distance : -found.distance;
}

}  // namespace odontoscope
