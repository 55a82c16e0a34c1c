// Whole stacks by the default criterion: what is one thing over several slices is one solid, what stands side by side
// is not joined.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/random_numbers.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

constexpr double cut = 0.5;  // mm between slices

ReconstructOptions by_default() {
  ReconstructOptions options;
  options.between = Between::delaunay;
  options.threads = 1;
  return options;
}

std::size_t tracked_links(const Reconstruction& made) {
  std::size_t count = 0;
  for (const MadeLink& link : made.links) count += link.criterion == LinkCriterion::tracked;
  return count;
}

/// Circles of radius 1 that shift by so many radii a slice.
ContourStack leaning_column(double radii, int slices, double height) {
  ContourStack stack;
  for (int k = 0; k < slices; ++k)
    stack.slices.push_back({height * k, {{"tooth", regular_polygon(40, 1, {radii * k, 0})}}});
  return stack;
}

/// `columns` by `rows` islands on a grid, each with a wobble of its own, all upright.
ContourStack islands(int columns, int rows, int slices) {
  RandomNumbers random(7);
  ContourStack stack;
  for (int k = 0; k < slices; ++k) {
    stack.slices.push_back({cut * k, {}});
    for (int i = 0; i < columns * rows; ++i) {
      const Point2 at{0.5 * (i % columns) + random.between(-0.04, 0.04),
                      0.5 * (i / columns) + random.between(-0.04, 0.04)};
      stack.slices.back().contours.push_back({"tooth", regular_polygon(8, 0.15, at, 0.2)});
    }
  }
  return stack;
}

/// Two roots that taper to their apices, not equally long, and nothing below them: what ends beside a root is no part
/// of it.
ContourStack two_roots() {
  ContourStack stack;
  for (int k = 0; k < 9; ++k) {
    stack.slices.push_back({-cut * (8 - k), {}});
    for (const double side : {-1.0, 1.0}) {
      const double radius = 0.12 * (k - (side < 0 ? 0 : 3)) + 0.1;
      if (radius > 0)
        stack.slices.back().contours.push_back(
            {"tooth", regular_polygon(24, radius, {side * (1.25 + 0.03 * (8 - k)), 0}, 0.1)});
    }
  }
  return stack;
}

/// Thin bristles in a row, `gap` apart, that lean by `step` a slice; each ends and begins on a height of its own.
ContourStack bristles(double gap, double step) {
  ContourStack stack;
  for (int k = 0; k < 8; ++k) {
    stack.slices.push_back({cut * k, {}});
    for (int i = 0; i < 6; ++i)
      if (k >= i % 2 && k < 8 - i % 3)
        stack.slices.back().contours.push_back(
            {"tooth", regular_polygon(12, 0.1, {gap * i + step * k, 0.02 * i}, 0.1)});
  }
  return stack;
}

TEST(TrackedStacks, CirclesThatShiftByMoreThanARadiusAreOnePieceByDefault) {
  for (const double radii : {0.5, 1.5, 2.5}) {
    const Reconstruction made = certified(leaning_column(radii, 10, 1), by_default());
    EXPECT_EQ(topology_of(made), shells({"tooth external genus 0"})) << radii;
    EXPECT_EQ(made.counts.isolated_regions, 0u) << radii;
    EXPECT_EQ(tracked_links(made), radii > 1 ? 9u : 0u) << radii;
  }
}

TEST(TrackedStacks, AreOnOneThreadAsOnMany) {
  ReconstructOptions many = by_default();
  many.threads = 4;
  const Reconstruction one = certified(leaning_column(1.5, 6, 1), by_default()),
                       four = certified(leaning_column(1.5, 6, 1), many);
  EXPECT_EQ(one.solids[0].surface.triangles, four.solids[0].surface.triangles);
  EXPECT_EQ(one.doubts, four.doubts);
}

TEST(TrackedStacks, FiveHundredIslandsStayApart) {
  const Reconstruction made = certified(islands(25, 20, 3), by_default());
  EXPECT_EQ(made.solids.at(0).report.shells.size(), 500u);
  EXPECT_EQ(tracked_links(made), 0u);
  EXPECT_TRUE(made.doubts.empty());
}

/// A cone of slices 1 mm apart, as wide as is asked for, between empty slices.
ContourStack cone(const std::vector<double>& radii) {
  ContourStack stack;
  stack.slices.push_back({0, {}});
  for (const double radius : radii)
    stack.slices.push_back(
        {static_cast<double>(stack.slices.size()), {{"tooth", regular_polygon(40, radius, {0, 0})}}});
  stack.slices.push_back({static_cast<double>(stack.slices.size()), {}});
  return stack;
}

double highest(const Reconstruction& made) {
  double z = 0;
  for (const Point3& p : made.solids.at(0).surface.points) z = std::max(z, p.z);
  return z;
}

// Where the slice before tells how it narrows, a structure ends between its last slice and the empty one; where it does
// not narrow, in its slice.
TEST(TrackedStacks, AStructureEndsWhereItsNarrowingRunsOut) {
  const auto top = [](const std::vector<double>& radii, Between between) {
    ReconstructOptions options;
    options.between = between;
    const Reconstruction made = certified(cone(radii), options);
    EXPECT_EQ(topology_of(made), shells({"tooth external genus 0"}));
    return highest(made);
  };
  EXPECT_LT(top({1.5, 1.0, 0.5}, Between::delaunay), 3.01);
  const double slow = top({1.5, 1.0, 0.5}, Between::blended), quick = top({1.8, 1.2, 0.45}, Between::blended);
  EXPECT_GT(slow, 3.3);
  EXPECT_LT(slow, 4) << "the next slice has nothing of it";
  EXPECT_LT(quick, slow) << "it narrows more quickly";
  EXPECT_GT(quick, 3.01);
}

TEST(TrackedStacks, TwoRootsBesideEachOtherStayApart) {
  const Reconstruction made = certified(two_roots(), by_default());
  EXPECT_EQ(made.solids.at(0).report.shells.size(), 2u);
  EXPECT_EQ(tracked_links(made), 0u);
}

TEST(TrackedStacks, BristlesStayApart) {
  for (const double step : {0.0, 0.15, 0.4}) {
    SCOPED_TRACE(step);
    const Reconstruction made = certified(bristles(1.0, step), by_default());
    EXPECT_EQ(made.solids.at(0).report.shells.size(), 6u) << "six bristles, each in one piece";
    EXPECT_EQ(made.counts.isolated_regions, 0u);
  }
}

TEST(TrackedStacks, WhatLeansByHalfItsSpacingIsAskedAbout) {
  // Each section lies halfway between two others of the slice below: nothing tells which of the two it goes on from.
  const Reconstruction made = certified(bristles(0.8, 0.4), by_default());
  std::size_t open = 0;
  for (const Doubt& doubt : made.doubts)
    open += doubt.kind == DoubtKind::may_connect || doubt.kind == DoubtKind::may_part;
  EXPECT_GT(open + tracked_links(made), 0u);
  for (const MadeLink& link : made.links) EXPECT_NE(link.criterion, LinkCriterion::crossing);
}

TEST(TrackedStacks, ADoubtNamesItsPlaceAndTheLinkThatDecidesIt) {
  // A slight overlap: linked, and it may not be meant.
  ContourStack stack = shifted_circles(1.6);
  const Reconstruction made = certified(stack, by_default());
  ASSERT_EQ(made.doubts.size(), 1u);
  const Doubt& doubt = made.doubts[0];
  EXPECT_EQ(doubt.kind, DoubtKind::may_part);
  EXPECT_EQ(doubt.structure, "tooth");
  EXPECT_EQ(doubt.slab, 0u);
  EXPECT_NEAR(doubt.place.z, (stack.slices[0].z + stack.slices[1].z) / 2, 1e-12);
  ReconstructOptions decided = by_default();
  decided.links = {{"tooth", doubt.slab, doubt.lower.value(), doubt.upper.value(), false}};
  const Reconstruction parted = certified(stack, decided);
  EXPECT_EQ(parted.solids.at(0).report.shells.size(), 2u);
  EXPECT_TRUE(parted.doubts.empty()) << "it was decided";
}

TEST(TrackedStacks, AnAdvisedLinkJoinsWhatItIsAdvisedFor) {
  const ContourStack stack = shifted_circles(6);
  const Reconstruction alone = certified(stack, by_default());
  EXPECT_EQ(alone.counts.isolated_regions, 2u);
  ASSERT_EQ(alone.remedies.size(), 1u) << "one link for both";
  ReconstructOptions advised = by_default();
  advised.links = alone.remedies;
  const Reconstruction joined = certified(stack, advised);
  EXPECT_EQ(joined.counts.isolated_regions, 0u);
  EXPECT_EQ(joined.solids.at(0).report.shells.size(), 1u);
  EXPECT_TRUE(certified(stack_of({{circle(1)}, {}, {circle(1)}}), by_default()).remedies.empty())
      << "there is nothing to link it with";
}

}  // namespace
}  // namespace odontoscope::test
