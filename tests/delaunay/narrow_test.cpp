// Gaps narrower than the places of Gabriel edges can be told: there contour edges are only made Delaunay, or, where
// that cannot be had either, taken as they are: the slabs beside such a slice are blocks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/delaunay/constrained.h"
#include "tests/delaunay/engine_checks.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

const Contour square{"tooth", {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};

/// A triangle as good as flat: its middle corner is off the long edge by `width`.
Contour needle(double width) { return {"tooth", {{-0.761, 1.226}, {0.2177, 1.5288}, {-0.27165, 1.3774 - width}}}; }

/// Two triangles with upright walls beside each other, `gap` apart, one wall longer at both ends.
std::vector<Contour> walls(double gap) {
  return {{"tooth", {{1, -1}, {1, 1}, {-1, 1}}}, {"tooth", {{1 + gap, -1.03}, {2.5, 1.95}, {1 + gap, 1.95}}}};
}

/// The slice under a square, above it, and between two.
std::vector<ContourStack> around(const std::vector<Contour>& narrow) {
  const auto flat = [](double z) { return Slice{z, {square}}; };
  return {ContourStack{{Slice{0, narrow}, flat(1)}, ""}, ContourStack{{flat(0), Slice{0.01, narrow}}, ""},
          ContourStack{{flat(0), Slice{1, narrow}, flat(1.5)}, ""}};
}

/// Three triangles within each other whose long edges lie on each other to within 1e-14, slanted: the middle one's
/// edges cannot be Delaunay towards both neighbours at once, since points that should lie opposite each other are
/// rounded.
std::vector<Contour> three_abreast() {
  return {{"tooth",
           {{1.15546154025391, 1.632454786202075},
            {0.8360165452535284, -1.8168864400568197},
            {0.7106058636055081, -0.06580951887815445}}},
          {"tooth",
           {{1.1554615402538984, 1.6324547862020589},
            {-1.9914780855074325, 0.18443165385474275},
            {0.8360165452535201, -1.8168864400568014},
            {0.710605863605501, -0.0658095188781538}}},
          {"tooth",
           {{-0.41229564696205645, -0.5824979705214615},
            {0.8360165452535118, -1.8168864400567832},
            {0.7106058636054939, -0.06580951887815314}}}};
}

void expect_certified(const std::vector<Contour>& narrow, std::size_t most_added) {
  const ReconstructOptions options{
      .correspondence = Correspondence::overlap, .between = Between::delaunay, .links = {}, .threads = 1};
  for (const ContourStack& stack : around(narrow)) {
    const Reconstruction made = certified(stack, options);
    EXPECT_LE(made.counts.steiner_points, most_added);
    EXPECT_EQ(made.counts.constrained_slices, 0u);
  }
}

TEST(Narrow, NeedlesAreBuilt) {
  for (double width : {1e-4, 1e-9, 1e-13}) expect_certified({needle(width)}, 1000);
}

TEST(Narrow, WallsThatAllButTouchAreBuilt) {
  for (double gap : {1e-4, 1e-9, 1e-13}) expect_certified(walls(gap), 1000);
}

TEST(Narrow, WhatCannotBeConformedIsTakenAsItIs) {
  for (const Between between : {Between::delaunay, Between::blended})
    for (const Correspondence criterion : {Correspondence::tracked, Correspondence::reverse})
      for (const ContourStack& stack : around(three_abreast())) {
        const Reconstruction made =
            certified(stack, {.correspondence = criterion, .between = between, .links = {}, .threads = 1});
        EXPECT_EQ(made.counts.constrained_slices, 1u);
        const auto& shells =
            made.solids[0].report.shells;  // blocks on both sides shut the hollow between the triangles
        EXPECT_EQ(std::count_if(shells.begin(), shells.end(),
                                [](const Shell& shell) { return shell.kind == Shell::Kind::external; }),
                  1)
            << "they lie over the square, so all is one piece";
      }
}

TEST(Narrow, ASliceThatCannotBeConformedMayStandAlone) {
  const Reconstruction made = certified({{Slice{0, three_abreast()}, Slice{0.03, {}}}, ""});
  EXPECT_EQ(made.counts.constrained_slices, 1u);
  EXPECT_EQ(made.counts.isolated_regions, 2u);
}

TEST(Narrow, BlocksHeedLinks) {
  ContourStack stack = around(three_abreast())[0];
  const Contour far{"tooth", {{5, 0}, {6, 0}, {5, 1}}};
  stack.slices[0].contours.push_back(far);
  stack.slices[1].contours.push_back(far);
  const Reconstruction two = certified(stack, {.links = {}, .threads = 1});
  EXPECT_EQ(two.solids[0].report.shells.size(), 2u);
  const Reconstruction one = certified(stack, {.links = {{"tooth", 0, 1, 1, true}}, .threads = 1});
  EXPECT_EQ(one.solids[0].report.shells.size(), 1u);
  const Reconstruction cut = certified(stack, {.links = {{"tooth", 0, 1, 0, false}}, .threads = 1});
  EXPECT_GE(cut.solids[0].report.shells.size(), 3u);
  EXPECT_GE(cut.counts.isolated_regions, 1u);
}

TEST(Narrow, BlocksFitBetweenSlicesAFewUnitsInTheLastPlaceApart) {
  double high = 1;
  for (int i = 0; i < 6; ++i) high = std::nextafter(high, 2);
  EXPECT_EQ(certified({{Slice{1, three_abreast()}, Slice{high, {square}}}, ""}).counts.constrained_slices, 1u);
}

/// The triangulation tells an edge from either side, as its triangles happen to lie in memory.
TEST(Narrow, TheNearerPointIsTheSameFromBothSides) {
  RandomNumbers random(1);
  std::size_t asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point2 a{random.between(-3, 3), random.between(-3, 3)}, b{random.between(-3, 3), random.between(-3, 3)};
    const double x = b.x - a.x, y = b.y - a.y, height = random.between(0.01, 0.1);
    const auto beside = [&](double share, double side) {
      return Point2{a.x + share * x - side * height * y, a.y + share * y + side * height * x};
    };
    const Table<delaunay::SlicePoint, Point2> points{a, b, beside(random.between(0.4, 0.6), 1),
                                                     beside(random.between(0.4, 0.6), -1)};
    delaunay::Cdt cdt;
    const auto vertices = delaunay::insert_points(cdt, points, delaunay::order_of(points));
    const delaunay::Vertex start = vertices.front(), end = *(vertices.begin() + 1);
    cdt.insert_constraint(start, end);
    delaunay::Face face;
    int k = 0;
    if (!cdt.is_edge(start, end, face, k)) continue;
    ++asked;
    EXPECT_EQ(delaunay::encroacher(cdt, face, k),
              delaunay::encroacher(cdt, face->neighbor(k), cdt.mirror_index(face, k)))
        << i;
  }
  EXPECT_GT(asked, 1000u);
}

/// A bead in the hollow of a ring, all of 1e-162 mm: products of three such lengths are 0.
TEST(Narrow, MinuteCavitiesAreFilledOrHollowAsTheyAre) {
  const auto box = [](double half) {
    return Contour{"tooth", {{-half, -half}, {half, -half}, {half, half}, {-half, half}}};
  };
  const double unit = 1e-162;
  const Reconstruction made = certified(
      {{Slice{0, {box(2 * unit)}}, Slice{unit, {box(2 * unit), box(unit)}}, Slice{2 * unit, {box(2 * unit)}}}, ""});
  ASSERT_EQ(made.solids[0].report.shells.size(), 2u);
  EXPECT_EQ(made.solids[0].report.shells[0].kind == Shell::Kind::cavity,
            made.solids[0].report.shells[1].kind != Shell::Kind::cavity);
}

}  // namespace
}  // namespace odontoscope::test
