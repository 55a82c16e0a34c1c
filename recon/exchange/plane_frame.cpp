#include "recon/exchange/plane_frame.h"

#include <cmath>

#include "recon/core/portable_math.h"

namespace odontoscope {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector scaled(const Vector& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }
double length(const Vector& a) { return portable::hypot(a[0], a[1], a[2]); }

Frame frame_of(const Vector& unit_normal) {
  constexpr Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const Frame& axes : {Frame{x, y, z}, Frame{y, z, x}, Frame{z, x, y}}) {
    if (std::abs(dot(unit_normal, axes.n)) == 1) return axes;
  }
  constexpr double near_x = 0.6;
  const Vector aside = std::abs(unit_normal[0]) < near_x ? x : y;
  Vector v = cross(unit_normal, aside);
  v = scaled(v, 1 / length(v));
  return {cross(v, unit_normal), v, unit_normal};
}

}  // namespace odontoscope
