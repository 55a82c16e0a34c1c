// Which voids does a model have?

#include "recon/cavity/cavity.h"

#include <gtest/gtest.h>

#include "recon/cavity/wall_tree.h"
#include "tests/cavity/section_oracle.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

using shapes::cube;
using shapes::inside_out;
using shapes::moved;
using shapes::sphere;
using shapes::together;

/// A ball of 10 with two bubbles and a speck.
SurfaceMesh cheese() {
  const SurfaceMesh small = moved(inside_out(sphere(1, 3)), -4, 0, 0), large = moved(inside_out(sphere(2, 3)), 4, 0, 0);
  const SurfaceMesh speck = moved(inside_out(sphere(0.1, 1)), 0, 5, 0);
  return together(together(sphere(10, 4), small), together(speck, large));
}

TEST(Cavities, AreTheShellsOfNegativeVolumeLargestFirst) {
  const std::vector<Cavity> found = cavities_of("cheese", cheese());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].structure, "cheese");
  const double unit_ball = 4.18879;
  EXPECT_GT(found[0].volume, 0.95 * 8 * unit_ball);
  EXPECT_LT(found[0].volume, 8 * unit_ball);
  EXPECT_GT(found[1].volume, 0.95 * unit_ball);
  EXPECT_LT(found[1].volume, unit_ball);
  for (const Cavity& cavity : found) {
    const SurfaceReport report = inspect(cavity.wall);
    EXPECT_TRUE(report.closed_oriented_manifold());
    ASSERT_EQ(report.shells.size(), 1u);
    EXPECT_EQ(report.shells[0].kind, Shell::Kind::cavity);
    EXPECT_EQ(report.vertices, cavity.wall.points.size());
  }
}

TEST(Cavities, OfASolidWithoutAnyAreNone) {
  EXPECT_TRUE(cavities_of("block", cube()).empty());
  EXPECT_TRUE(cavities_of("nothing", {}).empty());
  EXPECT_TRUE(cavities_of("open", shapes::holed(inside_out(cube()))).empty());
}

TEST(Cavities, OfAWholeModelComeBeforeABodyOfPulp) {
  const SurfaceMesh hollow = cheese(), pulp = sphere(1.5, 3), block = cube();
  EXPECT_EQ(cavities_in({{"dentine", &hollow}, {"pulp", &pulp}}).front().structure, "dentine");
  const std::vector<Cavity> from_body = cavities_in({{"dentine", &block}, {"URI1_Pulp", &pulp}});
  ASSERT_EQ(from_body.size(), 1u);
  EXPECT_EQ(from_body[0].structure, "URI1_Pulp");
  EXPECT_EQ(inspect(from_body[0].wall).shells[0].kind, Shell::Kind::cavity);
  EXPECT_TRUE(cavities_in({{"dentine", &block}}).empty());
}

TEST(Cavities, ThatAreSpecksBesideABodyOfPulpAreNone) {
  const auto block_with_bubble = [](double size) {
    SurfaceMesh bubble = cube(8, 8, 8, size);
    for (Triangle& t : bubble.triangles) std::swap(t[1], t[2]);
    return together(cube(0, 0, 0, 20), bubble);
  };
  const SurfaceMesh pulp = cube(1, 1, 1, 5);  // 125 mm^3
  const SurfaceMesh speck = block_with_bubble(0.49),
                    bubble = block_with_bubble(0.51);  // a thousandth has edges of 0.5 mm
  const std::vector<Cavity> from_body = cavities_in({{"dentine", &speck}, {"pulp", &pulp}});
  ASSERT_EQ(from_body.size(), 1u);
  EXPECT_EQ(from_body[0].structure, "pulp");
  EXPECT_TRUE(from_body[0].body);
  EXPECT_EQ(cavities_in({{"dentine", &bubble}, {"pulp", &pulp}}).front().structure, "dentine");
  EXPECT_EQ(cavities_in({{"dentine", &speck}}).front().structure, "dentine");
}

TEST(WallTree, KnowsTheDistanceThatAllTrianglesTellAndTheSide) {
  const SurfaceMesh wall = inside_out(sphere(2, 3));
  const WallTree tree(wall);
  int front = 0, behind = 0;
  for (double x = -3; x <= 3; x += 0.61) {
    for (double y = -3; y <= 3; y += 0.73) {
      for (double z = -3; z <= 3; z += 0.57) {
        const Point3 p{x, y, z};
        const double clear = tree.clearance(p), distance = test::brute_distance(wall, p);
        ASSERT_NEAR(std::abs(clear), distance, 1e-12);
        if (std::hypot(x, y, z) < 1.9) {
          EXPECT_GT(clear, 0);
          ++front;
        } else if (std::hypot(x, y, z) > 2) {
          EXPECT_LT(clear, 0);
          ++behind;
        }
        const double least = 0.5 * distance, above = tree.clearance_above(p, least);
        if (clear > least)
          EXPECT_EQ(above, clear);
        else
          EXPECT_LE(above, least);
        EXPECT_LE(tree.clearance_above(p, 1.5 * distance), 1.5 * distance);
      }
    }
  }
  EXPECT_GT(front, 50);
  EXPECT_GT(behind, 50);
}

TEST(WallTree, KnowsTheSideBesideSharpEdgesAndCorners) {
  const SurfaceMesh wall = cube();  // fronts outside
  const WallTree tree(wall);
  EXPECT_LT(tree.clearance({0.1, 0.1, 0.1}), 0);
  EXPECT_GT(tree.clearance({-0.1, -0.1, -0.1}), 0);  // a corner is nearest
  EXPECT_GT(tree.clearance({-0.1, -0.1, 0.5}), 0);   // an edge is nearest
  EXPECT_GT(tree.clearance({1.1, 1.1, 0.3}), 0);
  EXPECT_GT(tree.clearance({0.5, 0.2, 1.3}), 0);
}

}  // namespace
}  // namespace odontoscope
