#include "recon/delaunay/crossing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <set>

namespace odontoscope::delaunay {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Owned {
  std::size_t owner;
  Kernel::Triangle_3 triangle;
};
using TriangleBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Owned*>;

Kernel::Triangle_3 triangle(const std::array<Point3, 3>& t) {
  const auto point = [](const Point3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

struct Extent {
  double low_x = 0, low_y = 0, high_x = -1, high_y = -1;
  bool meets(const Extent& other) const {
    return low_x <= other.high_x && other.low_x <= high_x && low_y <= other.high_y && other.low_y <= high_y;
  }
};

Extent extent_of(const Boundary& boundary) {
  Extent e;
  if (boundary.empty()) return e;
  e = {boundary[0][0].x, boundary[0][0].y, boundary[0][0].x, boundary[0][0].y};
  for (const auto& t : boundary)
    for (const Point3& p : t) {
      e.low_x = std::min(e.low_x, p.x);
      e.low_y = std::min(e.low_y, p.y);
      e.high_x = std::max(e.high_x, p.x);
      e.high_y = std::max(e.high_y, p.y);
    }
  return e;
}

std::vector<TriangleBox> boxes_of(const std::vector<Owned>& triangles) {
  std::vector<TriangleBox> boxes;
  boxes.reserve(triangles.size());
  for (const Owned& owned : triangles) boxes.emplace_back(owned.triangle.bbox(), &owned);
  return boxes;
}

}  // namespace

bool crosses_any(const std::vector<Boundary>& boundaries, const Boundary& one) {
  const Extent extent = extent_of(one);
  std::vector<Owned> theirs, its;
  for (const Boundary& boundary : boundaries)
    if (extent.meets(extent_of(boundary)))
      for (const auto& t : boundary) theirs.push_back({0, triangle(t)});
  if (theirs.empty()) return false;
  for (const auto& t : one) its.push_back({1, triangle(t)});
  std::vector<TriangleBox> a = boxes_of(theirs), b = boxes_of(its);
  bool found = false;
  CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                           [&found](const TriangleBox& x, const TriangleBox& y) {
                             found = found || CGAL::do_intersect(x.handle()->triangle, y.handle()->triangle);
                           });
  return found;
}

std::vector<std::pair<std::size_t, std::size_t>> crossing_pairs(const std::vector<Boundary>& boundaries) {
  std::vector<Extent> extents;
  for (const Boundary& boundary : boundaries) extents.push_back(extent_of(boundary));
  std::vector<bool> involved(boundaries.size(), false);
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    for (std::size_t j = i + 1; j < boundaries.size(); ++j)
      if (extents[i].meets(extents[j])) involved[i] = involved[j] = true;

  std::vector<Owned> triangles;
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    if (involved[i])
      for (const auto& t : boundaries[i]) triangles.push_back({i, triangle(t)});
  std::vector<TriangleBox> boxes = boxes_of(triangles);
  std::set<std::pair<std::size_t, std::size_t>> found;
  const auto test = [&found](const TriangleBox& a, const TriangleBox& b) {
    const std::size_t i = a.handle()->owner, j = b.handle()->owner;
    const std::pair pair{std::min(i, j), std::max(i, j)};
    if (i == j || found.count(pair) != 0) return;
    if (CGAL::do_intersect(a.handle()->triangle, b.handle()->triangle)) found.insert(pair);
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), test);
  return {found.begin(), found.end()};
}

}  // namespace odontoscope::delaunay
