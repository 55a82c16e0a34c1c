// What juts out as a strip, as the end of an open ring does, must grow along its length, and leave no ledge in the
// plane of the slice.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "recon/between/blend.h"
#include "tests/between/slabs.h"

namespace odontoscope::test {
namespace {

constexpr std::array quarters{0.25, 0.5, 0.75};

std::vector<Outline> between_two(const Outline& lower, const Outline& upper) {
  const Links links = overlap_links(lower, upper);
  between::Surroundings s;
  s.lower = &lower, s.upper = &upper;
  s.z_lower = 0, s.z_upper = 1;
  s.material = links.material, s.voids = links.voids;
  return between::blend(s, quarters);
}

double area_of_c(double outer, double inner, double half_mouth) {
  return (std::numbers::pi - half_mouth) * (outer * outer - inner * inner);
}

/// A block from y = -2 to 2 left of the y axis, with a pointed strip of this length and half that base on its right.
Ring spiked(double length, double half_base) {
  if (length <= 0) return rectangle({-3, -2}, {0, 2});
  return {{-3, -2}, {0, -2}, {0, -half_base}, {length, 0}, {0, half_base}, {0, 2}, {-3, 2}};
}

/// The same block with a pointed groove.
Ring grooved(double length, double half_base) {
  if (length <= 0) return rectangle({-3, -2}, {0, 2});
  return {{-3, -2}, {0, -2}, {0, -half_base}, {-length, 0}, {0, half_base}, {0, 2}, {-3, 2}};
}

TEST(Strips, EndsOfAnOpenRingMoveEvenly) {
  for (const bool closing : {false, true}) {
    Outline narrow{c_shape(2, 1.8, 0.5)}, wide{c_shape(2, 1.8, 1.2)};
    if (closing) std::swap(narrow, wide);
    const std::vector<Outline> made = between_two(narrow, wide);
    for (std::size_t n = 0; n < quarters.size(); ++n) {
      const double share = closing ? 1 - quarters[n] : quarters[n];
      EXPECT_NEAR(area(made[n]), area_of_c(2, 1.8, 0.5 + 0.7 * share), 0.06) << quarters[n];
    }
  }
}

TEST(Strips, ARingOpensFromWhereItGapesMost) {
  const std::vector<Outline> made = between_two({circle(2), hole(circle(1.8))}, {c_shape(2, 1.8, 0.8)});
  for (std::size_t n = 0; n < quarters.size(); ++n)
    EXPECT_NEAR(area(made[n]), area_of_c(2, 1.8, 0.8 * quarters[n]), 0.06) << quarters[n];
}

TEST(Strips, AWedgeKeepsItsForm) {
  const std::vector<Outline> made = between_two({spiked(0, 0)}, {spiked(2, 0.25)});
  for (std::size_t n = 0; n < quarters.size(); ++n) {
    double tip = 0;
    for (const Point2 p : made[n].at(0)) tip = std::max(tip, p.x);
    EXPECT_NEAR(tip, 2 * quarters[n], 0.2) << quarters[n];
    EXPECT_NEAR(area(made[n]) - 12, 0.5 * quarters[n], 0.08) << quarters[n];
  }
}

TEST(Strips, AGrooveKeepsItsForm) {
  const std::vector<Outline> made = between_two({grooved(0, 0)}, {grooved(2, 0.25)});
  for (std::size_t n = 0; n < quarters.size(); ++n) {
    double tip = 0;
    for (const Point2 p : made[n].at(0))
      if (std::abs(p.y) < 0.3) tip = std::min(tip, p.x);
    EXPECT_NEAR(tip, -2 * quarters[n], 0.2) << quarters[n];
    EXPECT_NEAR(12 - area(made[n]), 0.5 * quarters[n], 0.08) << quarters[n];
  }
}

TEST(Strips, NothingLiesBeyondBothOfTwoNestedContours) {
  const Outline inner{ellipse(3, 1)}, outer{ellipse(3.6, 1.3)};
  const std::vector<Outline> made = between_two(inner, outer);
  for (std::size_t n = 0; n < quarters.size(); ++n) {
    ASSERT_EQ(made[n].size(), 1u);
    for (const Point2 p : made[n][0]) {
      EXPECT_GT(distance(inner, p), -0.004);
      EXPECT_LT(distance(outer, p), 0.004);
      const double share = distance(inner, p) / (distance(inner, p) - distance(outer, p));
      EXPECT_NEAR(share, quarters[n], 0.03);
    }
  }
}

}  // namespace
}  // namespace odontoscope::test
