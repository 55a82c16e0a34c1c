#include "recon/formats/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"
#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

Direction unit(const Direction& v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : Direction{};
}

std::vector<Direction> face_normals(const SurfaceMesh& surface) {
  std::vector<Direction> normals;
  normals.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const Point3& p = surface.points[a];
    normals.push_back(unit(cross(surface.points[b] - p, surface.points[c] - p)));
  }
  return normals;
}

double angle_at(const SurfaceMesh& surface, HalfEdge corner) {
  const Point3& p = surface.points[start(surface, corner)];
  const Direction u = surface.points[start(surface, next(corner))] - p;
  const Direction v = surface.points[start(surface, previous(corner))] - p;
  return portable::atan2(length(cross(u, v)), dot(u, v));
}

/// Corners of a vertex that can be reached from each other without crossing a crease have one root, the first of them.
std::vector<HalfEdge> joined_corners(const SurfaceMesh& surface, const std::vector<Direction>& normals,
                                     double crease_angle_deg) {
  const EdgeMates edges = edge_mates(surface);
  const double least_cosine = portable::cos(crease_angle_deg * std::numbers::pi / 180);
  UnionFind corners(edges.mate.size());
  for (HalfEdge h = 0; h < edges.mate.size(); ++h) {
    const HalfEdge m = edges.mate[h];
    if (m >= EdgeMates::no_edge || m < h) continue;
    if (start(surface, m) == start(surface, h)) continue;  // misoriented: the normals contradict each other
    if (dot(normals[h / 3], normals[m / 3]) < least_cosine) continue;
    corners.join(h, next(m));
    corners.join(next(h), m);
  }
  std::vector<HalfEdge> first(edges.mate.size());
  for (HalfEdge h = 0; h < first.size(); ++h) first[h] = corners.find(h);
  return first;
}

}  // namespace

ShadedVertices smooth_normals(const SurfaceMesh& surface, double crease_angle_deg) {
  const std::vector<Direction> normals = face_normals(surface);
  const std::vector<HalfEdge> joined = joined_corners(surface, normals, crease_angle_deg);
  constexpr PointIndex unnumbered = std::numeric_limits<PointIndex>::max();
  ShadedVertices shaded;
  shaded.triangles.resize(surface.triangles.size());
  std::vector<PointIndex> number(joined.size(), unnumbered);
  std::vector<HalfEdge> first_corner;
  for (HalfEdge h = 0; h < joined.size(); ++h) {
    PointIndex& vertex = number[joined[h]];
    if (vertex == unnumbered) {
      vertex = static_cast<PointIndex>(shaded.point.size());
      shaded.point.push_back(start(surface, h));
      shaded.normals.push_back({});
      first_corner.push_back(h);
    }
    shaded.triangles[h / 3][h % 3] = vertex;
    shaded.normals[vertex] = shaded.normals[vertex] + angle_at(surface, h) * normals[h / 3];
  }
  for (std::size_t v = 0; v < shaded.normals.size(); ++v) {
    Direction& normal = shaded.normals[v];
    normal = unit(normal);
    // Triangles that cancel each other, or have no area: any unit vector will do.
    if (!(dot(normal, normal) > 0)) normal = normals[first_corner[v] / 3];
    if (!(dot(normal, normal) > 0)) normal = {0, 0, 1};
  }
  return shaded;
}

}  // namespace odontoscope
