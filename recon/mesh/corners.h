#pragma once
// A triangle as three places, in doubles: its box, its middle, its shape in numbers.

#include <algorithm>
#include <array>
#include <cmath>

#include "recon/mesh/box_tree.h"
#include "recon/mesh/nearest_on_triangle.h"
#include "recon/mesh/vector.h"

namespace odontoscope {

using Corners = std::array<Point3, 3>;

inline BoxTree<std::array<double, 3>>::Bounds box_round(const Corners& t) {
  const auto [low_x, high_x] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [low_y, high_y] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto [low_z, high_z] = std::minmax({t[0].z, t[1].z, t[2].z});
  return {{low_x, low_y, low_z}, {high_x, high_y, high_z}};
}

inline Point3 middle_of(const Corners& t) {
  return {(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3, (t[0].z + t[1].z + t[2].z) / 3};
}

/// Twice the area long.
inline Direction normal_of(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// 1 if equilateral, 0 if flat: the area over the sum of the squared edges, scaled.
inline double quality_of(const Corners& t) {
  const Direction ab = t[1] - t[0], bc = t[2] - t[1], ca = t[0] - t[2];
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? 2 * std::sqrt(3.0) * length(normal_of(t)) / squares : 0;
}

inline double distance_to(const Corners& t, const Point3& from) {
  const Direction ab = t[1] - t[0], ac = t[2] - t[0], ap = from - t[0];
  const OnTriangle on = nearest_on_triangle(ab, ac, ap);
  return length(ap + -on.s * ab + -on.t * ac);
}

}  // namespace odontoscope
