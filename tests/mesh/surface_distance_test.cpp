#include "recon/mesh/surface_distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

TEST(SurfaceDistance, ZeroToItself) {
  const SurfaceMesh mesh = shapes::cube();
  const auto distance = surface_distance(mesh, mesh);
  ASSERT_TRUE(distance);
  EXPECT_LT(distance->largest(), 1e-12);
}

TEST(SurfaceDistance, ConcentricSpheresAreTheirRadiiApart) {
  const auto distance = surface_distance(shapes::sphere(5, 6), shapes::sphere(6, 6));
  ASSERT_TRUE(distance);
  EXPECT_NEAR(distance->a_to_b.mean, 1, 0.002);
  EXPECT_NEAR(distance->b_to_a.largest, 1, 0.002);
}

TEST(SurfaceDistance, ShiftedCubeByHand) {
  // From the unit cube to itself moved by 0.5 along x: of the six faces one is 0.5 away, one lies in the other's
  // inside at 0.5 from its nearest face or nearer to a side, and the other four are half covered.
  const auto distance = surface_distance(shapes::cube(), shapes::cube(0.5));
  ASSERT_TRUE(distance);
  EXPECT_NEAR(distance->a_to_b.largest, 0.5, 1e-12);
  // Four faces: distance 0 over half and 0 to 0.5 over half, mean 0.125. Face x = 0: 0.5 everywhere. Face x = 1:
  // distance to the sides of a square, at most 0.5: mean 1/6.
  EXPECT_NEAR(distance->a_to_b.mean, (4 * 0.125 + 0.5 + 1.0 / 6) / 6, 1e-4);
  EXPECT_NEAR(distance->b_to_a.mean, distance->a_to_b.mean, 1e-4);
}

TEST(SurfaceDistance, IsOneSided) {
  const SurfaceMesh part = shapes::cube(), whole = shapes::together(shapes::cube(), shapes::cube(10));
  const auto distance = surface_distance(part, whole);
  ASSERT_TRUE(distance);
  EXPECT_LT(distance->a_to_b.largest, 1e-12);
  EXPECT_NEAR(distance->b_to_a.largest, 10, 1e-12);
  EXPECT_GT(distance->mean(), 4);
}

TEST(SurfaceDistance, NothingToMeasure) {
  EXPECT_FALSE(surface_distance({}, shapes::cube()));
  EXPECT_FALSE(surface_distance(shapes::cube(), {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}));
}

TEST(SurfaceDistance, ThreadsChangeNoBit) {
  const auto with_threads = [&](std::size_t n) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n);
    return *surface_distance(shapes::sphere(5, 4), shapes::torus(5, 1, 40, 20));
  };
  const SurfaceDistance one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.a_to_b.mean, four.a_to_b.mean);
  EXPECT_EQ(one.b_to_a.mean, four.b_to_a.mean);
  EXPECT_EQ(one.largest(), four.largest());
}

}  // namespace
}  // namespace odontoscope
