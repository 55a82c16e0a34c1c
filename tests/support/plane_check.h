#pragma once
// Are contours fit to be an input? Decided here with exact predicates and every pair of edges in turn, so that neither
// the generators nor the oracle lean on the library's own validation.

#include <string>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// +1 counter-clockwise, -1 clockwise, 0 degenerate; exact.
int turn(Point2 a, Point2 b, Point2 c);
/// Twice the signed area, exact sign.
int area_sign(const std::vector<Point2>& ring);
/// At least three points, all different, edges that meet only where neighbours share a point.
bool is_simple(const std::vector<Point2>& ring);
/// No point in common.
bool are_disjoint(const std::vector<Point2>& a, const std::vector<Point2>& b);
/// Strictly inside; `at` must not lie on the ring.
bool is_inside(const std::vector<Point2>& ring, Point2 at);
/// How many of the rings the ring `index` lies in; the rings must be simple and disjoint.
int depth_of(const std::vector<std::vector<Point2>>& rings, std::size_t index);
/// Empty if the stack keeps every rule of contour_stack.h, else the first breach in words.
std::string breach(const ContourStack& stack);

}  // namespace odontoscope::test
