#include "recon/mesh/collapse_star.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <limits>

namespace odontoscope {
namespace {

using Triangle3 = ExactKernel::Triangle_3;
using Segment3 = ExactKernel::Segment_3;

}  // namespace

MovingBox box_of(const NumberedTriangle& triangle) {
  MovingBox box;
  for (const auto& p : triangle.corner) box.add(Point3{p.x(), p.y(), p.z()});
  return box;
}

NumberedTriangle CollapseStar::made(std::size_t t, const Point& placed) const {
  NumberedTriangle triangle = triangles[t];
  triangle.number[1] = one;
  triangle.corner[1] = placed;
  return triangle;
}

std::optional<CollapseRefusal> CollapseStar::refusal(const Point& placed, Turning turning) const {
  if (strays(placed)) return CollapseRefusal::far;
  if (turning == Turning::refused && turns(placed)) return CollapseRefusal::turned;
  if (flattens(placed)) return CollapseRefusal::flat;
  if (cuts_itself(placed)) return CollapseRefusal::cuts;
  return std::nullopt;
}

bool CollapseStar::strays(const Point& placed) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  const double allowed = CGAL::squared_distance(one_at, other_at);
  double placed_off = CGAL::squared_distance(placed, Segment3(one_at, other_at)), one_off = far, other_off = far;
  for (const NumberedTriangle& t : triangles) {
    const auto& [before, moved, after] = t.corner;
    if (placed_off > allowed)
      placed_off = std::min(placed_off, CGAL::squared_distance(placed, Triangle3(before, moved, after)));
    const Triangle3 made(before, placed, after);
    if (made.is_degenerate()) continue;
    if (one_off > allowed) one_off = std::min(one_off, CGAL::squared_distance(one_at, made));
    if (other_off > allowed) other_off = std::min(other_off, CGAL::squared_distance(other_at, made));
  }
  return !(std::max({placed_off, one_off, other_off}) <= allowed);
}

bool CollapseStar::turns(const Point& placed) const {
  return std::any_of(triangles.begin(), triangles.end(), [&](const NumberedTriangle& t) {
    const auto& [before, moved, after] = t.corner;
    const auto was = CGAL::cross_product(before - moved, after - moved);
    const auto is = CGAL::cross_product(before - placed, after - placed);
    return !(was * is > 0);
  });
}

bool CollapseStar::flattens(const Point& placed) const {
  return std::any_of(triangles.begin(), triangles.end(),
                     [&](const NumberedTriangle& t) { return CGAL::collinear(t.corner[0], placed, t.corner[2]); });
}

bool CollapseStar::cuts_itself(const Point& placed) const {
  for (std::size_t m = 0; m < triangles.size(); ++m) {
    const NumberedTriangle first = made(m, placed);
    for (std::size_t n = m + 1; n < triangles.size(); ++n)
      if (meet_elsewhere(first, made(n, placed))) return true;
  }
  return false;
}

}  // namespace odontoscope
