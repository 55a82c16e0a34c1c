// The nearest place of a triangle and of a surface against looking everywhere.

#include "recon/mesh/surface_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

Point3 place_on(const Corners& t, double s, double r) {
  const Direction on = s * (t[1] - t[0]) + r * (t[2] - t[0]);
  return {t[0].x + on.x, t[0].y + on.y, t[0].z + on.z};
}

/// By steps over the triangle: never nearer than the nearest, and hardly farther.
double by_steps(const Corners& t, const Point3& from, int steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k + i <= steps; ++k)
      least = std::min(least, length(from - place_on(t, double(i) / steps, double(k) / steps)));
  return least;
}

class Numbers {
 public:
  double next() { return -2 + 4 * (static_cast<double>(random_() % 65536) / 65536); }
  Point3 place() { return {next(), next(), next()}; }

 private:
  std::mt19937 random_{7};
};

void expect_nearest(const Corners& t, const Point3& from) {
  const OnTriangle on = nearest_on_triangle(t[1] - t[0], t[2] - t[0], from - t[0]);
  ASSERT_TRUE(on.s >= 0 && on.t >= 0 && on.s + on.t <= 1 + 1e-12) << on.s << " " << on.t;
  const double found = length(from - place_on(t, on.s, on.t)), known = by_steps(t, from, 60);
  const double step = (length(t[1] - t[0]) + length(t[2] - t[0])) / 60;
  EXPECT_LE(found, known + 1e-12);
  EXPECT_GE(found, known - step);
}

TEST(NearestOnTriangle, IsWhereLookingEverywhereFindsIt) {
  Numbers numbers;
  for (int i = 0; i < 300; ++i) expect_nearest({numbers.place(), numbers.place(), numbers.place()}, numbers.place());
}

TEST(NearestOnTriangle, KnowsCornersEdgesAndInside) {
  const Direction ab{2, 0, 0}, ac{0, 2, 0};
  const auto feature = [&](double x, double y) { return nearest_on_triangle(ab, ac, {x, y, 1}).feature; };
  EXPECT_EQ(feature(-1, -1), 0);
  EXPECT_EQ(feature(3, -1), 1);
  EXPECT_EQ(feature(-1, 3), 2);
  EXPECT_EQ(feature(1, -1), 3);
  EXPECT_EQ(feature(2, 2), 4);
  EXPECT_EQ(feature(-1, 1), 5);
  EXPECT_EQ(feature(0.5, 0.5), 6);
}

TEST(NearestOnTriangle, HoldsForNeedlesAndTrianglesWithoutArea) {
  Numbers numbers;
  for (int i = 0; i < 200; ++i) {
    const Point3 a = numbers.place(), b = numbers.place(), from = numbers.place();
    const Corners edge = {a, b, b};
    for (const double share : {0.0, 0.3, 1.0, 1.7, -0.4}) {
      const Point3 on_line = place_on(edge, share, 0);
      for (const double off : {0.0, 1e-15, 1e-9, 1e-4}) {
        const Point3 c{on_line.x + off, on_line.y, on_line.z - off};
        expect_nearest({a, b, c}, from);
        expect_nearest({c, a, b}, from);
        expect_nearest({b, c, a}, from);
      }
    }
    expect_nearest({a, a, a}, from);
  }
}

TEST(SurfaceTree, FindsTheNearestOfAllTriangles) {
  const SurfaceMesh surface = shapes::together(shapes::torus(1, 0.4, 24, 12), shapes::sphere(0.3, 2));
  const SurfaceTree tree(surface);
  ASSERT_EQ(tree.size(), surface.triangles.size());
  Numbers numbers;
  for (int i = 0; i < 300; ++i) {
    const Point3 from = numbers.place();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface.triangles)
      least = std::min(least, distance_to({surface.points[a], surface.points[b], surface.points[c]}, from));
    const SurfaceTree::Nearest found = tree.nearest(from);
    ASSERT_TRUE(found.found());
    EXPECT_NEAR(std::sqrt(found.square), least, 1e-12);
    EXPECT_NEAR(length(from - found.at), least, 1e-12);
    const auto& [a, b, c] = surface.triangles[found.triangle];
    EXPECT_NEAR(distance_to({surface.points[a], surface.points[b], surface.points[c]}, from), least, 1e-12);
    EXPECT_FALSE(tree.nearest(from, 0.99 * least * least).found());
    EXPECT_TRUE(tree.nearest(from, 1.01 * least * least).found());
  }
}

TEST(SurfaceTree, OfNothingFindsNothing) {
  EXPECT_TRUE(SurfaceTree().empty());
  EXPECT_FALSE(SurfaceTree().nearest({0, 0, 0}).found());
  EXPECT_FALSE(SurfaceTree(std::vector<Corners>{}).nearest({0, 0, 0}).found());
}

}  // namespace
}  // namespace odontoscope
