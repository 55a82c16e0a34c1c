#pragma once
// The place of a triangle that is nearest to a point. In doubles: no decision that must be exact hangs on it.

#include <algorithm>

#include "recon/mesh/vector.h"

namespace odontoscope {

/// Barycentric coordinates of the nearest point of a triangle: s towards b, t towards c. Which feature it lies on: 0 to
/// 2 a corner, 3 to 5 the edge from corner k - 3, 6 the inside.
struct OnTriangle {
  double s = 0, t = 0;
  int feature = 0;
};

/// Of the three edges, and of `inside`, which rounding may have moved: for triangles as thin as needles, or without
/// area.
inline OnTriangle nearest_on_needle(const Direction& ab, const Direction& ac, const Direction& ap,
                                    const OnTriangle& inside) {
  const auto share = [](const Direction& from, const Direction& along) {
    const double square = dot(along, along);
    return square > 0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0.0;
  };
  const auto square_from = [&](const OnTriangle& on) {
    const Direction off = ap + -on.s * ab + -on.t * ac;
    return dot(off, off);
  };
  const double on_ab = share(ap, ab), on_ac = share(ap, ac), on_bc = share(ap + -1.0 * ab, ac + -1.0 * ab);
  OnTriangle best{on_ab, 0, 3};
  for (const OnTriangle& other : {OnTriangle{1 - on_bc, on_bc, 4}, OnTriangle{0, on_ac, 5}, inside})
    if (square_from(other) < square_from(best)) best = other;
  return best;
}

/// After C. Ericson, "Real-Time Collision Detection", 5.1.5. Also for triangles without area.
inline OnTriangle nearest_on_triangle(const Direction& ab, const Direction& ac, const Direction& ap) {
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {0, 0, 0};
  const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const double d3 = d1 - bb, d4 = d2 - bc;
  if (d3 >= 0 && d4 <= d3) return {1, 0, 1};
  const double d5 = d1 - bc, d6 = d2 - cc;
  if (d6 >= 0 && d5 <= d6) return {0, 1, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && bb > 0) return {d1 / (d1 - d3), 0, 3};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && cc > 0) return {0, d2 / (d2 - d6), 5};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - w, w, 4};
  }
  const double whole = 1 / (va + vb + vc);
  const OnTriangle inside{vb * whole, vc * whole, 6};
  constexpr double needle = 1e-6;
  if (va + vb + vc > needle * bb * cc) return inside;
  const bool is_on = inside.s >= 0 && inside.t >= 0 && inside.s + inside.t <= 1;  // false for NaN
  return nearest_on_needle(ab, ac, ap, is_on ? inside : OnTriangle{0, 0, 0});
}

}  // namespace odontoscope
