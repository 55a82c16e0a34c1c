// Meshes cut into contours: closed whatever the plane meets, and the same solid again when reconstructed.

#include "recon/exchange/cut_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_distance.h"
#include "recon/sample/sample_tooth.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

CutContours cut(const SurfaceMesh& mesh, const std::vector<double>& heights, const CutOptions& options = {}) {
  return cut_surfaces({{"tooth", mesh}}, heights, "file", options);
}

std::string cause_of(const SurfaceMesh& mesh, const std::vector<double>& heights, const CutOptions& options = {}) {
  try {
    cut(mesh, heights, options);
    return "accepted";
  } catch (const InputError& error) {
    return error.cause();
  }
}

double area(const Slice& slice) {
  double twice = 0;
  for (const Contour& contour : slice.contours) {
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Point2 &a = contour.points[i], &b = contour.points[(i + 1) % contour.points.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  }
  return twice / 2;
}

SurfaceMesh stretched(SurfaceMesh mesh, double x, double y, double z) {
  for (Point3& p : mesh.points) p = {p.x * x, p.y * y, p.z * z};
  return mesh;
}

TEST(CutSurfaces, ASphereGivesCircles) {
  const auto [stack, changes] = cut(shapes::sphere(10, 5), {-9.9, -5, 0.1, 7});
  EXPECT_TRUE(changes.empty());
  for (const Slice& slice : stack->slices) {
    ASSERT_EQ(slice.contours.size(), 1u);
    const double radius = std::sqrt(100 - slice.z * slice.z);
    EXPECT_NEAR(area(slice), 3.14159265 * radius * radius, 0.6);  // counter-clockwise
    for (const Point2& p : slice.contours[0].points) EXPECT_NEAR(std::hypot(p.x, p.y), radius, 0.1);
  }
}

TEST(CutSurfaces, ATorusOnItsSideGivesHolesAndParts) {
  SurfaceMesh ring = shapes::torus(8, 2, 48, 24);  // round the z axis
  const ContourStack flat = cut(ring, {-0.5, 0.7}).stack;
  EXPECT_EQ(flat.slices[0].contours.size(), 2u);
  EXPECT_NEAR(area(flat.slices[0]), 3.14159265 * (std::pow(8 + std::sqrt(3.75), 2) - std::pow(8 - std::sqrt(3.75), 2)),
              3);
  for (Point3& p : ring.points) p = {p.x, -p.z, p.y};
  const ContourStack upright = cut(ring, {-9, 0.3, 7, 9}).stack;
  EXPECT_EQ(upright.slices[0].contours.size(), 1u);
  EXPECT_EQ(upright.slices[1].contours.size(), 2u);
  EXPECT_EQ(upright.slices[3].contours.size(), 1u);
}

TEST(CutSurfaces, PlanesThroughVerticesEdgesAndFaces) {
  const SurfaceMesh cube = shapes::cube(0, 0, 0, 2);
  // Bottom and top give their outlines without a rounding.
  const ContourStack stack = cut(cube, {0, 1, 2}).stack;
  EXPECT_DOUBLE_EQ(area(stack.slices[1]), 4);
  for (const std::size_t flat : {0u, 2u}) {
    ASSERT_EQ(stack.slices[flat].contours.size(), 1u);
    EXPECT_EQ(stack.slices[flat].contours[0].points.size(), 4u);
    EXPECT_EQ(area(stack.slices[flat]), 4);
  }
  const ContourStack inside_out = cut(shapes::inside_out(cube), {0, 1, 2}).stack;
  for (const Slice& slice : inside_out.slices) EXPECT_EQ(slice.contours.size(), 1u);
  // An octahedron's tips touch, its waist is a vertex ring.
  const ContourStack octahedron = cut(shapes::sphere(1, 0), {-1, 0, 0.5, 1}).stack;
  EXPECT_TRUE(octahedron.slices[0].contours.empty());
  EXPECT_EQ(octahedron.slices[1].contours[0].points.size(), 4u);
  EXPECT_EQ(area(octahedron.slices[1]), 2);
  EXPECT_TRUE(octahedron.slices[3].contours.empty());
}

TEST(CutSurfaces, APlaneThroughASaddleStillGivesContoursThatKeepTheRules) {
  SurfaceMesh ring = shapes::torus(8, 2, 16, 8);
  for (Point3& p : ring.points) p = {p.x, -p.z, p.y};
  std::vector<double> heights;
  for (const Point3& p : ring.points) heights.push_back(p.z);  // each height a vertex has: saddles, waists, tips
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  const ContourStack stack = cut(ring, heights).stack;
  std::size_t contours = 0;
  for (const Slice& slice : stack.slices) contours += slice.contours.size();
  EXPECT_GT(contours, heights.size());
}

TEST(CutSurfaces, OpenTornAndTwistedSurfacesAreNamed) {
  const SurfaceMesh sphere = shapes::sphere(10, 3);
  const std::vector<double> heights{-5, 0.1, 5};
  EXPECT_EQ(cause_of(shapes::holed(sphere), heights), "open-surface");
  EXPECT_EQ(cause_of(shapes::flipped(sphere), heights), "misoriented-surface");
  EXPECT_EQ(cause_of(shapes::cubes_on_one_edge(), {0.25, 0.75}), "crowded-edge");
  const SurfaceMesh crossing = shapes::together(sphere, shapes::moved(sphere, 7, 0, 0));
  EXPECT_EQ(cause_of(crossing, heights), "section-meets-itself");
  try {
    cut(shapes::holed(sphere), heights);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("3 border edges, one at ("), std::string::npos) << error.what();
  }
}

TEST(CutSurfaces, RepairClosesSmallGapsAndSaysSo) {
  const SurfaceMesh sphere = shapes::sphere(10, 4);
  SurfaceMesh torn = sphere;
  std::erase_if(torn.triangles, [&](const Triangle& t) { return torn.points[t[0]].x > 9.7; });
  const std::vector<double> heights{-5, 0.1, 5};
  EXPECT_EQ(cause_of(torn, heights), "open-surface");
  EXPECT_EQ(cause_of(torn, heights, {.repair = true}), "gap-too-wide");
  const auto [stack, changes] = cut(torn, heights, {.repair = true, .widest_gap = 6});
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].place.slice, 1u);
  EXPECT_NE(changes[0].what.find("a gap of"), std::string::npos);
  EXPECT_NEAR(area(stack->slices[1]), area(cut(sphere, heights).stack->slices[1]), 10);
  EXPECT_EQ(stack->slices[0].contours[0].points, cut(sphere, heights).stack->slices[0].contours[0].points);
}

TEST(CutSurfaces, RepairJoinsSolidsThatOverlap) {
  const SurfaceMesh sphere = shapes::sphere(10, 3);
  const SurfaceMesh crossing = shapes::together(sphere, shapes::moved(sphere, 7, 0, 0));
  const auto both = cut(crossing, {-5, 0.1, 5}, {.repair = true});
  EXPECT_EQ(both.changes.size(), 3u);
  for (const Slice& slice : both.stack->slices) EXPECT_EQ(slice.contours.size(), 1u);
  const auto inside_out = cut(shapes::inside_out(crossing), {-5, 0.1, 5}, {.repair = true});
  for (const Slice& slice : inside_out.stack->slices) EXPECT_EQ(slice.contours.size(), 1u);
}

TEST(CutSurfaces, AnEngineOfItsOwnModelGivesItsContoursBack) {
  const ContourStack molar = sample_tooth(ToothKind::molar, {.slice_spacing = 0.35, .point_spacing = 0.5});
  const Reconstruction model = reconstruct(molar);
  std::vector<NamedMesh> surfaces;
  for (const Solid& solid : model.solids) surfaces.push_back({solid.structure, solid.surface});
  std::vector<double> heights;
  for (const Slice& slice : molar.slices) heights.push_back(slice.z);
  std::sort(heights.begin(), heights.end());
  const auto [stack, changes] = cut_surfaces(surfaces, heights, "file", {});
  EXPECT_TRUE(changes.empty());
  const OrderedStack expected = ordered(molar);
  ASSERT_EQ(stack->slices.size(), expected.stack.slices.size());
  const OrderedStack found = ordered(stack);
  for (std::size_t s = 0; s < stack->slices.size(); ++s) {
    EXPECT_NEAR(area(found.stack.slices[s]), area(expected.stack.slices[s]), 1e-9) << s;
    EXPECT_EQ(found.stack.slices[s].contours.size(), expected.stack.slices[s].contours.size()) << s;
  }
}

TEST(CutSurfaces, ReconstructedAgainItIsNear) {
  const Reconstruction model = reconstruct(sample_tooth(ToothKind::incisor));
  const SurfaceMesh& dentine = model.solids.front().surface;
  const auto heights = heights_at({{"dentine", dentine}}, 0.2);
  const Reconstruction again = reconstruct(cut_surfaces({{"dentine", dentine}}, heights, "file").stack);
  const auto off = surface_distance(again.solids.front().surface, dentine, {.samples = 20'000});
  ASSERT_TRUE(off);
  EXPECT_LT(off->mean(), 0.02);
  EXPECT_LT(off->largest(), 0.3);
}

TEST(CutSurfaces, HeightsFitTheModel) {
  const std::vector<NamedMesh> cube{{"tooth", shapes::cube(0, 0, 5, 2)}};
  EXPECT_EQ(heights_at(cube, 0.5), (std::vector<double>{5.25, 5.75, 6.25, 6.75}));
  for (const double wrong : {0.0, -1.0, 1.9, 1e-7, std::nan("")})
    EXPECT_THROW(heights_at(cube, wrong), UsageError) << wrong;
}

TEST(CutSurfaces, FlatTrianglesAndLargeNumbersDoNoHarm) {
  const SurfaceMesh thin = stretched(shapes::sphere(10, 4), 1, 1e-9, 1e4);
  EXPECT_EQ(cut(thin, {-9e4, -5, 1e4}).stack->slices[1].contours.size(), 1u);
}

}  // namespace
}  // namespace odontoscope
