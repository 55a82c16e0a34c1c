// A partition with fewer triangles: structures still share their walls to the bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "recon/mesh/self_intersection.h"
#include "recon/output/simplify_model.h"
#include "recon/partition/reconstruct_partition.h"

namespace odontoscope {
namespace {

/// Enamel round dentine round pulp; enamel ends half way up, pulp reaches the lowest slice.
ContourStack little_tooth() {
  ContourStack stack;
  const auto add = [&](const char* structure, double radius) {
    Contour contour{structure, {}};
    constexpr int corners = 40;
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * std::numbers::pi * i / corners;
      contour.points.push_back({radius * std::cos(turn), 0.8 * radius * std::sin(turn)});
    }
    stack.slices.back().contours.push_back(std::move(contour));
  };
  for (int k = 0; k < 8; ++k) {
    stack.slices.push_back({0.4 * k, {}});
    if (k > 3) add("enamel", 3 - 0.1 * k);
    if (k < 7) add("dentine", 2.2 - 0.05 * k);
    if (k < 5) add("pulp", 0.6 + 0.1 * k);
  }
  return stack;
}

using Place = std::tuple<double, double, double>;
using Wall = std::set<Place>;  // the corners of a triangle

std::set<Wall> walls_of(const SurfaceMesh& surface) {
  std::set<Wall> walls;
  for (const Triangle& t : surface.triangles) {
    Wall wall;
    for (const PointIndex v : t) wall.insert({surface.points[v].x, surface.points[v].y, surface.points[v].z});
    walls.insert(wall);
  }
  return walls;
}

const Solid& named(const Reconstruction& made, const std::string& structure) {
  return *std::find_if(made.solids.begin(), made.solids.end(),
                       [&](const Solid& solid) { return solid.structure == structure; });
}

TEST(SimplifyPartition, SharesItsWallsToTheBit) {
  Reconstruction made = reconstruct_partition(little_tooth());
  std::size_t before = 0;
  for (const Solid& solid : made.solids) before += solid.surface.triangles.size();
  const std::size_t tetrahedra = made.complex->mesh.tetrahedra.size();
  constexpr std::size_t aim = 800;
  ASSERT_GT(before, 2 * aim);

  const ModelSimplification done = simplify_surfaces(made, aim);
  ASSERT_TRUE(done.aim);
  EXPECT_TRUE(done.aim->reached());
  ASSERT_EQ(done.structures.size(), 3u);
  std::size_t after = 0;
  for (const Solid& solid : made.solids) {
    SCOPED_TRACE(solid.structure);
    after += solid.surface.triangles.size();
    EXPECT_TRUE(solid.report.closed_oriented_manifold());
    EXPECT_TRUE(self_intersections(solid.surface).empty());
  }
  EXPECT_LE(after, aim);
  EXPECT_EQ(done.aim->triangles, after);
  for (const StructureSimplification& one : done.structures) EXPECT_LT(one.distance.mean(), 0.02) << one.structure;

  // All of the pulp's wall but its bottom is the dentine's or the enamel's.
  const auto enamel = walls_of(named(made, "enamel").surface), dentine = walls_of(named(made, "dentine").surface),
             pulp = walls_of(named(made, "pulp").surface);
  std::size_t alone = 0;
  for (const Wall& wall : pulp) alone += !dentine.count(wall) && !enamel.count(wall);
  EXPECT_GT(alone, 0u);
  EXPECT_LT(alone, pulp.size() / 2);
  EXPECT_EQ(made.complex->mesh.tetrahedra.size(), tetrahedra);
}

}  // namespace
}  // namespace odontoscope
