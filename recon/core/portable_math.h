#pragma once
// Elementary functions with the same bits on every machine.
//
// IEEE 754 fixes + - * / and sqrt to the last bit, and leaves exp and its like to each C library: glibc rounds them differently on processors with and
// without fused multiply-add, other libraries differ from both. What a model's coordinates or a report's figures are made of uses these instead, so that
// the same input gives the same bytes natively, on another processor, and in a browser. They are made of operations that IEEE 754 fixes alone (and this
// project is compiled without contraction), and are off by a few units in the last place at most (pow by as many as |y ln x|, if that is more).

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

}  // namespace odontoscope::portable
