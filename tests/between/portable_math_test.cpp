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
  return std::abs(found - right) / (std::nextafter(std::abs(right), std::numeric_limits<double>::infinity()) - std::abs(right));
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
}

}  // namespace
}  // namespace odontoscope
