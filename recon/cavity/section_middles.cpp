#include "recon/cavity/section_middles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/cavity/limits.h"
#include "recon/cavity/plane_loops.h"
#include "recon/cavity/tooth_axis.h"

namespace odontoscope::cavity {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Loop hull_of(Loop points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Loop hull;
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

struct Extent {
  double area = 0;
  Point2 centroid{};
};

Extent extent_of(const Loop& loop) {
  Extent made;
  if (loop.size() < 3) return made;
  double twice = 0, x = 0, y = 0;
  const Point2& origin = loop.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    const Point2 a{p.x - origin.x, p.y - origin.y}, b{q.x - origin.x, q.y - origin.y};
    const double cross = a.x * b.y - a.y * b.x;
    twice += cross;
    x += cross * (a.x + b.x);
    y += cross * (a.y + b.y);
  }
  if (!(std::abs(twice) > 0)) return made;
  return {std::abs(twice) / 2, {origin.x + x / (3 * twice), origin.y + y / (3 * twice)}};
}

SectionMiddle middle_at(const SurfaceMesh& wall, const Point3& at, const Direction& along, double ball) {
  const Upright upright(along);
  const Point3 place = upright.turned(at);
  const std::vector<Loop> loops = loops_at(upright.turned(wall), place.z);
  const Loop* own = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Loop& loop : loops) {
    const double area = extent_of(loop).area;
    if (area >= least || !is_inside(loop, {place.x, place.y})) continue;
    least = area;
    own = &loop;
  }
  if (own == nullptr) return {at, false, ball};
  const bool islands = std::any_of(loops.begin(), loops.end(),
                                   [&](const Loop& loop) { return &loop != own && is_inside(*own, loop.front()); });
  const Extent extent = extent_of(*own), hull = extent_of(hull_of(*own));
  const double round = limits::section_flatness * ball * ball;
  if (islands || extent.area < limits::section_solidity * hull.area || extent.area > round) return {at, false, ball};
  return {upright.back({extent.centroid.x, extent.centroid.y, place.z}), true, extent.area / (std::numbers::pi * ball)};
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
