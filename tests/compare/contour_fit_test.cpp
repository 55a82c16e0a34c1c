// Sections of surfaces, the widest places of contours, and how well a surface gives its contours back.

#include "recon/compare/contour_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

/// A box from (0, 0, 0) to (4, 3, 2), outward.
SurfaceMesh box() {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({4.0 * (i & 1), 3.0 * (i >> 1 & 1), 2.0 * (i >> 2)});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

double whole_length(const std::vector<SectionSegment>& segments) {
  double sum = 0;
  for (const SectionSegment& s : segments) sum += std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
  return sum;
}

TEST(Sections, FollowTheSurfaceJustBelowAndJustAboveThePlane) {
  const auto cuts = sections(box(), {1, 0, 2, 5});
  EXPECT_NEAR(whole_length(cuts[0].below), 14, 1e-12);
  EXPECT_NEAR(whole_length(cuts[0].above), 14, 1e-12);
  EXPECT_EQ(whole_length(cuts[1].below), 0);  // it begins here
  EXPECT_NEAR(whole_length(cuts[1].above), 14, 1e-12);
  EXPECT_NEAR(whole_length(cuts[2].below), 14, 1e-12);
  EXPECT_EQ(whole_length(cuts[2].above), 0);
  EXPECT_TRUE(cuts[3].below.empty() && cuts[3].above.empty());
}

TEST(Sections, TellMaterialFromVoidDespiteACrackAndWhateverTheOrientation) {
  SurfaceMesh mesh = box();
  mesh.triangles.pop_back();                              // a hole in one wall
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);  // and a triangle turned over
  const PlaneSection cut = sections(mesh, {1})[0];
  EXPECT_TRUE(is_material(cut, {2, 1.5}));
  EXPECT_FALSE(is_material(cut, {-1, 1.5}));
  EXPECT_FALSE(is_material(cut, {9, 1.5}));
}

TEST(Passages, AreAsWideAsTheLargestCircleThatFits) {
  // A disc of radius 3 with a hole of radius 1 off its middle, and a square island in a square hole.
  const ContourStack stack =
      ordered(stack_of({{circle(3), circle(1, {1.2, 0})},
                        {rectangle({0, 0}, {9, 9}), rectangle({1, 1}, {8, 8}), rectangle({3, 2.5}, {6, 5.5})}}))
          .stack;
  const std::vector<ContourPassage> all = passages(stack, "tooth");
  ASSERT_EQ(all.size(), 5u);
  EXPECT_NEAR(all[0].width, 3.2, 0.07);  // between the disc's far side and the hole
  EXPECT_FALSE(all[0].hole);
  EXPECT_NEAR(all[1].width, 2, 0.03);
  EXPECT_TRUE(all[1].hole);
  EXPECT_NEAR(all[1].middle.x, 1.2, 0.05);
  EXPECT_NEAR(all[2].width, 1.17, 0.1);  // in a corner: 1 wide, and r (1 + sqrt 2) to the hole's corner
  EXPECT_TRUE(all[3].hole);
  EXPECT_NEAR(all[4].width, 3, 0.04);
  EXPECT_FALSE(all[4].hole);
}

TEST(ContourFit, OfDtIsPerfectForEveryShape) {
  for (const NamedStack& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const ContourStack stack = ordered(shape.stack).stack;
    const Reconstruction made = reconstruct(stack);
    const ContourFit fit = contour_fit(stack, "tooth", made.solids.at(0).surface, {.samples = 2'000});
    double size = 1;
    for (const Slice& slice : stack.slices)
      for (const Contour& contour : slice.contours)
        for (const Point2& p : contour.points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    EXPECT_LT(fit.contours_to_surface.largest, 1e-10 * size);
    EXPECT_LT(fit.section_to_contours.largest, 1e-10 * size);
    EXPECT_EQ(fit.holes.lost + fit.solids.lost, 0u);
    EXPECT_GT(fit.solids.all, 0u);
  }
}

TEST(ContourFit, MeasuresHowFarASurfaceIsOff) {
  const ContourStack stack =
      ordered(stack_of({{rectangle({0, 0}, {4, 3})}, {rectangle({0, 0}, {4, 3})}, {rectangle({0, 0}, {4, 3})}})).stack;
  SurfaceMesh wider;  // the box, 0.1 beyond on all sides in the plane, from -1 to 3 along z
  wider = box();
  for (Point3& p : wider.points) p = {p.x > 0 ? 4.1 : -0.1, p.y > 0 ? 3.1 : -0.1, p.z > 0 ? 3.0 : -1.0};
  const ContourFit fit = contour_fit(stack, "tooth", wider);
  EXPECT_NEAR(fit.contours_to_surface.largest, 0.1, 1e-12);
  EXPECT_NEAR(fit.contours_to_surface.mean, 0.1, 1e-12);
  EXPECT_NEAR(fit.section_to_contours.largest, 0.1 * std::sqrt(2), 1e-12);  // in the corners
  EXPECT_NEAR(fit.section_to_contours.mean, 0.1, 1e-3);
  const ContourFit at_corners = contour_fit(stack, "tooth", wider, {.samples = 0});
  EXPECT_NEAR(at_corners.contours_to_surface.largest, 0.1, 1e-12);
}

TEST(ContourFit, CountsTheCanalsThatACoarseGridLoses) {
  // Canals of 0.2 and 2 in a block of 10.
  const std::vector<Ring> section{rectangle({0, 0}, {10, 10}), circle(0.1, {2.3, 2.4}), circle(1, {7, 7})};
  const ContourStack stack = ordered(stack_of({section, section, section})).stack;
  const auto fit_on = [&](std::size_t points) {
    DbOptions options;
    options.grid.columns = options.grid.rows = points;
    return contour_fit(stack, "tooth", reconstruct_by_distance(stack, options).surfaces.at(0).surface);
  };
  const ContourFit coarse = fit_on(16), fine = fit_on(128);
  EXPECT_EQ(coarse.holes.all, 6u);
  EXPECT_EQ(coarse.holes.lost, 3u);
  EXPECT_NEAR(coarse.holes.widest_lost, 0.2, 0.01);
  EXPECT_NEAR(coarse.holes.thinnest_kept, 2, 0.03);
  EXPECT_EQ(fine.holes.lost, 0u);
  EXPECT_NEAR(fine.holes.thinnest_kept, 0.2, 0.01);
  EXPECT_LT(fine.contours_to_surface.mean, coarse.contours_to_surface.mean / 2);
}

TEST(ContourFit, OfNothingHasLostEverything) {
  const ContourStack stack = ordered(annulus_over_disc()).stack;
  const ContourFit fit = contour_fit(stack, "tooth", {});
  EXPECT_EQ(fit.solids.lost, fit.solids.all);
  EXPECT_EQ(fit.contours_to_surface.largest, 0);
}

TEST(ContourFit, JoinsByLength) {
  ContourFit a, b;
  a.contours_to_surface = {1, 0.5};
  b.contours_to_surface = {3, 1.5};
  a.holes = {2, 1, 0.4, 0.2};
  b.holes = {3, 0, 0.3, 0};
  const ContourFit all = joined({{a, 1}, {b, 3}});
  EXPECT_EQ(all.contours_to_surface.largest, 3);
  EXPECT_EQ(all.contours_to_surface.mean, (0.5 + 3 * 1.5) / 4);
  EXPECT_EQ(all.holes.all, 5u);
  EXPECT_EQ(all.holes.lost, 1u);
  EXPECT_EQ(all.holes.thinnest_kept, 0.3);
  EXPECT_EQ(all.holes.widest_lost, 0.2);
}

}  // namespace
}  // namespace odontoscope::test
