// Distances from the data's own surface and slopes there, against fields whose answers are known, and against the
// nearest of all crossings.

#include "engine/scene/deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

/// 30 x 26 x 34 values of `field`, steps of 0.3, 0.4 and 0.25 mm.
template <class Field>
ValueGrid grid_of(Field field) {
  ValueGrid grid;
  grid.size = {30, 26, 34};
  grid.first_mm = {-4.4, -5.1, -4.0};
  grid.step_mm = {0.3, 0.4, 0.25};
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        grid.values.push_back(static_cast<float>(field(grid.first_mm + glm::dvec3(i, j, k) * grid.step_mm)));
  return grid;
}

constexpr double ball_radius = 2.6;
ValueGrid ball() {
  return grid_of([](const glm::dvec3& place) { return 100 + 40 * (ball_radius - glm::length(place)); });
}

/// Lumps with no symmetry, steep and flat.
ValueGrid lumps() {
  return grid_of([](const glm::dvec3& p) {
    return 200 * std::exp(-glm::dot(p, p) / 5) +
           90 * std::exp(-glm::dot(p - glm::dvec3(2.1, 1.2, -1.4), p - glm::dvec3(2.1, 1.2, -1.4)) / 1.5) +
           3 * std::sin(2 * p.x + p.y);
  });
}

/// The nearest of all places where values cross along the lines of a grid so many times as fine: never nearer than the
/// nearest crossing of all.
double nearest_crossing(const ValueGrid& grid, double iso, const glm::dvec3& from, double reach) {
  constexpr double finer = 10;
  const glm::dvec3 step = grid.step_mm / finer;
  double best = 1e9;
  const glm::ivec3 count = glm::ivec3(glm::ceil(reach / step));
  for (int axis = 0; axis < 3; ++axis) {
    const int one = (axis + 1) % 3, other = (axis + 2) % 3;
    for (int a = -count[one]; a <= count[one]; ++a)
      for (int b = -count[other]; b <= count[other]; ++b) {
        glm::dvec3 place = from;
        place[one] += a * step[one];
        place[other] += b * step[other];
        place[axis] -= count[axis] * step[axis];
        double before = value_at(grid, place);
        for (int c = -count[axis]; c < count[axis]; ++c) {
          place[axis] = from[axis] + (c + 1) * step[axis];
          const double after = value_at(grid, place);
          if ((before < iso) != (after < iso)) {
            glm::dvec3 crossing = place;
            crossing[axis] -= step[axis] * (after - iso) / (after - before);
            best = std::min(best, glm::distance(crossing, from));
          }
          before = after;
        }
      }
  }
  return best;
}

TEST(Deviation, FromAPlaneIsExact) {
  const glm::dvec3 slope(30, -12, 18);
  const ValueGrid grid = grid_of([&](const glm::dvec3& place) { return 50 + glm::dot(slope, place); });
  RandomNumbers random(3);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 place(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
    const double wanted = -(value_at(grid, place) - 60) / glm::length(slope);
    const auto found = deviation_at(grid, 60, place, glm::dvec3(random.between(-1, 1), 1, 0));
    if (std::abs(wanted) > deviation_reach_steps * 0.4) continue;
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, wanted, 1e-4);
    EXPECT_NEAR(glm::distance(slope_at(grid, place), slope), 0, 1e-3);
  }
}

// Positive outside the data's ball, where a model of that size would reach beyond the data.
TEST(Deviation, FromABallIsTheDistanceOfItsShell) {
  const ValueGrid grid = ball();
  RandomNumbers random(5);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 way =
        glm::normalize(glm::dvec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
    const double radius = random.between(1.4, 3.6);
    const auto found = deviation_at(grid, 100, radius * way, way);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, radius - ball_radius, 0.02);  // between values the ball is a little flatter
    EXPECT_NEAR(glm::length(slope_at(grid, radius * way)), 40, 1.5);
  }
}

TEST(Deviation, IsThatOfTheNearestOfAllCrossings) {
  const ValueGrid grid = lumps();
  RandomNumbers random(7);
  int judged = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 place(random.between(-2.5, 3), random.between(-2.5, 2.5), random.between(-2.5, 2.5));
    const auto found = deviation_at(grid, 70, place, {random.between(-1, 1), random.between(-1, 1), 0.3});
    if (!found || std::abs(*found) > 0.9) continue;
    const double nearest = nearest_crossing(grid, 70, place, std::abs(*found) + 0.05);
    EXPECT_NEAR(std::abs(*found), nearest, 0.005);
    EXPECT_EQ(*found > 0, value_at(grid, place) < 70);
    ++judged;
  }
  EXPECT_GT(judged, 15);
}

TEST(Deviation, IsNothingFarFromAnyCrossing) {
  const ValueGrid grid = ball();
  EXPECT_FALSE(deviation_at(grid, 100, {-30, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(deviation_at(grid, 1e6, {0, 0, 0}, {1, 0, 0}));
}

/// A square of two triangles at height z.
SurfaceMesh square(double z) { return {{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, {{0, 1, 2}, {0, 2, 3}}}; }

TEST(Deviation, IsMarkedAtPointsAndTheMiddlesOfEdges) {
  const ValueGrid grid = grid_of([](const glm::dvec3& place) { return 10 * place.z; });
  Model model = make_model({{"high", square(0.4)}, {"other", square(1.5)}});
  mark_deviations(model, grid, {{"high", 2}});
  const ModelPart& part = model.parts[0];
  EXPECT_EQ(part.indices.size(), 24u);
  ASSERT_EQ(part.deviations.size(), part.positions.size());
  EXPECT_EQ(part.positions.size(), 9u);  // four corners, four sides and the diagonal
  for (const glm::vec2& each : part.deviations) {
    EXPECT_NEAR(each.x, -0.2f, 1e-4f);  // the value is higher there: the data reach beyond
    EXPECT_NEAR(each.y, 10.0f, 1e-3f);
  }
  EXPECT_TRUE(model.parts[1].deviations.empty());
  const auto summary = deviations_in(model);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->positions, 9u);
  EXPECT_NEAR(summary->most_mm, 0.2, 1e-4);
  EXPECT_NEAR(summary->median_mm, 0.2, 1e-4);
  EXPECT_NEAR(summary->usual_slope, 10, 1e-3);
  EXPECT_NEAR(summary->most_at_mm.z, 0.4, 1e-5);
}

}  // namespace
}  // namespace odontoscope::test
