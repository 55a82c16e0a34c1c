// Elementary functions with the same bits on every machine.
#include "recon/core/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace odontoscope {
namespace {

/// How many units in the last place of `right` the two are apart.
double units_apart(double found, double right) {
  if (found == right) return 0;
  return std::abs(found - right) /
         (std::nextafter(std::abs(right), std::numeric_limits<double>::infinity()) - std::abs(right));
}

// These bits are what every processor, compiler and C library must give: a change of them changes models.
TEST(PortableMath, HasTheSameBitsEverywhere) {
  EXPECT_EQ(portable::exp(1.25), 0x1.bec38edb0fafp+1);
  EXPECT_EQ(portable::exp(-30.5), 0x1.ff3864232b407p-45);
  EXPECT_EQ(portable::log(0.3), -0x1.34378fcbda721p+0);
  EXPECT_EQ(portable::pow(0.7, 1.5), 0x1.2bdbe460916ep-1);
  EXPECT_EQ(portable::atan2(1, -3), 0x1.68f095fdf593cp+1);
  EXPECT_EQ(portable::asin(0.3), 0x1.380159e14f6fep-2);
}

TEST(PortableMath, IsOffByAFewUnitsInTheLastPlace) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-20, 20), sine(-1, 1), positive(1e-6, 3);
  for (int n = 0; n < 200'000; ++n) {
    const double a = number(random), b = number(random), s = sine(random), p = positive(random);
    ASSERT_LE(units_apart(portable::exp(a), std::exp(a)), 2) << a;
    ASSERT_LE(units_apart(portable::log(p), std::log(p)), 3) << p;
    ASSERT_LE(units_apart(portable::pow(p, 1.5), std::pow(p, 1.5)), 24) << p;
    ASSERT_LE(units_apart(portable::atan2(a, b), std::atan2(a, b)), 6) << a << ' ' << b;
    ASSERT_LE(units_apart(portable::asin(s), std::asin(s)), 6) << s;
    ASSERT_LE(units_apart(portable::cbrt(a), static_cast<double>(std::cbrt(static_cast<long double>(a)))), 2)
        << a;  // that of doubles is off by more
    ASSERT_LE(units_apart(portable::hypot(a, b), std::hypot(a, b)), 1) << a << ' ' << b;
    ASSERT_LE(units_apart(portable::hypot(a, b, s), std::hypot(a, b, s)), 2) << a << ' ' << b << ' ' << s;
    // Near their zeros a relative measure says nothing.
    constexpr double unit = std::numeric_limits<double>::epsilon();
    ASSERT_NEAR(portable::acos(s), std::acos(s), 4 * unit) << s;
    for (const double far : {1.0, 1000.0, 40'000.0}) {
      ASSERT_NEAR(portable::sin(far * a), std::sin(far * a), unit) << far * a;
      ASSERT_NEAR(portable::cos(far * a), std::cos(far * a), unit) << far * a;
    }
  }
}

TEST(PortableMath, KnowsTheEnds) {
  EXPECT_EQ(portable::exp(0), 1);
  EXPECT_EQ(portable::exp(-800), 0);
  EXPECT_TRUE(std::isinf(portable::exp(800)));
  EXPECT_EQ(portable::log(1), 0);
  EXPECT_EQ(portable::pow(0, 1.5), 0);
  EXPECT_EQ(portable::atan2(0, 1), 0);
  EXPECT_EQ(portable::atan2(0, -1), std::numbers::pi);
  EXPECT_EQ(portable::atan2(-0.0, -1), -std::numbers::pi);
  EXPECT_EQ(portable::atan2(1, 0), std::numbers::pi / 2);
  EXPECT_EQ(portable::asin(1), std::numbers::pi / 2);
  EXPECT_EQ(portable::acos(1), 0);
  EXPECT_EQ(portable::acos(-1), std::numbers::pi);
  EXPECT_EQ(portable::sin(0), 0);
  EXPECT_EQ(portable::cos(0), 1);
  EXPECT_EQ(portable::cbrt(-27), -3);
  EXPECT_EQ(portable::cbrt(0), 0);
  EXPECT_EQ(portable::nearest_power_of_two(1), 1);
  EXPECT_EQ(portable::nearest_power_of_two(1.414), 1);
  EXPECT_EQ(portable::nearest_power_of_two(1.415), 2);
  EXPECT_EQ(portable::nearest_power_of_two(0.3), 0.25);
}

TEST(PortableMath, HypotNeitherOverflowsNorVanishes) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(portable::hypot(3e300, -4e300), 5e300);
  EXPECT_EQ(portable::hypot(0x3p-600, 0x4p-600), 0x5p-600);
  EXPECT_EQ(portable::hypot(0, -7), 7);
  EXPECT_EQ(portable::hypot(0, 0), 0);
  EXPECT_EQ(portable::hypot(1e-300, 1e300), 1e300);
  EXPECT_EQ(portable::hypot(infinite, 1), infinite);
  EXPECT_TRUE(std::isnan(portable::hypot(std::nan(""), 1)));
  EXPECT_DOUBLE_EQ(portable::hypot(2e300, 3e300, 6e300), 7e300);
  EXPECT_EQ(portable::hypot(0, 0, 0), 0);
}

}  // namespace
}  // namespace odontoscope
