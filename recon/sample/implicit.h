#pragma once
// Small implicit functions and ways to join them: negative inside, first-order distances.

#include <algorithm>
#include <cmath>

#include "recon/core/geometry.h"
#include "recon/core/portable_math.h"

namespace odontoscope::sample {

/// A value that means "nothing here": larger than any tooth, mm.
inline constexpr double far_outside = 1e3;

/// Minimum with a fillet: differs from it only where the two are within `width` of each other.
inline double smooth_min(double a, double b, double width) {
  const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - overlap * overlap * width / 4;
}

inline double smooth_max(double a, double b, double width) { return -smooth_min(-a, -b, width); }

inline double smooth_step(double low, double high, double at) {
  const double t = std::clamp((at - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// First-order distance to |u/a|^n + |v/b|^n = 1; beyond `far` from its bounding box just a lower bound of about the
/// distance.
inline double superellipse(double u, double v, double a, double b, double n) {
  constexpr double far = 3;  // mm; more than any fillet's width
  const double outside = std::max(std::abs(u) - a, std::abs(v) - b);
  if (outside > far) return outside;
  const double p = std::abs(u) / a, q = std::abs(v) / b;
  const double pn = n == 2 ? p * p : portable::pow(p, n), qn = n == 2 ? q * q : portable::pow(q, n), sum = pn + qn;
  if (sum <= 0) return -std::min(a, b);
  const double radius = n == 2 ? std::sqrt(sum) : portable::pow(sum, 1 / n);
  const double gradient = radius / sum * portable::hypot(p > 0 ? pn / p / a : 0.0, q > 0 ? qn / q / b : 0.0);
  return (radius - 1) / gradient;
}

/// Distance to the segment from a to b; `along` becomes the share of it at the nearest point.
inline double segment_distance(const Point3& p, const Point3& a, const Point3& b, double& along) {
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
  const double t = ((p.x - a.x) * dx + (p.y - a.y) * dy + (p.z - a.z) * dz) / (dx * dx + dy * dy + dz * dz);
  along = std::clamp(t, 0.0, 1.0);
  return portable::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy, p.z - a.z - along * dz);
}

/// Factor by which the section of a rounded end has shrunk `above` mm above its tip: from 0 to 1 over `length`.
inline double blunt_end(double above, double length) {
  if (above <= 0) return 0;
  if (above >= length) return 1;
  const double missing = 1 - above / length;
  return std::sqrt(1 - missing * missing);
}

}  // namespace odontoscope::sample
