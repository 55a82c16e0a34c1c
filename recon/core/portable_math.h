#pragma once
// Elementary functions with the same bits on every machine.
//
// IEEE 754 fixes + - * / and sqrt to the last bit, and leaves exp and its like to each C library: glibc rounds them
// differently on processors with and without fused multiply-add, other libraries differ from both. What a model's
// coordinates or a report's figures are made of uses these instead, so that the same input gives the same bytes
// natively, on another processor, and in a browser. They are made of operations that IEEE 754 fixes alone (and this
// project is compiled without contraction), and are off by a few units in the last place at most (pow by as many as |y
// ln x|, if that is more).

#include <cmath>

namespace odontoscope::portable {

/// Underflows to 0 and overflows to infinity as std::exp does. Precondition: no NaN.
double exp(double x);

/// Precondition: x > 0, finite and normal.
double log(double x);

/// Precondition: x >= 0, finite; y > 0, finite.
double pow(double x, double y);

/// -pi to pi, as std::atan2; for zeros of either sign, too. Precondition: both finite.
double atan2(double y, double x);

/// Precondition: -1 <= x <= 1.
double asin(double x);

/// Precondition: -1 <= x <= 1.
double acos(double x);

/// Precondition: |x| < 1e6.
double sin(double x);
double cos(double x);

/// Precondition: |x| < 1e6, and no odd multiple of pi / 2.
double tan(double x);

double cbrt(double x);

/// The power of two nearest to x by their ratio. Precondition: x > 0, finite and normal.
double nearest_power_of_two(double x);

namespace detail {
double hypot_of_any(double a, double b);
double corrected_hypot(double larger, double smaller);
}  // namespace detail

/// Infinite where a or b is; neither overflows nor vanishes on the way.
inline double hypot(double a, double b) {
  a = std::fabs(a);
  b = std::fabs(b);
  const double larger = a < b ? b : a, smaller = a < b ? a : b;
  // Squares of these neither overflow nor vanish, nor is the smaller lost beside the larger: where most calls end.
  if (larger < 0x1p+511 && smaller > 0x1p-459 && smaller > larger * 0x1p-54)
    return detail::corrected_hypot(larger, smaller);
  return detail::hypot_of_any(a, b);
}

inline double hypot(double a, double b, double c) {
  a = std::fabs(a);
  b = std::fabs(b);
  c = std::fabs(c);
  const double largest = a < b ? (b < c ? c : b) : (a < c ? c : a);
  if (!(largest != 0)) return 0;
  return largest *
         std::sqrt((a / largest) * (a / largest) + (b / largest) * (b / largest) + (c / largest) * (c / largest));
}

inline double square(double x) { return x * x; }

}  // namespace odontoscope::portable
