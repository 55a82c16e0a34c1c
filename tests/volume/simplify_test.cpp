// Simplified contours: valid, as near as promised by a measure of the tests' own, nested as before, together where they
// were together.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "recon/contours/simplify_contours.h"
#include "recon/core/error.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/label_contours.h"
#include "tests/support/plane_check.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

double distance(Point2 p, const std::vector<Point2>& ring) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
  }
  return nearest;
}

/// Largest distance from points along `from` to `to`.
double one_sided(const std::vector<Point2>& from, const std::vector<Point2>& to) {
  constexpr int steps = 8;
  double largest = 0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const Point2 a = from[n], b = from[(n + 1) % from.size()];
    for (int s = 0; s < steps; ++s) {
      const double t = double(s) / steps;
      largest = std::max(largest, distance({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, to));
    }
  }
  return largest;
}

std::vector<std::size_t> depths(const Slice& slice) {
  std::vector<std::vector<Point2>> rings;
  for (const Contour& contour : slice.contours) rings.push_back(contour.points);
  std::vector<std::size_t> result;
  for (std::size_t n = 0; n < rings.size(); ++n) result.push_back(std::size_t(depth_of(rings, n)));
  return result;
}

Volume waves(std::uint64_t seed, std::size_t side) {
  RandomNumbers random(seed);
  const double a = random.between(0.3, 1.2), b = random.between(0.3, 1.2), c = random.between(0, 6),
               d = random.between(0, 6);
  return volume_of({side, side, 2}, [=](std::size_t i, std::size_t j, std::size_t k) {
    return std::sin(a * double(i) + c + 0.3 * double(k)) + std::sin(b * double(j) + d) +
           0.7 * std::sin(0.9 * (double(i) - double(j)));
  });
}

void expect_good(const ContourStack& before, const SimplifiedContours& after, double tolerance) {
  ASSERT_EQ(after.stack.slices.size(), before.slices.size());
  ASSERT_LE(after.largest_deviation, tolerance);
  for (std::size_t s = 0; s < before.slices.size(); ++s) {
    const Slice &old_slice = before.slices[s], &new_slice = after.stack.slices[s];
    ASSERT_EQ(old_slice.z, new_slice.z);
    ASSERT_EQ(old_slice.contours.size(), new_slice.contours.size());
    for (std::size_t c = 0; c < old_slice.contours.size(); ++c) {
      const auto &old_ring = old_slice.contours[c].points, &new_ring = new_slice.contours[c].points;
      ASSERT_GE(new_ring.size(), 3u);
      ASSERT_EQ(area_sign(old_ring), area_sign(new_ring));
      ASSERT_LE(one_sided(old_ring, new_ring), after.largest_deviation + 1e-12);
      ASSERT_LE(one_sided(new_ring, old_ring), after.largest_deviation + 1e-12);
    }
  }
}

TEST(SimplifiedContours, AreValidNearAndNestedAsBefore) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Volume volume = seed % 2 == 0 ? waves(seed, 24) : noise(seed, {12, 12, 2}, 6);
    const ContourStack before = iso_contours(volume, {{seed % 2 == 0 ? 0.1 : 3.0, "tooth"}}).stack;
    for (const double tolerance : {0.0, 0.1, 0.5, 3.0, 100.0}) {
      const SimplifiedContours after = simplify_contours(before, {tolerance});
      ASSERT_EQ(faults(after.stack), "") << "seed " << seed << " tolerance " << tolerance;
      expect_good(before, after, tolerance);
      for (std::size_t s = 0; s < before.slices.size(); ++s) {
        ASSERT_EQ(depths(before.slices[s]), depths(after.stack.slices[s]))
            << "seed " << seed << " tolerance " << tolerance;
      }
    }
  }
}

TEST(SimplifiedContours, OfTouchingLabelsGoOnSharingTheirWalls) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomNumbers random(seed);
    const Volume volume = noise(seed, {8, 8, 2}, 3);
    const ContourStack before = label_contours(volume, {{1, "a"}, {2, "b"}}).stack;
    for (const double tolerance : {0.4, 0.8, 20.0}) {
      const SimplifiedContours after = simplify_contours(before, {tolerance});
      expect_good(before, after, tolerance);
      for (const char* structure : {"a", "b"}) {
        ASSERT_EQ(faults(only(after.stack, structure)), "") << "seed " << seed << " tolerance " << tolerance;
      }
      for (const Slice& slice : after.stack.slices) {
        for (int n = 0; n < 300; ++n) {
          const Point2 at{random.between(-1, 8), random.between(-1, 8)};
          ASSERT_FALSE(covers(slice, "a", at) && covers(slice, "b", at))
              << "seed " << seed << " tolerance " << tolerance;
        }
      }
    }
  }
}

/// Undirected edges, to be looked for in another contour.
std::set<std::array<double, 4>> edges(const Contour& contour) {
  std::set<std::array<double, 4>> result;
  for (std::size_t n = 0; n < contour.points.size(); ++n) {
    const Point2 a = contour.points[n], b = contour.points[(n + 1) % contour.points.size()];
    const bool forward = a.x < b.x || (a.x == b.x && a.y < b.y);
    result.insert(forward ? std::array{a.x, a.y, b.x, b.y} : std::array{b.x, b.y, a.x, a.y});
  }
  return result;
}

TEST(SimplifiedContours, LoseTheSamePointsOnASharedWall) {
  const Volume volume = volume_of({40, 20, 2}, [](std::size_t i, std::size_t j, std::size_t) {
    return double(i) < 20 + 4 * std::sin(0.5 * double(j)) ? 1 : 2;
  });
  const ContourStack before = label_contours(volume, {{1, "a"}, {2, "b"}}).stack;
  const SimplifiedContours after = simplify_contours(before, {0.6});
  const auto shared_length = [](const Slice& slice) {
    const auto a = edges(slice.contours[0]), b = edges(slice.contours[1]);
    double length = 0;
    for (const auto& edge : a) {
      if (b.contains(edge)) length += std::hypot(edge[2] - edge[0], edge[3] - edge[1]);
    }
    return length;
  };
  // The wall is still one line, if a shorter one, with fewer points.
  EXPECT_GT(shared_length(before.slices[0]), 25);
  EXPECT_GT(shared_length(after.stack.slices[0]), 0.7 * shared_length(before.slices[0]));
  EXPECT_LT(after.points_after, after.points_before / 3);
}

TEST(SimplifiedContours, WithToleranceZeroLoseOnlyPointsOnStraightLines) {
  const ContourStack before{{{0, {{"tooth", {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}}}},
                             {1, {{"tooth", {{0, 0}, {2, 0.1}, {2, 2}, {0, 2}}}}}},
                            ""};
  const SimplifiedContours after = simplify_contours(before, {0});
  const std::vector<Point2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(after.stack.slices[0].contours[0].points, square);
  EXPECT_EQ(after.stack.slices[1].contours[0].points.size(), 4u);
  EXPECT_EQ(after.points_before, 10u);
  EXPECT_EQ(after.points_after, 8u);
  EXPECT_EQ(after.largest_deviation, 0);
}

TEST(SimplifiedContours, DoNotDependOnFirstPointsOrThreads) {
  const ContourStack before = iso_contours(waves(3, 40), {{0, "tooth"}}).stack;
  ContourStack turned = before;
  for (Slice& slice : turned.slices) {
    std::reverse(slice.contours.begin(), slice.contours.end());
    for (Contour& contour : slice.contours)
      std::rotate(contour.points.begin(), contour.points.begin() + 3, contour.points.end());
  }
  const auto points_of = [](const ContourStack& stack, std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::set<std::pair<double, double>> points;
    const SimplifiedContours simple = simplify_contours(stack, {0.3});
    for (const Contour& contour : simple.stack.slices[0].contours) {
      for (const Point2 p : contour.points) points.insert({p.x, p.y});
    }
    return points;
  };
  EXPECT_EQ(points_of(before, 1), points_of(turned, 4));
}

TEST(SimplifiedContours, OfStructuresThatCrossStayValidEach) {
  const ContourStack first = iso_contours(waves(5, 24), {{0, "a"}}).stack;
  ContourStack crossing = iso_contours(waves(6, 24), {{0, "b"}}).stack;
  ASSERT_EQ(first.slices.size(), crossing.slices.size());
  for (std::size_t s = 0; s < first.slices.size(); ++s) {
    auto& contours = crossing.slices[s].contours;
    contours.insert(contours.end(), first.slices[s].contours.begin(), first.slices[s].contours.end());
  }
  const SimplifiedContours after = simplify_contours(crossing, {0.5});
  for (const char* structure : {"a", "b"}) EXPECT_EQ(faults(only(after.stack, structure)), "") << structure;
  EXPECT_LT(after.points_after, after.points_before / 2);
}

TEST(SimplifiedContours, RefuseAToleranceThatIsNone) {
  const ContourStack stack = iso_contours(waves(5, 12), {{0, "a"}}).stack;
  EXPECT_THROW(simplify_contours(stack, {-1}), UsageError);
  EXPECT_THROW(simplify_contours(stack, {std::numeric_limits<double>::quiet_NaN()}), UsageError);
  EXPECT_THROW(simplify_contours(stack, {std::numeric_limits<double>::infinity()}), UsageError);
}

}  // namespace
}  // namespace odontoscope::test
