// Grid and field: exact signs, exact distances, the paper's rule, and what is refused.

#include "recon/distance/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

double distance_to_edge(Point2 p, Point2 a, Point2 b) {
  const long double dx = (long double)b.x - a.x, dy = (long double)b.y - a.y;
  const long double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0L, 1.0L);
  return double(std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
}

/// By looking at every edge: distance, negative if a ray to the right meets an odd number of edges.
double plain_signed_distance(const Slice& slice, const std::string& structure, Point2 p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Point2 a = contour.points[i], b = contour.points[(i + 1) % contour.points.size()];
      least = std::min(least, distance_to_edge(p, a, b));
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside ? -least : least;
}

bool has_contour(const Slice& slice, const std::string& structure) {
  return std::any_of(slice.contours.begin(), slice.contours.end(),
                     [&](const Contour& c) { return c.structure == structure; });
}

TEST(Field, IsTheDistanceToTheNearestOfAllEdges) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const ContourStack stack = ordered(random_stack(seed).stack).stack;
    const Grid grid = make_grid(stack, {.columns = 23, .rows = 31, .splits = {}});
    for (const std::string& structure : structures_of(stack)) {
      const Field field = sample_field(stack, structure, grid, {FieldKind::signed_distance});
      const double scale = grid.dx * 23 + grid.dy * 31;
      for (std::size_t k = 1; k + 1 < grid.layers.size(); ++k) {
        const Slice& slice = stack.slices[*grid.layers[k].slice];
        if (!has_contour(slice, structure)) continue;
        for (std::size_t j = 0; j < grid.rows; ++j)
          for (std::size_t i = 0; i < grid.columns; ++i) {
            const double value = field.values[grid.index(i, j, k)];
            const double plain = plain_signed_distance(slice, structure, {grid.x(i), grid.y(j)});
            // Close to a contour plain arithmetic may take the wrong side, so there only the size is compared.
            if (std::abs(plain) > 1e-12 * scale)
              ASSERT_NEAR(value, plain, 1e-12 * scale) << "seed " << seed;
            else
              ASSERT_NEAR(std::abs(value), std::abs(plain), 1e-12 * scale) << "seed " << seed;
            ++compared;
          }
      }
    }
  }
  EXPECT_GT(compared, 40'000u);
}

TEST(Field, IsZeroExactlyOnAContour) {
  // Ten points over a width of 8 put grid points on x = -0.5, 0.5, ..., 8.5; the slanted edge passes through some of
  // them.
  const Ring shape{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, slanted{{0.5, 2.5}, {3.5, 5.5}, {2.5, 6.5}, {0.5, 6.5}},
      pointed{{5.6, 4.1}, {7.3, 4.2}, {6.5, 6.5}};  // its tip alone is on a grid point
  const ContourStack stack = ordered(stack_of({{shape, slanted, pointed}, {shape}})).stack;
  const Grid grid = make_grid(stack, {.columns = 10, .rows = 10, .splits = {}});
  ASSERT_EQ(grid.x(1), 0.5);
  const Field field = sample_field(stack, "tooth", grid, {FieldKind::sign});
  std::vector<std::pair<double, double>> zeros;
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      if (field.values[grid.index(i, j, 1)] == 0) zeros.push_back({grid.x(i), grid.y(j)});
  const std::vector<std::pair<double, double>> expected{{0.5, 2.5}, {0.5, 3.5}, {1.5, 3.5}, {0.5, 4.5},
                                                        {2.5, 4.5}, {0.5, 5.5}, {3.5, 5.5}, {0.5, 6.5},
                                                        {1.5, 6.5}, {2.5, 6.5}, {6.5, 6.5}};
  EXPECT_EQ(zeros, expected);
  EXPECT_EQ(field.values[grid.index(2, 5, 1)], 1) << "in the hole";
  EXPECT_EQ(field.values[grid.index(5, 2, 1)], -1) << "beside it";
}

TEST(Field, HybridHoldsDistancesInCrossedVoxelsOnly) {
  const ContourStack stack = ordered(annulus_over_shifted_annulus()).stack;
  const Grid grid = make_grid(stack, {.columns = 40, .rows = 40, .splits = {}});
  const Field hybrid = sample_field(stack, "tooth", grid, {FieldKind::hybrid});
  const Field full = sample_field(stack, "tooth", grid, {FieldKind::signed_distance});
  const Field sign = sample_field(stack, "tooth", grid, {FieldKind::sign});
  const auto crossed = [&](std::size_t i, std::size_t j) {  // between the two slices
    int inside = 0;
    for (int c = 0; c < 8; ++c) inside += sign.values[grid.index(i + (c & 1), j + (c >> 1 & 1), 1 + (c >> 2))] < 0;
    return inside > 0 && inside < 8;
  };
  std::size_t distances = 0;
  for (std::size_t k = 1; k <= 2; ++k)
    for (std::size_t j = 0; j < grid.rows; ++j)
      for (std::size_t i = 0; i < grid.columns; ++i) {
        bool wanted = false;
        for (std::size_t b = j == 0 ? 0 : j - 1; b <= j && b + 1 < grid.rows; ++b)
          for (std::size_t a = i == 0 ? 0 : i - 1; a <= i && a + 1 < grid.columns; ++a)
            wanted = wanted || crossed(a, b);
        const std::size_t at = grid.index(i, j, k);
        EXPECT_EQ(hybrid.values[at], wanted ? full.values[at] : sign.values[at]);
        distances += wanted;
      }
  EXPECT_GT(distances, 300u);
  EXPECT_LT(distances, 1600u);
}

TEST(Field, EmptyLayersHoldPlusOne) {
  const ContourStack stack = ordered(empty_slice_between()).stack;
  const Grid grid = make_grid(stack, {.columns = 12, .rows = 12, .splits = {0.25}});
  ASSERT_EQ(grid.layers.size(), stack.slices.size() + 3);
  EXPECT_EQ(grid.layers[2].z, 0.25);
  for (const FieldKind kind : {FieldKind::signed_distance, FieldKind::sign, FieldKind::hybrid}) {
    const Field field = sample_field(stack, "tooth", grid, {kind});
    for (std::size_t k = 0; k < grid.layers.size(); ++k) {
      const bool empty = !grid.layers[k].slice || stack.slices[*grid.layers[k].slice].contours.empty();
      const auto first = field.values.begin() + std::ptrdiff_t(k * grid.layer_size());
      EXPECT_EQ(std::all_of(first, first + std::ptrdiff_t(grid.layer_size()), [](double v) { return v == 1; }), empty)
          << k;
    }
  }
}

TEST(Grid, ReachesHalfASpacingBeyondTheContoursAndOneLayerBeyondTheEnds) {
  ContourStack stack =
      stack_of({{rectangle({1, 2}, {5, 4})}, {rectangle({1, 2}, {4, 4})}, {rectangle({2, 2}, {4, 4})}});
  stack.slices[2].z = 3;  // uneven: 0, 0.5, 3
  const Grid grid = make_grid(stack, {.columns = 10, .rows = 6, .splits = {}});
  EXPECT_EQ(grid.dx, 0.5);
  EXPECT_EQ(grid.dy, 0.5);
  EXPECT_EQ(grid.x(0), 0.75);
  EXPECT_EQ(grid.x(9), 5.25);
  EXPECT_EQ(grid.y(5), 4.25);
  std::vector<double> heights;
  for (const GridLayer& layer : grid.layers) heights.push_back(layer.z);
  EXPECT_EQ(heights, (std::vector<double>{-0.5, 0, 0.5, 3, 5.5}));
}

TEST(Grid, RefusesWhatCannotBe) {
  const ContourStack stack = annulus_over_disc();
  const auto refused = [&](GridOptions options, std::size_t structures = 1) {
    EXPECT_THROW(make_grid(stack, options, structures), UsageError);
  };
  refused({.columns = 3, .rows = 10, .splits = {}});
  refused({.columns = 10, .rows = 100'000, .splits = {}});
  EXPECT_NO_THROW(make_grid(stack, {.columns = 8'192, .rows = 8'192, .splits = {}}));  // 4 layers: exactly the limit
  refused({.columns = 8'192, .rows = 8'192, .splits = {0.25}});
  refused({.columns = 8'192, .rows = 8'192, .splits = {}}, 2);
  for (const double split : {-1.0, 0.0, 0.5, 7.0, std::numeric_limits<double>::quiet_NaN()}) refused({10, 10, {split}});
  refused({10, 10, {0.2, 0.2}});
  const ContourStack far = moved(scaled(stack, 1e-9), {1e6, 1e6});  // spacing below a unit in the last place
  EXPECT_THROW(make_grid(far, {.columns = 1'000, .rows = 1'000, .splits = {}}), UsageError);
}

}  // namespace
}  // namespace odontoscope::test
