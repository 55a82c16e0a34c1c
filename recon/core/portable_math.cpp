#include "recon/core/portable_math.h"

#include <cmath>
#include <numbers>

namespace odontoscope::portable {
namespace {

// ln 2 in two parts, of which the first has zeros at its end: times a small whole number it is exact.
constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;

/// Of 0 <= t <= 1.
double arc_tangent(double t) {
  // Halving the angle twice leaves at most tan(pi / 16), where the series is short.
  for (int halved = 0; halved < 2; ++halved) t = t / (1 + std::sqrt(1 + t * t));
  const double square = t * t;
  double sum = 0;
  for (int n = 25; n >= 3; n -= 2) sum = square * (1.0 / n - sum);   // 1/3 - t^2/5 + ..., from its end
  return 4 * (t - t * sum);
}

}  // namespace

double exp(double x) {
  if (x > 710) return HUGE_VAL;
  if (x < -750) return 0;
  const double whole = std::floor(x / std::numbers::ln2 + 0.5);
  const double rest = (x - whole * ln2_high) - whole * ln2_low;   // at most 0.35
  double sum = 0;
  for (int n = 15; n >= 2; --n) sum = (1 + sum) * rest / n;   // from the series' end
  return std::ldexp(1 + rest * (1 + sum), static_cast<int>(whole));
}

double log(double x) {
  int exponent = 0;
  double part = std::frexp(x, &exponent);   // 0.5 to 1
  if (part < std::numbers::sqrt2 / 2) {
    part *= 2;
    --exponent;
  }
  const double s = (part - 1) / (part + 1), square = s * s;   // log(part) = 2 (s + s^3/3 + s^5/5 + ...), |s| <= 0.172
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = square * (1.0 / n + sum);
  return exponent * ln2_high + (2 * (s + s * sum) + exponent * ln2_low);
}

double pow(double x, double y) { return x > 0 ? exp(y * log(x)) : 0; }

double atan2(double y, double x) {
  const double up = std::fabs(y), along = std::fabs(x);
  double angle = 0;
  if (up > along) angle = std::numbers::pi / 2 - arc_tangent(along / up);
  else if (along > 0) angle = arc_tangent(up / along);
  if (std::signbit(x)) angle = std::numbers::pi - angle;
  return std::copysign(angle, y);
}

double asin(double x) { return atan2(x, std::sqrt((1 - x) * (1 + x))); }

}  // namespace odontoscope::portable
