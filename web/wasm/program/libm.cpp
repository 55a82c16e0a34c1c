// Where this module's C library rounds differently from glibc, with which native programs are built, the same bits as there: models would differ in their
// last digits. hypot is wanted for nearly every distance. By C. F. Borges' way (An Improved Algorithm for hypot(a, b), 2019), which glibc 2.35 and newer has, too.
#include <cmath>

#undef hypot   // see stand_ins/cmath

namespace {

/// Of 0 < y <= x whose squares neither overflow nor vanish.
double corrected_hypotenuse(double x, double y) {
  const double h = std::sqrt(x * x + y * y);
  double off = 0;
  if (h <= 2 * y) {
    const double rest = h - y;
    off = x * (2 * rest - x) + (rest - 2 * (x - y)) * rest;
  } else {
    const double rest = h - x;
    off = 2 * rest * (x - 2 * y) + ((4 * rest - y) * y + rest * rest);
  }
  return h - off / (2 * h);
}

}  // namespace

extern "C" double hypot(double a, double b) {
  constexpr double large = 0x1p+511, tiny = 0x1p-459, scale = 0x1p-600, negligible = 0x1p-54;
  if (std::isinf(a) || std::isinf(b)) return HUGE_VAL;
  if (std::isnan(a) || std::isnan(b)) return a + b;
  a = std::fabs(a);
  b = std::fabs(b);
  const double x = a < b ? b : a, y = a < b ? a : b;
  if (y <= x * negligible) return x + y;
  if (x > large) return corrected_hypotenuse(x * scale, y * scale) / scale;
  if (y < tiny) return corrected_hypotenuse(x / scale, y / scale) * scale;
  return corrected_hypotenuse(x, y);
}
