// Named shapes: what their topology must be, and that the oracle certifies each in every orientation.

#include "tests/support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

const std::string ball = "tooth external genus 0", ring = "tooth external genus 1", pretzel = "tooth external genus 2";

/// Topology with the default criterion (medial). Every contour in its plane is met exactly (the oracle proves it), so
/// only what joins the slices is asked here.
const std::map<std::string, std::vector<std::string>> expected{
    // Circumcentres of a circle are its centre, which lies in the other circle up to one radius of shift.
    {"shifted_circles_0.2", {ball}},
    {"shifted_circles_0.9", {ball}},
    {"shifted_circles_1.5", {ball}},
    {"shifted_circles_2.5", {ball, ball}},
    // A hole above a hole that overlaps it is a canal.
    {"annulus_over_shifted_annulus", {ring}},
    {"annulus_over_disc", {ball}},
    {"annulus_over_disc_with_two_holes", {pretzel}},
    {"one_over_two", {ball}},
    {"one_over_three", {ball}},
    // Four crossings round one window.
    {"two_over_two_crosswise", {ring}},
    {"drifting_canal", {ring}},
    {"identical_lattice_squares", {ball}},
    {"lattice_square_over_shifted_1_2", {ball}},
    {"lattice_square_over_shifted_3_3", {ball}},
    {"square_over_turned_square", {ball}},
    {"hexagon_over_turned_hexagon", {ball}},
    {"alone_in_the_middle", {ball}},
    {"alone_at_the_end", {ball}},
    {"alone_beside_a_column", {ball, ball}},
    {"empty_slice_between", {ball, ball}},
    // Outer tube and inner tube.
    {"islands_nested_four_deep", {ring, ring}},
    {"c_with_island", {ball, ball}},
    // The void reaches the outside through the C's mouth: a pit from the side, no cavity.
    {"hole_that_opens_outside", {ball}},
    {"hole_between_roots", {ball}},
    {"star_over_turned_star", {ball}},
    // Crossing spines and prongs leave one window between each two prongs.
    {"comb_over_mirrored_comb", {"tooth external genus 4"}},
    {"crossing_slivers", {ball}},
    {"triangle_with_triangular_hole", {ring}},
    {"triangular_hole_under_disc", {ball}},
    {"triangular_ring_alone", {ring}},
    // Trimming must leave them as they are joined.
    {"ring_over_crescent", {ring}},
    {"ring_between_crescents", {ring}},
    {"crescent_between_stubs", {ball}},
    {"close_neighbours_1e-3", {ball, ball}},
    {"tiny_features_1e-9", {ball}},
    {"annuli_at_1e5", {ring}},
    {"tiny_annuli_at_1e5", {ring}},
    {"tiny_annuli", {ring}},
};

class Shape : public testing::TestWithParam<NamedStack> {};

TEST_P(Shape, HasItsTopology) {
  const Reconstruction result = certified(GetParam().stack);
  ASSERT_TRUE(expected.contains(GetParam().name));
  EXPECT_EQ(topology_of(result), shells(expected.at(GetParam().name)));
  EXPECT_EQ(result.slices_checked, GetParam().stack.slices.size());
}

TEST_P(Shape, KeepsItWhenSeenDifferently) {
  // These shapes have ties by the hundred; that their topology does not hang on one is a claim about each of them.
  for (const Variant& variant : variants_of(GetParam().stack, 1)) {
    SCOPED_TRACE(variant.name);
    EXPECT_EQ(topology_of(certified(variant.stack)), shells(expected.at(GetParam().name)));
  }
}

TEST_P(Shape, IsCertifiedUnderEachCriterion) {
  for (Correspondence criterion :
       {Correspondence::reverse, Correspondence::medial, Correspondence::overlap, Correspondence::tracked}) {
    SCOPED_TRACE(name(criterion));
    certified(GetParam().stack, {.correspondence = criterion, .links = {}, .threads = 1});
  }
}

std::string test_name(const testing::TestParamInfo<NamedStack>& info) {
  std::string name = info.param.name;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Shape, testing::ValuesIn(all_shapes()), test_name);

// --- facts beyond topology -------------------------------------------------------------------------------------------

TEST(Shapes, PlateOfALoneContourLiesInItsOwnSlabs) {
  const Reconstruction result = certified(alone_in_the_middle());
  EXPECT_EQ(result.counts.isolated_regions, 1u);
  for (const Point3& p : result.solids[0].tetrahedra.points) {
    EXPECT_GT(p.z, 0);
    EXPECT_LT(p.z, 2 * spacing);
  }
}

TEST(Shapes, IdenticalSlicesGiveTheExactPrism) {
  const Reconstruction result = certified(identical_lattice_squares());
  EXPECT_DOUBLE_EQ(result.solids[0].report.shells[0].volume, 16 * spacing);
}

TEST(Shapes, CupIsHollowAlmostToTheNextSlice) {
  // The hole closes just beyond its own slice or anywhere up to the next: some void must be there, and not all of the
  // slab.
  const double full = certified(stack_of({{circle(3)}, {circle(3, {0.2, 0})}})).solids[0].report.shells[0].volume;
  const double cup = certified(annulus_over_disc()).solids[0].report.shells[0].volume;
  EXPECT_LT(cup, full);
  EXPECT_GT(cup, full - 4 * spacing);  // the hole's whole column would be pi * spacing
}

TEST(Shapes, NarrowGapsAreSplitOppositeEachOther) {
  // Halving would need a point for each gap's width on either side: 200,000 already for a gap of 1e-5.
  for (double gap : {1e-3, 1e-5, 1e-8})
    EXPECT_LT(certified(turned(close_neighbours(gap), 0.3)).counts.steiner_points, 100u) << gap;
  EXPECT_LT(certified(turned(close_neighbours(1e-9), 0.3)).counts.steiner_points, 5000u)
      << "near the precision of a double";
}

/// How far from the ring of radii 3.7 and 4 a tetrahedron's middle lies, seen along z.
double farthest_from_ring(const TetraMesh& mesh) {
  double farthest = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    double x = 0, y = 0;
    for (const PointIndex p : t) x += mesh.points[p].x / 4, y += mesh.points[p].y / 4;
    const double radius = std::hypot(x, y);
    farthest = std::max({farthest, 3.7 - radius, radius - 4});
  }
  return farthest;
}

TEST(Shapes, WhatHangsOverNothingDoesNotLeanAcrossTheVoid) {
  // The mouths of the Cs are 6 mm wide, the ring is 0.3 mm thick.
  for (const ContourStack& stack : {ring_over_crescent(), ring_between_crescents()}) {
    const Reconstruction result = certified(stack);
    EXPECT_GT(result.counts.trimmed, 0u);
    EXPECT_LT(farthest_from_ring(result.solids[0].tetrahedra), 0.3);
  }
}

TEST(Shapes, WhatHangsFreeOnBothSidesKeepsOne) {
  const Reconstruction result = certified(crescent_between_stubs());  // its section is proven there
  EXPECT_GT(result.counts.trimmed, 0u);
}

TEST(Shapes, ATipOverAWideBaseIsNoOverhang) {
  const Reconstruction result = certified(stack_of({{circle(5)}, {star(5, 0.3, 0.1)}, {star(5, 0.3, 0.1)}}));
  EXPECT_EQ(result.counts.trimmed, 0u);
}

TEST(Shapes, ASlantedThinWallIsNotTrimmedAway) {
  // Each wall moves by four times its thickness from slice to slice: only the user says that it is one.
  std::vector<std::vector<Ring>> slices;
  for (int k = 0; k < 4; ++k) slices.push_back({rectangle({0, 0.4 * k}, {5, 0.4 * k + 0.1})});
  const ContourStack stack = stack_of(slices);
  ReconstructOptions options{.correspondence = Correspondence::medial, .links = {}, .threads = 1};
  for (std::size_t k = 0; k < 3; ++k) options.links.push_back({"tooth", k, 0, 0, true});
  const Reconstruction result = certified(stack, options);
  EXPECT_EQ(topology_of(result), shells({ball}));
  EXPECT_NEAR(result.solids[0].report.shells[0].volume, 3 * 5 * 0.1 * spacing, 0.05 * 3 * 5 * 0.1 * spacing)
      << "thinner than the wall";
}

TEST(Shapes, NeighboursAPicometreApartAreBuilt) { certified(turned(close_neighbours(1e-9), 0.3)); }

TEST(Shapes, NeighboursAThousandthOfThatApartAreBuilt) { certified(turned(close_neighbours(1e-12), 0.3)); }

}  // namespace
}  // namespace odontoscope::test
