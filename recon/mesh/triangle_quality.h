#pragma once
// The shape of a triangle in numbers, in doubles.

#include <array>
#include <cmath>

#include "recon/mesh/nearest_on_triangle.h"
#include "recon/mesh/vector.h"

namespace odontoscope {

using Corners = std::array<Point3, 3>;

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
