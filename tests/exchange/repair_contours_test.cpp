// Contours that break the rules, and what becomes of them.

#include "recon/exchange/repair_contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recon/input/validate.h"

namespace odontoscope {
namespace {

using Points = std::vector<Point2>;

/// The given contours of one structure in a slice, with a square below so that the stack is one.
ContourStack stack_of(const std::vector<Points>& contours) {
  ContourStack stack;
  stack.source = "file";
  stack.slices.push_back({0, {{"tooth", {{0, 0}, {1, 0}, {0, 1}}}}});
  stack.slices.push_back({1, {}});
  for (const Points& points : contours) stack.slices.back().contours.push_back({"tooth", points});
  return stack;
}

double area(const std::vector<Contour>& contours) {
  double twice = 0;
  for (const Contour& contour : contours) {
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Point2 &a = contour.points[i], &b = contour.points[(i + 1) % contour.points.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  }
  return twice / 2;
}

/// Repairs, checks that the result keeps the rules, and gives the slice.
std::vector<Contour> repaired(const std::vector<Points>& contours, const RepairOptions& options = {},
                              std::size_t changes = 1) {
  const RepairedContours result = repair_contours(stack_of(contours), options);
  EXPECT_NO_THROW(validate(result.stack));
  EXPECT_EQ(result.changes.size(), changes);
  EXPECT_EQ(result.stack.slices[0].contours[0].points, (Points{{0, 0}, {1, 0}, {0, 1}}));
  return result.stack.slices[1].contours;
}

TEST(RepairContours, LeavesWhatKeepsTheRulesAsItIs) {
  const std::vector<Points> good{{{0, 0}, {0, 4}, {4, 4}, {4, 0}},
                                 {{1, 1}, {2, 1}, {2, 2}}};  // clockwise and not: both are fine
  const std::vector<Contour> slice = repaired(good, {}, 0);
  ASSERT_EQ(slice.size(), 2u);
  EXPECT_EQ(slice[0].points, good[0]);
  EXPECT_EQ(slice[1].points, good[1]);
}

TEST(RepairContours, RepeatedPointsGo) {
  const std::vector<Contour> slice = repaired({{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}});
  ASSERT_EQ(slice.size(), 1u);
  EXPECT_EQ(slice[0].points, (Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  const RepairedContours told = repair_contours(stack_of({{{0, 0}, {0, 0}, {4, 0}, {4, 4}}}));
  EXPECT_EQ(in_words(told.changes.at(0)),
            "file: slice 1 (z = 1), contour 0, tooth: 1 point repeated its neighbour and went");
}

TEST(RepairContours, WhatEnclosesNothingGoes) {
  EXPECT_EQ(repaired({{{0, 0}, {4, 0}}, {{0, 5}, {1, 5}, {2, 5}}, {{0, 8}, {1, 8}, {1, 9}}}, {}, 2).size(), 1u);
}

TEST(RepairContours, AFigureOfEightBecomesTwo) {
  const std::vector<Contour> slice = repaired({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}});
  ASSERT_EQ(slice.size(), 2u);
  // Two triangles of area 4 that met in (2, 2); the tip of one is cut off by a 64th.
  EXPECT_NEAR(area(slice), 8, 8.0 / 64 / 64);
  EXPECT_LT(area(slice), 8);
}

TEST(RepairContours, AKeyholeBecomesARing) {
  // A square with a square hole, drawn in one line that goes in and comes back along (0, 4) - (2, 4).
  const std::vector<Contour> slice =
      repaired({{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {2, 4}, {2, 6}, {6, 6}, {6, 2}, {2, 2}, {2, 4}, {0, 4}}});
  ASSERT_EQ(slice.size(), 2u);
  EXPECT_NEAR(area(slice), 64 - 16, 1e-12);
}

TEST(RepairContours, AHoleThatTouchesItsOuterContourLeavesAGap) {
  const std::vector<Contour> slice = repaired({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 4}, {2, 2}, {2, 6}}});
  ASSERT_EQ(slice.size(), 1u);
  EXPECT_NEAR(area(slice), 64 - 4, 0.01);
}

TEST(RepairContours, CrossingContoursAreDifferentByTheirRule) {
  const std::vector<Points> squares{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 2}, {6, 2}, {6, 6}, {2, 6}}};
  EXPECT_NEAR(area(repaired(squares)), 16 + 16 - 2 * 4, 0.01);                            // odd: the overlap is a hole
  EXPECT_NEAR(area(repaired(squares, {.inside = Inside::positive})), 16 + 16 - 4, 0.01);  // union
}

TEST(RepairContours, AContourGivenTwiceIsKeptOnce) {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, from_elsewhere_and_back{{4, 4}, {4, 0}, {0, 0}, {0, 4}, {0, 4}};
  EXPECT_EQ(area(repaired({square, square})), 16);
  EXPECT_EQ(area(repaired({square, from_elsewhere_and_back, square}, {}, 2)), 16);
  EXPECT_EQ(repaired({square, square}, {.inside = Inside::positive}).size(), 1u);
}

/// A square of 10 with a hole of 3, drawn in one line: in along a channel of the given width, and out again.
Points keyhole(double width) {
  const double low = 5 - width / 2, high = 5 + width / 2;
  return {{0, 0},     {10, 0},     {10, low}, {6.5, low}, {6.5, 3.5}, {3.5, 3.5}, {3.5, 6.5},
          {6.5, 6.5}, {6.5, high}, {8, high}, {10, high}, {10, 10},   {0, 10}};
}

TEST(RepairContours, AKeyholeWithAChannelOfAFewMicrometresBecomesAHole) {
  for (const double width : {0.002, 0.00001, 0.009}) {
    for (const bool turned : {false, true}) {
      Points points = keyhole(width);
      if (turned) std::reverse(points.begin(), points.end());
      const std::vector<Contour> slice = repaired({points});
      ASSERT_EQ(slice.size(), 2u) << width;
      EXPECT_NEAR(area(slice), 91, 20 * width);
      const RepairedContours again = repair_contours(stack_of({slice[0].points, slice[1].points}));
      EXPECT_TRUE(again.changes.empty());
    }
  }
}

TEST(RepairContours, AChannelThatIsDrawnStays) {
  EXPECT_TRUE(repair_contours(stack_of({keyhole(0.05)})).changes.empty());
  // A notch that comes to a point is narrow there, too, but shuts nothing in.
  EXPECT_TRUE(
      repair_contours(stack_of({{{0, 0}, {10, 0}, {10, 4.9}, {5, 5}, {10, 5.1}, {10, 10}, {0, 10}}})).changes.empty());
}

TEST(RepairContours, SharedEdgesMelt) {
  const std::vector<Contour> slice = repaired({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 1}, {6, 1}, {6, 3}, {4, 3}}});
  ASSERT_EQ(slice.size(), 1u);
  EXPECT_NEAR(area(slice), 20, 1e-12);
}

TEST(RepairContours, StructuresAreIndependent) {
  ContourStack stack = stack_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  stack.slices[1].contours.push_back({"pulp", {{2, 2}, {6, 2}, {6, 6}, {2, 6}}});
  EXPECT_TRUE(repair_contours(stack).changes.empty());
}

TEST(RepairContours, RandomScribblesComeOutValidAndTheSameInAnyOrder) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const bool lattice = seed % 2 == 0;  // full of touching and coinciding edges
    std::vector<Points> scribbles(1 + seed % 3);
    for (Points& points : scribbles) {
      for (unsigned i = 0; i < 5 + seed % 25; ++i) {
        const double x = static_cast<double>(random() % 1000), y = static_cast<double>(random() % 1000);
        points.push_back(lattice ? Point2{std::floor(x / 120), std::floor(y / 120)} : Point2{x / 100, y / 100});
      }
    }
    for (const Inside rule : {Inside::odd, Inside::positive}) {
      const RepairedContours once = repair_contours(stack_of(scribbles), {.inside = rule});
      EXPECT_NO_THROW(validate(once.stack)) << "seed " << seed;
      const RepairedContours again = repair_contours(once.stack, {.inside = rule});
      EXPECT_TRUE(again.changes.empty()) << "seed " << seed;
    }
    std::vector<Points> turned = scribbles;
    for (Points& points : turned) std::reverse(points.begin(), points.end());
    const double a = area(repair_contours(stack_of(scribbles)).stack.slices[1].contours);
    const double b = area(repair_contours(stack_of(turned)).stack.slices[1].contours);
    EXPECT_NEAR(a, b, 0.05 * std::abs(a) + 0.01) << "seed " << seed;
  }
}

}  // namespace
}  // namespace odontoscope
