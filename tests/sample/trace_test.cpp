// The tracer of the sample teeth: fields with a known contour, and the awkward ones.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "recon/sample/field_loops.h"

namespace odontoscope::test {
namespace {

using sample::Grid;

Grid sampled(std::size_t side, double step, const std::function<double(Point2)>& field) {
  const double low = -step * static_cast<double>(side - 1) / 2;
  Grid grid{{low, low}, step, side, side, {}};
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) grid.values.push_back(field(grid.at(column, row)));
  return grid;
}

double radius(Point2 p) { return std::hypot(p.x, p.y); }

ContourStack as_stack(const std::vector<Polygon>& loops) {
  ContourStack stack;
  stack.slices = {{0, {}}, {1, {}}};
  for (const Polygon& loop : loops)
    for (Slice& slice : stack.slices) slice.contours.push_back({"tooth", loop});
  return stack;
}

TEST(Trace, FollowsACircle) {
  const auto loops = sample::trace(sampled(61, 0.1, [](Point2 p) { return radius(p) - 2; }), 0);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(signed_area(loops[0]), 4 * std::numbers::pi, 0.01);
  for (const Point2& p : loops[0]) EXPECT_NEAR(radius(p), 2, 0.002);
}

TEST(Trace, HolesRunClockwise) {
  const auto loops = sample::trace(sampled(61, 0.1, [](Point2 p) { return std::abs(radius(p) - 1.5) - 0.7; }), 0);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(signed_area(loops[0]) + signed_area(loops[1]), std::numbers::pi * (2.2 * 2.2 - 0.8 * 0.8), 0.03);
  EXPECT_LT(signed_area(loops[0]) * signed_area(loops[1]), 0);
}

// Values of exactly 0 on grid vertices, saddles in every cell: the contours must neither touch nor cross.
TEST(Trace, StaysSimpleOnTheWorstFields) {
  const auto checkers = [](Point2 p) {
    const auto index = [](double v) { return static_cast<long>(std::lround(v / 0.5)); };
    return (index(p.x) + index(p.y)) % 2 == 0 ? -1.0 : 1.0;
  };
  // Inside a plus sign, exactly 0 outside: at its inner corners two crossings want to be the same grid vertex.
  const auto zeros = [](Point2 p) {
    return std::min(std::abs(p.x), std::abs(p.y)) < 0.75 && std::max(std::abs(p.x), std::abs(p.y)) < 3 ? -1.0 : 0.0;
  };
  const auto fenced = [](auto field) {
    return [field](Point2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > 4.9 ? 1.0 : field(p); };
  };
  for (const Grid& grid : {sampled(21, 0.5, fenced(checkers)), sampled(21, 0.5, fenced(zeros))}) {
    const auto loops = sample::trace(grid, 0);
    ASSERT_FALSE(loops.empty());
    EXPECT_NO_THROW(validate(as_stack(loops)));
    const auto thinned = sample::thin(loops, {2.0, 0.5, 1e-4, 1e-5});
    EXPECT_EQ(thinned.size(), loops.size());
    EXPECT_NO_THROW(validate(as_stack(thinned)));
  }
}

// Two diagonal neighbours inside: the mean of the cell's corners decides whether they are one.
TEST(Trace, JoinsASaddleByItsMean) {
  for (const double depth : {0.5, 2.0}) {
    Grid grid{{0, 0}, 1, 4, 4, std::vector<double>(16, 1.0)};
    grid.values[5] = grid.values[10] = -depth;
    EXPECT_EQ(sample::trace(grid, 0).size(), depth > 1 ? 1u : 2u) << depth;
  }
}

TEST(Trace, LeavesOutSpecks) {
  const auto two = [](Point2 p) { return std::min(std::hypot(p.x - 1.5, p.y) - 1, std::hypot(p.x + 1.5, p.y) - 0.2); };
  EXPECT_EQ(sample::trace(sampled(61, 0.1, two), 0).size(), 2u);
  EXPECT_EQ(sample::trace(sampled(61, 0.1, two), 0.5).size(), 1u);
}

TEST(Trace, RefusesAShapeThatLeavesTheGrid) {
  EXPECT_THROW(sample::trace(sampled(21, 0.1, [](Point2 p) { return radius(p) - 2; }), 0), InternalError);
}

TEST(Thin, KeepsToSpacingAndDeviation) {
  const auto loops = sample::trace(sampled(121, 0.05, [](Point2 p) { return radius(p) - 2; }), 0);
  const auto thinned = sample::thin(loops, {0.4, 0.02, 1e-4, 1e-5});
  ASSERT_EQ(thinned.size(), 1u);
  EXPECT_LT(thinned[0].size(), loops[0].size() / 2);
  for (std::size_t i = 0; i < thinned[0].size(); ++i) {
    const Point2 &p = thinned[0][i], &q = thinned[0][(i + 1) % thinned[0].size()];
    EXPECT_LE(std::hypot(q.x - p.x, q.y - p.y), 0.45);
    EXPECT_NEAR(radius({(p.x + q.x) / 2, (p.y + q.y) / 2}), 2, 0.022);
  }
}

// A disc in a round bay of a large square, a hair off its shore: the square's long chords would cut through the disc.
TEST(Thin, KeepsNarrowGapsOpen) {
  const auto bay = [](Point2 p) {
    const double channel = p.y > 0 ? 0.3 - std::abs(p.x) : -1.0, square = std::max(std::abs(p.x), std::abs(p.y)) - 8;
    return std::min(std::max({square, 0.8 - radius(p), channel}), radius(p) - 0.75);
  };
  const auto loops = sample::trace(sampled(401, 0.0421, bay), 0);
  ASSERT_EQ(loops.size(), 2u);
  const auto thinned = sample::thin(loops, {0.8, 0.5, 1e-3, 1e-5});
  ASSERT_EQ(thinned.size(), 2u);
  EXPECT_NO_THROW(validate(as_stack(thinned)));
  EXPECT_LT(thinned[0].size() + thinned[1].size(), (loops[0].size() + loops[1].size()) / 2);
}

}  // namespace
}  // namespace odontoscope::test
