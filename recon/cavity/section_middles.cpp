#include "recon/cavity/section_middles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/cavity/limits.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/polygon.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope::cavity {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Polygon hull_of(Polygon points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Polygon hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();  // the other side begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

SectionMiddle middle_at(const SurfaceMesh& wall, const Point3& at, const Direction& along, double ball) {
  const Upright upright(along);
  const Point3 place = upright.turned(at);
  const std::vector<Polygon> loops = section_loops(upright.turned(wall), place.z);
  const Polygon* own = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Polygon& loop : loops) {
    const double area = std::abs(signed_area(loop));
    if (area >= least || !encloses(loop, {place.x, place.y})) continue;
    least = area;
    own = &loop;
  }
  if (own == nullptr) return {at, false, ball};
  const bool islands = std::any_of(loops.begin(), loops.end(),
                                   [&](const Polygon& loop) { return &loop != own && encloses(*own, loop.front()); });
  const double hull = std::abs(signed_area(hull_of(*own))), round = limits::section_flatness * ball * ball;
  if (islands || least < limits::section_solidity * hull || least > round) return {at, false, ball};
  const Point2 middle = centroid(*own);
  return {upright.back({middle.x, middle.y, place.z}), true, least / (std::numbers::pi * ball)};
}

}  // namespace

std::vector<SectionMiddle> section_middles(const SurfaceMesh& wall, const CentreLine& line, std::size_t first,
                                           std::size_t last) {
  // Over the way of a radius to both sides: the line's own waves would turn the plane.
  const auto direction = [&](std::size_t i) {
    const double reach = line.points[i].ball;
    std::size_t from = i, to = i;
    while (from > 0 && line.points[i].along - line.points[from].along < reach) --from;
    while (to + 1 < line.points.size() && line.points[to].along - line.points[i].along < reach) ++to;
    return line.points[to].at - line.points[from].at;
  };
  std::vector<SectionMiddle> made;
  for (std::size_t i = first; i < last; ++i)
    made.push_back(middle_at(wall, line.points[i].at, direction(i), line.points[i].ball));
  return made;
}

}  // namespace odontoscope::cavity
