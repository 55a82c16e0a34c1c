// Simplified surfaces keep their shells and holes, stay near, and do not cut through themselves.

#include "recon/mesh/simplify_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "recon/mesh/self_intersection.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

using KindAndGenus = std::pair<Shell::Kind, long>;

std::vector<KindAndGenus> topology(const SurfaceReport& report) {
  std::vector<KindAndGenus> shells;
  for (const Shell& shell : report.shells) shells.emplace_back(shell.kind, shell.genus);
  std::sort(shells.begin(), shells.end());
  return shells;
}

SimplifiedSurface simplified(const SurfaceMesh& mesh, std::size_t triangles) {
  SimplifyOptions options;
  options.triangles = triangles;
  options.distance.samples = 20'000;
  return simplify(mesh, options);
}

void expect_sound(const SurfaceMesh& full, const SimplifiedSurface& result) {
  EXPECT_TRUE(result.report.closed_oriented_manifold());
  EXPECT_EQ(topology(inspect(result.surface)), topology(inspect(full)));
  EXPECT_EQ(result.self_intersections, 0u);
  EXPECT_TRUE(self_intersections(result.surface).empty());
  EXPECT_LE(result.distance.mean(), result.distance.largest());
}

TEST(SelfIntersection, FindsCubesThatPassThroughEachOther) {
  EXPECT_TRUE(self_intersections(shapes::sphere(3, 3)).empty());
  EXPECT_TRUE(self_intersections(shapes::together(shapes::cube(), shapes::cube(3, 0, 0))).empty());
  const auto pairs = self_intersections(shapes::together(shapes::cube(), shapes::cube(0.5, 0.25, 0.125)));
  ASSERT_FALSE(pairs.empty());
  for (const auto& [a, b] : pairs) {
    EXPECT_LT(a, 12u);
    EXPECT_GE(b, 12u);
  }
}

TEST(Simplify, SphereKeepsItsPlace) {
  const SurfaceMesh full = shapes::sphere(10, 5);  // 8192 triangles
  const SimplifiedSurface result = simplified(full, 500);
  expect_sound(full, result);
  EXPECT_LE(result.surface.triangles.size(), 500u);
  EXPECT_GE(result.surface.triangles.size(), 480u);
  EXPECT_LT(result.distance.mean(), 0.05);
  EXPECT_LT(result.distance.largest(), 0.3);
  EXPECT_NEAR(result.report.shells[0].volume, inspect(full).shells[0].volume, 0.5);
}

TEST(Simplify, TorusKeepsItsHole) {
  const SurfaceMesh full = shapes::torus(8, 2, 120, 40);
  const SimplifiedSurface result = simplified(full, 200);
  expect_sound(full, result);
  EXPECT_LE(result.surface.triangles.size(), 200u);
}

TEST(Simplify, AimBelowTheTopologysNeedStopsThere) {
  const SurfaceMesh full = shapes::torus(8, 2, 30, 12);
  const SimplifiedSurface result = simplified(full, 2);
  expect_sound(full, result);
  EXPECT_GE(result.surface.triangles.size(), 14u);  // no torus has fewer
}

TEST(Simplify, CavityStaysACavityApartFromTheOutside) {
  const SurfaceMesh full =
      shapes::together(shapes::sphere(10, 5), shapes::inside_out(shapes::moved(shapes::sphere(9.5, 5), 0.2, 0, 0)));
  // A wall of 0.3 to 0.7 and few triangles: collapsed carelessly, they cut through each other.
  const SimplifiedSurface result = simplified(full, 300);
  expect_sound(full, result);
  EXPECT_EQ(result.report.shells[1].kind, Shell::Kind::cavity);
}

TEST(Simplify, NearlyTouchingWallsHoldEachOtherUpOnlyWhereTheyMust) {
  const SurfaceMesh full = shapes::together(shapes::sphere(10, 5), shapes::inside_out(shapes::sphere(9.98, 5)));
  const SimplifiedSurface result = simplified(full, 400);
  expect_sound(full, result);
  EXPECT_LE(result.surface.triangles.size(), full.triangles.size() / 4);
}

SimplifiedSurfaces together(const std::vector<const SurfaceMesh*>& surfaces, std::size_t triangles) {
  SimplifyOptions options;
  options.triangles = triangles;
  options.distance.samples = 20'000;
  return simplify(surfaces, options);
}

TEST(Simplify, ManySurfacesShareTheAimByNeed) {
  // As many triangles each; shared out by their number, the small one would keep half.
  const SurfaceMesh ball = shapes::sphere(10, 5), bead = shapes::sphere(1, 5);
  const SimplifiedSurfaces result = together({&bead, &ball}, 600);
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.triangles, 600u);
  expect_sound(bead, result.surfaces[0]);
  expect_sound(ball, result.surfaces[1]);
  EXPECT_LT(result.surfaces[0].surface.triangles.size(), 60u);
  EXPECT_GT(result.surfaces[1].surface.triangles.size(), 500u);
}

TEST(Simplify, SurfacesThatOverlapDoNotHoldEachOtherUp) {
  const SurfaceMesh one = shapes::sphere(10, 5), other = shapes::moved(one, 0.01, 0, 0);
  const SimplifiedSurfaces result = together({&one, &other}, 400);
  EXPECT_TRUE(result.reached);
  for (const SimplifiedSurface& surface : result.surfaces) expect_sound(one, surface);
}

TEST(Simplify, SaysWhenTheAimIsOutOfReachAndWhy) {
  const SurfaceMesh full = shapes::torus(8, 2, 30, 12);
  const SimplifiedSurfaces result = together({&full}, 8);
  EXPECT_FALSE(result.reached);
  EXPECT_EQ(result.triangles, result.surfaces[0].surface.triangles.size());
  EXPECT_LE(result.triangles, 60u);
  EXPECT_GT(result.obstacles.topology + result.obstacles.cuts + result.obstacles.shape, 0u);
  EXPECT_TRUE(together({&full}, 200).reached);
}

TEST(Simplify, SmallShellsSurvive) {
  SurfaceMesh full = shapes::sphere(10, 5);
  for (int i = 0; i < 20; ++i) full = shapes::together(full, shapes::cube(20 + 2 * i, 0, 0, 0.01));
  const SimplifiedSurface result = simplified(full, 300);
  expect_sound(full, result);
  EXPECT_EQ(result.report.shells.size(), 21u);
}

TEST(Simplify, TerracesOfStackedContoursBecomeFewTriangles) {
  for (const bool terraced : {false, true}) {
    const SurfaceMesh full = shapes::column({.around = 120, .layers = 40, .terraced = terraced});
    const SimplifiedSurface result = simplified(full, full.triangles.size() / 10);
    expect_sound(full, result);
    EXPECT_LT(result.distance.mean(), terraced ? 0.1 : 0.02);
  }
}

TEST(Simplify, EnoughTrianglesAlreadyChangesNothing) {
  const SurfaceMesh full = shapes::sphere(1, 2);
  const SimplifiedSurface result = simplified(full, full.triangles.size());
  EXPECT_EQ(result.surface.triangles, full.triangles);
  EXPECT_EQ(result.distance.largest(), 0);
}

TEST(Simplify, SameInputSameBytes) {
  const SurfaceMesh full = shapes::torus(8, 2, 60, 30);
  const SimplifiedSurface one = simplified(full, 300), two = simplified(full, 300);
  EXPECT_EQ(one.surface.triangles, two.surface.triangles);
  EXPECT_EQ(one.surface.points, two.surface.points);
}

TEST(Simplify, OpenSurfaceIsRefused) { EXPECT_THROW(simplified(shapes::holed(shapes::sphere(1, 3)), 50), UsageError); }

TEST(Simplify, StopsOnRequest) {
  std::stop_source source;
  Progress progress;
  progress.stop = source.get_token();
  double last = 0;
  progress.report = [&](std::string_view, double fraction) {
    last = fraction;
    if (fraction > 0.3) source.request_stop();
  };
  SimplifyOptions options;
  options.triangles = 100;
  EXPECT_THROW(simplify(shapes::sphere(10, 5), options, progress), Cancelled);
  EXPECT_GT(last, 0.3);
  EXPECT_LT(last, 0.6);
}

}  // namespace
}  // namespace odontoscope
