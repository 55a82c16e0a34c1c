// The order in which points are inserted into a triangulation.
#include "recon/core/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace odontoscope {
namespace {

std::vector<Point2> strewn(std::size_t count) {
  std::mt19937_64 random(11);
  std::vector<Point2> points;
  // Bits of the generator, since a library's distributions are its own.
  const auto number = [&random] { return static_cast<double>(random() >> 40) / 1024; };
  for (std::size_t i = 0; i < count; ++i) points.push_back({number(), number()});
  return points;
}

TEST(SpatialOrder, HasEveryPointOnce) {
  for (const std::size_t count : {0, 1, 2, 17, 1000}) {
    std::vector<std::uint32_t> order = spatial_order(strewn(count));
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(order, all);
  }
}

TEST(SpatialOrder, DependsOnThePlacesAlone) {
  std::vector<Point2> points = strewn(2000);
  const auto in_order = [](const std::vector<Point2>& given) {
    std::vector<Point2> ordered;
    for (const std::uint32_t p : spatial_order(given)) ordered.push_back(given[p]);
    return ordered;
  };
  const std::vector<Point2> before = in_order(points);
  std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), points.begin() + 700, points.end());
  EXPECT_EQ(in_order(points), before);
}

// What every compiler and library must give: a change of it changes the order of triangles in files.
TEST(SpatialOrder, IsTheSameEverywhere) {
  std::vector<Point2> square;
  for (const double x : {0, 1, 2, 3})
    for (const double y : {0, 1, 2, 3}) square.push_back({x, y});
  // Hilbert's curve of the second order, in one round.
  EXPECT_EQ(spatial_order(square), (std::vector<std::uint32_t>{0, 4, 5, 1, 2, 3, 7, 6, 10, 11, 15, 14, 13, 9, 8, 12}));
  const std::vector<std::uint32_t> order = spatial_order(strewn(500));
  EXPECT_EQ(std::vector<std::uint32_t>(order.begin(), order.begin() + 8),
            (std::vector<std::uint32_t>{433, 95, 285, 424, 12, 226, 222, 202}));
}

TEST(SpatialOrder, GoesFromNeighbourToNeighbour) {
  const std::vector<Point2> points = strewn(20'000);
  const auto way = [&points](const std::vector<std::uint32_t>& order) {
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
      sum += std::hypot(points[order[i]].x - points[order[i - 1]].x, points[order[i]].y - points[order[i - 1]].y);
    return sum;
  };
  std::vector<std::uint32_t> as_given(points.size());
  std::iota(as_given.begin(), as_given.end(), 0U);
  EXPECT_LT(way(spatial_order(points)), 0.03 * way(as_given));
}

TEST(SpatialOrder, OfSpaceHasEveryPointOnceAndIsTheSameEverywhere) {
  std::vector<Point3> cube;
  for (const double x : {0, 1})
    for (const double y : {0, 1})
      for (const double z : {0, 1}) cube.push_back({x, y, z});
  EXPECT_EQ(spatial_order(cube), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  std::vector<Point3> points;
  for (const Point2 p : strewn(700)) points.push_back({p.y, p.x, p.x * p.y});
  std::vector<std::uint32_t> order = spatial_order(points);
  EXPECT_EQ(std::vector<std::uint32_t>(order.begin(), order.begin() + 8),
            (std::vector<std::uint32_t>{13, 289, 456, 249, 317, 339, 458, 540}));
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
}

TEST(SpatialOrder, BearsPlacesAsFarApartAsDoublesGo) {
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(spatial_order(std::vector<Point2>{{-most, -most}, {most, most}, {0, 0}, {0, 0}}).size(), 4U);
  EXPECT_EQ(spatial_order(std::vector<Point2>{{5, 5}, {5, 5}}), (std::vector<std::uint32_t>{0, 1}));
}

}  // namespace
}  // namespace odontoscope
