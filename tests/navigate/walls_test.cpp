// Distances, sides and crossings against answers worked out otherwise.

#include "engine/navigate/walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/navigate/cavities.h"
#include "tests/render/shapes.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

using testing_support::ball;
using testing_support::box;
using testing_support::ring;

/// To a triangle by another way than the program's: on a fine net of it, then finer round the best place. From above,
/// and close.
double far_from_triangle(const std::array<glm::dvec3, 3>& t, const glm::dvec3& place) {
  double u = 1.0 / 3, v = 1.0 / 3, best = 1e300;
  for (double reach = 1; reach > 1e-9; reach *= 0.55) {
    const double from_u = u, from_v = v;
    for (int i = -6; i <= 6; ++i)
      for (int j = -6; j <= 6; ++j) {
        double a = std::clamp(from_u + reach * i / 6, 0.0, 1.0), b = std::clamp(from_v + reach * j / 6, 0.0, 1.0);
        if (a + b > 1) {
          const double over = (a + b - 1) / 2;
          a = std::clamp(a - over, 0.0, 1.0);
          b = 1 - a;
        }
        const double far = glm::length(t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]) - place);
        if (far < best) {
          best = far;
          u = a;
          v = b;
        }
      }
  }
  return best;
}

std::array<glm::dvec3, 3> corners(const SurfaceMesh& mesh, std::size_t t) {
  std::array<glm::dvec3, 3> at;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = mesh.points[mesh.triangles[t][i]];
    at[i] = {p.x, p.y, p.z};
  }
  return at;
}

TEST(Walls, NearestIsWhatSearchingEveryTriangleFinds) {
  const SurfaceMesh mesh = ring({.radius = 4, .tube = 1.5, .around = 14, .across = 7});
  const Walls walls(mesh);
  EXPECT_EQ(walls.size(), mesh.triangles.size());
  RandomNumbers random(1);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 place(random.between(-7, 7), random.between(-7, 7), random.between(-3, 3));
    double best = 1e300;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      best = std::min(best, far_from_triangle(corners(mesh, t), place));
    const Walls::Nearest found = walls.nearest(place);
    EXPECT_NEAR(found.distance, best, 1e-6);
    EXPECT_NEAR(found.distance, glm::length(found.point - place), 1e-12);
    EXPECT_FALSE(std::isfinite(walls.nearest(place, 0.999 * found.distance).distance));
    EXPECT_EQ(walls.nearest(place, 1.001 * found.distance).distance, found.distance);
  }
}

TEST(Walls, TrianglesWithoutAreaAreWallsToo) {
  SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}, {3, 3, 3}}};
  const Walls walls(mesh);
  EXPECT_DOUBLE_EQ(walls.nearest({1.5, 2, 0}).distance, 2);
  EXPECT_DOUBLE_EQ(walls.nearest({5, 5, 7}).distance, 2);
}

TEST(Walls, NoneIsFarAwayAndHoldsNothing) {
  const Walls walls;
  EXPECT_TRUE(walls.empty());
  EXPECT_TRUE(std::isinf(walls.nearest({0, 0, 0}).distance));
  EXPECT_EQ(walls.locate({0, 0, 0}), Walls::Side::outside);
  EXPECT_FALSE(walls.crosses({0, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(place_of_largest_clearance(walls));
}

TEST(Walls, LocatesExactlyToTheLastBitOfACoordinate) {
  const Walls walls(box({0, 0, 0}, {1, 1, 1}));
  for (const double x : {0.5, 0.25, 1.0 / 3}) {
    EXPECT_EQ(walls.locate({x, 0.5, 0.5}), Walls::Side::inside);
    EXPECT_EQ(walls.locate({x, 0.5, std::nextafter(1.0, 0.0)}), Walls::Side::inside);
    EXPECT_EQ(walls.locate({x, 0.5, std::nextafter(1.0, 2.0)}), Walls::Side::outside);
    EXPECT_EQ(walls.locate({x, 0.5, 1.0}), Walls::Side::on_wall);
  }
  EXPECT_EQ(walls.locate({1, 1, 1}), Walls::Side::on_wall);
  EXPECT_EQ(walls.locate({2, 0.5, 0.5}), Walls::Side::outside);
}

TEST(Walls, WindingSaysNothingAboutSides) {
  const Walls inwards(testing_support::reversed(ball({{0, 0, 0}, 3})));
  EXPECT_EQ(inwards.locate({0.1, 0.2, 0.3}), Walls::Side::inside);
  EXPECT_EQ(inwards.locate({4, 0, 0}), Walls::Side::outside);
}

TEST(Walls, AWayThatGrazesAnEdgeTouchesIt) {
  const Walls walls(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(walls.crosses({0.5, 0.5, 0.5}, {0.5, 0.5, 1.5}));
  EXPECT_FALSE(walls.crosses({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}));
  EXPECT_TRUE(walls.crosses({-1, 1, 0.5}, {1, 1, 0.5}));         // in the plane of a face
  EXPECT_TRUE(walls.crosses({0.5, 1.5, 0.5}, {1.5, 0.5, 0.5}));  // through the edge at x = y = 1 only
  EXPECT_FALSE(walls.crosses({0.5, std::nextafter(1.5, 2), 0.5}, {1.5, std::nextafter(0.5, 2), 0.5}));
}

TEST(Walls, SeesAsFarAsTheWallIs) {
  const Walls walls(box({-1, -2, -3}, {1, 2, 3}));
  EXPECT_DOUBLE_EQ(walls.free_distance({0, 0, 0}, {0, 0, 1}), 3);
  EXPECT_TRUE(std::isinf(walls.free_distance({0, 0, 5}, {0, 0, 1})));
  EXPECT_TRUE(std::isinf(walls.free_distance({0, 0, 0}, {0, 0, 1}, 2.5)));
  const std::vector<double> through = walls.meetings({0.1, 0.2, -10}, {0, 0, 1});
  ASSERT_EQ(through.size(), 2u);
  EXPECT_NEAR(through[0], 7, 1e-12);
  EXPECT_NEAR(through[1], 13, 1e-12);
  EXPECT_NEAR(std::abs(longest_free_direction(walls, {0, 0, 0}).z), 3 / std::sqrt(14.0), 0.05);  // into a corner
}

TEST(Walls, TheRoomiestPlaceOfABallIsItsMiddleAndOfARingItsTube) {
  const auto in_ball = place_of_largest_clearance(Walls(ball({{1, 2, 3}, 2, 48})));
  ASSERT_TRUE(in_ball);
  EXPECT_NEAR(glm::length(in_ball->at - glm::dvec3(1, 2, 3)), 0, 0.02);
  EXPECT_NEAR(in_ball->clearance, 2, 0.02);
  const Walls tube(ring({}));
  const auto in_ring = place_of_largest_clearance(tube);
  ASSERT_TRUE(in_ring);
  EXPECT_EQ(tube.locate(in_ring->at), Walls::Side::inside);
  EXPECT_NEAR(in_ring->clearance, 1.5, 0.03);
}

TEST(Walls, TheToothsPulpsHoldTheirRoomiestPlaces) {
  std::vector<const SurfaceMesh*> pulps{&sample_molar_pulp()};
  if (ct_molar_pulp()) pulps.push_back(ct_molar_pulp());
  for (const SurfaceMesh* pulp : pulps) {
    ASSERT_GT(pulp->triangles.size(), 100u);
    const Walls walls(*pulp);
    const auto place = place_of_largest_clearance(walls);
    ASSERT_TRUE(place);
    EXPECT_EQ(walls.locate(place->at), Walls::Side::inside);
    EXPECT_NEAR(walls.nearest(place->at).distance, place->clearance, 1e-12);
  }
}

}  // namespace
}  // namespace odontoscope::test
