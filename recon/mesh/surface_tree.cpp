#include "recon/mesh/surface_tree.h"

namespace odontoscope {
namespace {

std::vector<Corners> places_of_triangles(const SurfaceMesh& surface) {
  std::vector<Corners> triangles;
  triangles.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles)
    triangles.push_back({surface.points[a], surface.points[b], surface.points[c]});
  return triangles;
}

}  // namespace

SurfaceTree::SurfaceTree(const std::vector<Corners>& triangles) {
  std::vector<Boxes::Bounds> bounds;
  bounds.reserve(triangles.size());
  for (const Corners& t : triangles) bounds.push_back(box_round(t));
  boxes_ = Boxes(bounds);
  triangles_.reserve(triangles.size());
  for (const std::uint32_t t : boxes_.order()) triangles_.push_back(triangles[t]);
}

SurfaceTree::SurfaceTree(const SurfaceMesh& surface) : SurfaceTree(places_of_triangles(surface)) {}

SurfaceTree::Nearest SurfaceTree::nearest(const Point3& from, double most, double enough) const {
  Nearest best;
  double square = most;
  boxes_.nearest_first(std::array{from.x, from.y, from.z}, square, enough, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t i = first; i < end; ++i) {
      const Corners& t = triangles_[i];
      const Direction ab = t[1] - t[0], ac = t[2] - t[0], ap = from - t[0];
      const OnTriangle on = nearest_on_triangle(ab, ac, ap);
      const double x = ap.x - on.s * ab.x - on.t * ac.x, y = ap.y - on.s * ab.y - on.t * ac.y,
                   z = ap.z - on.s * ab.z - on.t * ac.z;
      if (const double here = x * x + y * y + z * z; here < square) {
        square = here;
        best = {here, {}, i, on};
      }
    }
  });
  if (!best.found()) return best;
  const Corners& t = triangles_[best.triangle];
  const Direction on = best.place.s * (t[1] - t[0]) + best.place.t * (t[2] - t[0]);
  best.at = {t[0].x + on.x, t[0].y + on.y, t[0].z + on.z};
  best.triangle = boxes_.order()[best.triangle];
  return best;
}

}  // namespace odontoscope
