#include "recon/cavity/wall_tree.h"

#include <algorithm>
#include <cmath>

#include "recon/core/portable_math.h"
#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

Direction unit(const Direction& v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : Direction{};
}

}  // namespace

WallTree::WallTree(const SurfaceMesh& wall)
    : tree_(wall), normals_(wall.triangles.size()), vertex_normals_(wall.points.size()), triangles_(wall.triangles) {
  const std::size_t count = wall.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const Corners corners = {wall.points[wall.triangles[t][0]], wall.points[wall.triangles[t][1]],
                             wall.points[wall.triangles[t][2]]};
    normals_[t] = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Direction u = unit(corners[(k + 1) % 3] - corners[k]), v = unit(corners[(k + 2) % 3] - corners[k]);
      Direction& sum = vertex_normals_[wall.triangles[t][k]];
      sum = sum + portable::acos(std::clamp(dot(u, v), -1.0, 1.0)) * normals_[t];
    }
  }
  const EdgeMates edges = edge_mates(wall);
  edge_normals_.resize(3 * count);
  for (std::size_t h = 0; h < 3 * count; ++h) {
    const HalfEdge mate = edges.mate[h];
    edge_normals_[h] = mate < 3 * count ? normals_[h / 3] + normals_[mate / 3] : normals_[h / 3];
  }
}

/// Ends as soon as the wall is not farther than `enough`; looks no farther than `most`.
WallTree::Nearest WallTree::nearest(const Point3& from, double enough, double most) const {
  const SurfaceTree::Nearest place = tree_.nearest(from, most * most, enough * enough);
  Nearest found;
  if (!place.found()) return found;
  found.distance = std::sqrt(place.square);
  found.triangle = place.triangle;
  found.at = place.at;
  const int feature = place.place.feature;
  const std::size_t corner = static_cast<std::size_t>(feature % 3);
  const Direction& normal = feature == 6  ? normals_[place.triangle]
                            : feature < 3 ? vertex_normals_[triangles_[place.triangle][corner]]
                                          : edge_normals_[3 * place.triangle + corner];
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
