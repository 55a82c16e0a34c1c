#include "recon/core/portable_math.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace odontoscope::portable {
namespace {

// ln 2 in two parts, of which the first has zeros at its end: times a small whole number it is exact.
constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;

constexpr auto one_over_factorial = [] {
  std::array<double, 18> made{1};
  double factorial = 1;  // exact: below 2^53
  for (int n = 1; n < 18; ++n) made[n] = 1 / (factorial *= n);
  return made;
}();

/// Of 0 <= t <= 1.
double arc_tangent(double t) {
  // Halving the angle twice leaves at most tan(pi / 16), where the series is short.
  for (int halved = 0; halved < 2; ++halved) t = t / (1 + std::sqrt(1 + t * t));
  const double square = t * t;
  double sum = 0;
  for (int n = 25; n >= 3; n -= 2) sum = square * (1.0 / n - sum);  // 1/3 - t^2/5 + ..., from its end
  return 4 * (t - t * sum);
}

// pi / 2 in three parts, of which the first two have 33 bits each: times a whole number below 2^20 they are exact.
constexpr double half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34, half_pi_3 = 0x1.3198a2e037073p-69;

/// An angle less the nearest whole number of quarter turns, and how many were taken, modulo four.
struct QuarterTurns {
  double rest;
  unsigned taken;
};

QuarterTurns quarter_turns(double x) {
  const double whole = std::floor(x / (std::numbers::pi / 2) + 0.5);
  const double rest = ((x - whole * half_pi_1) - whole * half_pi_2) - whole * half_pi_3;
  return {rest, static_cast<unsigned>(static_cast<std::int64_t>(whole) & 3)};
}

/// Of |x| <= pi / 4, by their series from its end.
double short_sine(double x) {
  const double xx = x * x;
  double sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = xx * (one_over_factorial[n] - sum);
  return x - x * sum;
}

double short_cosine(double x) {
  const double xx = x * x;
  double sum = 0;
  for (int n = 16; n >= 4; n -= 2) sum = xx * (one_over_factorial[n] - sum);
  return 1 - xx * (0.5 - sum);
}

}  // namespace

double exp(double x) {
  if (x > 710) return HUGE_VAL;
  if (x < -750) return 0;
  const double whole = std::floor(x / std::numbers::ln2 + 0.5);
  const double rest = (x - whole * ln2_high) - whole * ln2_low;  // at most 0.35
  double sum = 0;
  for (int n = 15; n >= 2; --n) sum = rest * (one_over_factorial[n] + sum);  // from the series' end
  return std::ldexp(1 + rest * (1 + sum), static_cast<int>(whole));
}

double log(double x) {
  int exponent = 0;
  double part = std::frexp(x, &exponent);  // 0.5 to 1
  if (part < std::numbers::sqrt2 / 2) {
    part *= 2;
    --exponent;
  }
  const double s = (part - 1) / (part + 1), square = s * s;  // log(part) = 2 (s + s^3/3 + s^5/5 + ...), |s| <= 0.172
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = square * (1.0 / n + sum);
  return exponent * ln2_high + (2 * (s + s * sum) + exponent * ln2_low);
}

double pow(double x, double y) { return x > 0 ? exp(y * log(x)) : 0; }

double atan2(double y, double x) {
  const double up = std::fabs(y), along = std::fabs(x);
  double angle = 0;
  if (up > along)
    angle = std::numbers::pi / 2 - arc_tangent(along / up);
  else if (along > 0)
    angle = arc_tangent(up / along);
  if (std::signbit(x)) angle = std::numbers::pi - angle;
  return std::copysign(angle, y);
}

double asin(double x) { return atan2(x, std::sqrt((1 - x) * (1 + x))); }

double acos(double x) { return atan2(std::sqrt((1 - x) * (1 + x)), x); }

double sin(double x) {
  const auto [rest, taken] = quarter_turns(x);
  const double part = taken % 2 == 0 ? short_sine(rest) : short_cosine(rest);
  return taken < 2 ? part : -part;
}

double cos(double x) {
  const auto [rest, taken] = quarter_turns(x);
  const double part = taken % 2 == 0 ? short_cosine(rest) : short_sine(rest);
  return taken == 1 || taken == 2 ? -part : part;
}

double tan(double x) { return sin(x) / cos(x); }

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double size = std::fabs(x), near = exp(log(size) / 3);
  return std::copysign(near - (near - size / (near * near)) / 3, x);
}

double nearest_power_of_two(double x) {
  int exponent = 0;
  const double part = std::frexp(x, &exponent);  // 0.5 to 1
  return std::ldexp(1, part * part > 0.5 ? exponent : exponent - 1);
}

namespace detail {

// C. F. Borges, An Improved Algorithm for hypot(a, b), 2019: the root of the sum of squares, less what rounding made of
// it.
double corrected_hypot(double larger, double smaller) {
  const double h = std::sqrt(larger * larger + smaller * smaller);
  double off = 0;
  if (h <= 2 * smaller) {
    const double rest = h - smaller;
    off = larger * (2 * rest - larger) + (rest - 2 * (larger - smaller)) * rest;
  } else {
    const double rest = h - larger;
    off = 2 * rest * (larger - 2 * smaller) + ((4 * rest - smaller) * smaller + rest * rest);
  }
  return h - off / (2 * h);
}

double hypot_of_any(double a, double b) {
  constexpr double scale = 0x1p-600;
  if (std::isinf(a) || std::isinf(b)) return HUGE_VAL;
  if (std::isnan(a) || std::isnan(b)) return a + b;
  const double larger = a < b ? b : a, smaller = a < b ? a : b;
  if (smaller <= larger * 0x1p-54) return larger + smaller;
  if (larger >= 0x1p+511) return corrected_hypot(larger * scale, smaller * scale) / scale;
  return corrected_hypot(larger / scale, smaller / scale) * scale;
}

}  // namespace detail

}  // namespace odontoscope::portable
