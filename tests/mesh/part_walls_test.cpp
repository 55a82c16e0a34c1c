// Walls that surfaces share, after vertices were joined by place.

#include "recon/mesh/part_walls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/mesh/surface_report.h"
#include "tests/mesh/shapes.h"

namespace odontoscope::test {
namespace {

/// Joined by place, then parted where walls are shared.
SurfaceMesh parted(const SurfaceMesh& soup) {
  SurfaceMesh mesh = weld(soup);
  part_walls(mesh);
  return mesh;
}

/// A prism over a triangle a, b, c (counter-clockwise) from z = 0 to 1.
SurfaceMesh prism(Point2 a, Point2 b, Point2 c) {
  SurfaceMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const Point2& p : {a, b, c}) mesh.points.push_back({p.x, p.y, z});
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}};
  // The same diagonal from either side of a wall: from the corner that comes first by x, then y, below.
  for (PointIndex i = 0; i < 3; ++i) {
    const PointIndex j = (i + 1) % 3;
    const Point3 &p = mesh.points[i], &q = mesh.points[j];
    const bool first = p.x < q.x || (p.x == q.x && p.y < q.y);
    if (first)
      mesh.triangles.insert(mesh.triangles.end(), {{i, j, j + 3}, {i, j + 3, i + 3}});
    else
      mesh.triangles.insert(mesh.triangles.end(), {{i, j, i + 3}, {j, j + 3, i + 3}});
  }
  return mesh;
}

/// `count` prisms round the z axis, without gap between them but after the last if `open`.
SurfaceMesh pie(int count, bool open) {
  SurfaceMesh all;
  const int slices = open ? count + 1 : count;
  for (int k = 0; k < count; ++k) {
    const double from = 2 * M_PI * k / slices, to = 2 * M_PI * ((k + 1) % slices) / slices;
    all = shapes::together(all, prism({0, 0}, {std::cos(from), std::sin(from)}, {std::cos(to), std::sin(to)}));
  }
  return all;
}

TEST(PartWalls, OfTwoCubesFaceToFace) {
  const SurfaceMesh cubes = shapes::together(shapes::cube(0, 0, 0), shapes::cube(0, 0, 1));
  EXPECT_FALSE(inspect(weld(cubes)).closed_oriented_manifold());
  const SurfaceReport report = inspect(parted(cubes));
  EXPECT_TRUE(report.closed_oriented_manifold());
  ASSERT_EQ(report.shells.size(), 2u);
  for (const Shell& shell : report.shells) EXPECT_DOUBLE_EQ(shell.volume, 1);
}

TEST(PartWalls, RoundAnEdgeInWhichSeveralMeet) {
  for (const int count : {2, 3, 4, 7})
    for (const bool open : {false, true}) {
      if (count == 2 && !open) continue;  // half circles have no inside as triangles
      const SurfaceReport report = inspect(parted(pie(count, open)));
      EXPECT_TRUE(report.closed_oriented_manifold()) << count << open;
      ASSERT_EQ(report.shells.size(), static_cast<std::size_t>(count)) << open;
      for (const Shell& shell : report.shells) EXPECT_GT(shell.volume, 0) << count << open;
    }
}

TEST(PartWalls, OfACubeInACavity) {
  const SurfaceMesh core = shapes::cube(1, 1, 1);
  const SurfaceMesh all = shapes::together(shapes::together(shapes::cube(0, 0, 0, 3), shapes::inside_out(core)), core);
  const SurfaceReport report = inspect(parted(all));
  EXPECT_TRUE(report.closed_oriented_manifold());
  EXPECT_EQ(report.shells.size(), 3u);
}

TEST(PartWalls, LeavesWhatOnlyTouches) {
  for (const SurfaceMesh& mesh : {shapes::cubes_on_one_edge(), shapes::cubes_on_one_vertex()}) {
    SurfaceMesh same = mesh;
    EXPECT_EQ(part_walls(same), 0u);
    EXPECT_EQ(same.triangles, mesh.triangles);
    EXPECT_FALSE(inspect(same).closed_oriented_manifold());
  }
}

TEST(PartWalls, LeavesFinsWhoseTwoSidesAreOneSurface) {
  SurfaceMesh fin = shapes::cube();
  const auto tip = static_cast<PointIndex>(fin.points.size());
  fin.points.push_back({0.5, 0.5, 9});
  const auto [a, b, c] = fin.triangles[0];
  fin.triangles.push_back({a, b, tip});
  fin.triangles.push_back({b, a, tip});
  EXPECT_EQ(part_walls(fin), 0u);
  EXPECT_FALSE(inspect(fin).closed_oriented_manifold());
}

}  // namespace
}  // namespace odontoscope::test
