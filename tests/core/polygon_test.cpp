// Polygons of the plane against what is known by hand.

#include "recon/core/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace odontoscope {
namespace {

const Polygon square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

Polygon moved(Polygon polygon, double x, double y) {
  for (Point2& p : polygon) p = {p.x + x, p.y + y};
  return polygon;
}

TEST(Polygon, AreaIsPositiveCounterClockwiseAndNegativeClockwise) {
  EXPECT_EQ(signed_area(square), 4);
  EXPECT_EQ(signed_area({square.rbegin(), square.rend()}), -4);
  EXPECT_EQ(signed_area({{0, 0}, {1, 1}}), 0);
  EXPECT_EQ(signed_area({}), 0);
}

TEST(Polygon, LosesNothingFarFromTheOrigin) {
  const Polygon far = moved({{0, 0}, {0.5, 0}, {0.5, 0.25}, {0, 0.25}}, 1 << 20, -(1 << 21));
  EXPECT_EQ(signed_area(far), 0.125);
  EXPECT_EQ(centroid(far), (Point2{(1 << 20) + 0.25, -(1 << 21) + 0.125}));
}

TEST(Polygon, CentroidIsThatOfTheAreaNotOfTheCorners) {
  const Polygon l_shape = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_NEAR(centroid(l_shape).x, (1.5 * 3 + 0.5 * 2) / 5, 1e-15);
  EXPECT_NEAR(centroid(l_shape).y, (0.5 * 3 + 2 * 2) / 5.0, 1e-15);
  EXPECT_EQ(centroid({{7, 5}, {8, 6}, {9, 7}}), (Point2{7, 5}));  // encloses nothing
}

TEST(Polygon, HolesTakeAwayFromMoments) {
  AreaMoments ring(square);
  ring.add({{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}});
  EXPECT_EQ(ring.signed_area(), 3);
  EXPECT_EQ(ring.centroid(), (Point2{1, 1}));
  // (4 * 2/3 - 1 * 1/6) / 3: mean squares of squares of side 2 and 1 about their middle.
  EXPECT_NEAR(ring.mean_square(), (4 * (2.0 / 3) - 1.0 / 6) / 3, 1e-15);
}

TEST(Polygon, ACornerAsHighAsThePlaceIsMetOnce) {
  const Polygon diamond = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (const Polygon& either : {diamond, Polygon(diamond.rbegin(), diamond.rend())}) {
    EXPECT_TRUE(encloses(either, {0, 0}));
    EXPECT_FALSE(encloses(either, {-2, 0}));
    EXPECT_FALSE(encloses(either, {-2, 1}));
    EXPECT_FALSE(encloses(either, {-2, -1}));
  }
  const Polygon notched = {{0, 0}, {4, 0}, {4, 2}, {3, 1}, {2, 2}, {1, 1}, {0, 2}};
  EXPECT_TRUE(encloses(notched, {0.5, 1}));
  EXPECT_FALSE(encloses(notched, {-0.5, 1}));
  EXPECT_FALSE(encloses(notched, {2, 2.5}));
}

TEST(Polygon, TheCallersPredicateDecidesWhatTheRayCrosses) {
  int asked = 0;
  encloses(square, {1, 1}, [&](const Point2&, const Point2&) { return ++asked > 0; });
  EXPECT_EQ(asked, 2);  // of the upright edges alone
  EXPECT_TRUE(encloses(square, {9, 1}, [](const Point2& a, const Point2&) { return a.x > 0; }));
}

TEST(Polygon, WindingCountsTurnsWhereParityCannot) {
  Polygon twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_EQ(winding(twice, {1, 1}), 2);
  EXPECT_FALSE(encloses(twice, {1, 1}));
  EXPECT_EQ(winding({square.rbegin(), square.rend()}, {1, 1}), -1);
  EXPECT_EQ(winding(square, {3, 1}), 0);
}

TEST(Polygon, DistanceGoesToTheNearestEdgeOrItsEnd) {
  EXPECT_EQ(distance_to_edge({1, 3}, {0, 0}, {2, 0}), 3);
  EXPECT_EQ(distance_to_edge({5, 4}, {0, 0}, {2, 0}), 5);
  EXPECT_EQ(distance_to_edge({3, 4}, {0, 0}, {0, 0}), 5);
  EXPECT_EQ(nearest_share({9, 9}, {1, 1}, {1, 1}), 0);
  EXPECT_EQ(distance_to_border({1, 1.5}, square), 0.5);
  EXPECT_EQ(distance_to_border({-1, 1}, square), 1);  // the last edge
}

}  // namespace
}  // namespace odontoscope
