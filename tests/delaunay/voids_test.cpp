// Void regions and their links, against points looked up in the polygons themselves.

#include "recon/delaunay/voids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "tests/delaunay/conformed.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

using namespace delaunay;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Ring ring_of(const ConformedSlice& slice, std::uint32_t contour) {
  return {slice.planar.points.begin() + slice.first_point[contour],
          slice.planar.points.begin() + slice.first_point[contour + 1]};
}

double area_of(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 o = ring.front(), a = ring[i],
                 b = ring[(i + 1) % ring.size()];  // about its first point: far from the origin nothing is lost
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return std::abs(twice) / 2;
}

bool contains(const Ring& ring, Point2 p) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
  }
  return in;
}

double distance_to(const Ring& ring, Point2 p) {
  double least = INFINITY;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double x = b.x - a.x, y = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
    least = std::min(least, std::hypot(a.x + t * x - p.x, a.y + t * y - p.y));
  }
  return least;
}

/// By the innermost of the chosen regions' contours that encloses p: the void there; none in material. Empty where p
/// is too near to a contour for plain doubles.
std::optional<std::uint32_t> void_at(const ConformedSlice& slice, const SliceVoids& voids,
                                     const std::vector<bool>& chosen, Point2 p) {
  double least = INFINITY;
  std::optional<std::uint32_t> innermost;
  for (std::uint32_t c = 0; c < slice.contour_number.size(); ++c) {
    if (!chosen[slice.planar.region_of[slice.first_point[c]]]) continue;
    const Ring ring = ring_of(slice, c);
    if (!(distance_to(ring, p) > 1e-9)) return std::nullopt;
    if (contains(ring, p) && area_of(ring) < least) {
      least = area_of(ring);
      innermost = c;
    }
  }
  if (!innermost) return outside;
  const auto hole = std::find(voids.hole_contour.begin(), voids.hole_contour.end(), *innermost);
  return hole == voids.hole_contour.end() ? none : static_cast<std::uint32_t>(hole - voids.hole_contour.begin()) + 1;
}

std::vector<bool> all_of(const ConformedSlice& slice) { return std::vector<bool>(slice.regions(), true); }

std::vector<std::uint32_t> numbers_of(const std::vector<bool>& chosen) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t r = 0; r < chosen.size(); ++r)
    if (chosen[r]) numbers.push_back(r);
  return numbers;
}

void expect_true_voids(const ConformedSlice& slice, const Planar& planar, const std::vector<bool>& chosen) {
  const SliceVoids voids = voids_of(slice);
  const PlanarVoids found = voids_in(planar, slice, voids);
  ASSERT_EQ(found.of_triangle.size(), planar.triangles.size());
  ASSERT_EQ(found.beside_point.size(), planar.points.size());
  for (const TriangleIndex t : planar.triangles.indices()) {
    const auto& v = planar.triangles[t].v;
    const Point2 a = planar.points[v[0]], b = planar.points[v[1]], c = planar.points[v[2]];
    const Point2 middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    const auto truth = void_at(slice, voids, chosen, middle);
    if (!truth) continue;
    EXPECT_EQ(found.of_triangle[t], *truth);
    if (*truth == none) continue;
    for (const SlicePoint p : v) EXPECT_EQ(found.beside_point[p], *truth);
  }
}

void expect_true_voids(const ContourStack& stack) {
  for (const ConformedSlice& slice : conformed(stack)) {
    expect_true_voids(slice, slice.planar, all_of(slice));
    if (slice.regions() < 2) continue;
    for (std::size_t left_out = 0; left_out < std::min<std::size_t>(slice.regions(), 4); ++left_out) {
      std::vector<bool> chosen = all_of(slice);
      chosen[left_out] = false;
      expect_true_voids(slice, part_of(slice, numbers_of(chosen)), chosen);
    }
  }
}

struct VoidSlab {
  ConformedSlice lower, upper;
  SliceVoids below, above;
  SlabTetrahedra tetrahedra;

  VoidSlab(ConformedSlice first, ConformedSlice second)
      : lower(std::move(first)), upper(std::move(second)), below(voids_of(lower)), above(voids_of(upper)) {
    if (lower.regions() > 0 && upper.regions() > 0) tetrahedra = triangulate_slab(lower.planar, upper.planar);
  }

  std::vector<RegionLink> links(Correspondence widest = Correspondence::overlap) const {
    return witnessed_void_links(tetrahedra, lower.planar, upper.planar, voids_in(lower.planar, lower, below),
                                voids_in(upper.planar, upper, above), widest);
  }
};

Pairs pairs_of(const std::vector<RegionLink>& links) {
  Pairs pairs;
  for (const RegionLink& link : links) pairs.insert({link.lower, link.upper});
  return pairs;
}

Pairs linked(const ContourStack& stack, std::size_t slab = 0) {
  const auto slices = conformed(stack);
  return pairs_of(VoidSlab(slices.at(slab), slices.at(slab + 1)).links());
}

/// Where the perpendicular bisectors of (a, b) and (c, d) cross.
Point2 bisectors_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double s = (ux * (a.x + b.x) + uy * (a.y + b.y)) / 2, t = (vx * (c.x + d.x) + vy * (c.y + d.y)) / 2;
  const double det = ux * vy - uy * vx;
  return {(s * vy - t * uy) / det, (ux * t - vx * s) / det};
}

Point2 dual_point(const SlabTetrahedron& tet, const Planar& lower, const Planar& upper) {
  const auto at = [&](int i) {
    const SlabNumbers numbers(lower);
    return (numbers.is_lower(tet.v[i]) ? lower : upper).points[numbers.own(tet.v[i])];
  };
  if (tet.lower_count == 2) return bisectors_cross(at(0), at(1), at(2), at(3));
  const int first = tet.lower_count == 3 ? 0 : 1;
  return bisectors_cross(at(first), at(first + 1), at(first), at(first + 2));
}

/// The links of all tetrahedra by looking their dual points up; empty if one of these lies too near to a contour.
std::optional<Pairs> looked_up(const VoidSlab& slab) {
  Pairs pairs{{outside, outside}};
  for (const SlabTetrahedron& tet : slab.tetrahedra) {
    const Point2 dual = dual_point(tet, slab.lower.planar, slab.upper.planar);
    const auto below = void_at(slab.lower, slab.below, all_of(slab.lower), dual);
    const auto above = void_at(slab.upper, slab.above, all_of(slab.upper), dual);
    if (!below || !above) return std::nullopt;
    if (*below != none && *above != none) pairs.insert({*below, *above});
  }
  return pairs;
}

TEST(Voids, OfNamedShapesAreWhereThePolygonsSay) {
  for (const auto& [name, stack] : all_shapes()) {
    SCOPED_TRACE(name);
    expect_true_voids(stack);
  }
}

TEST(Voids, OfRandomStacksAreWhereThePolygonsSay) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_true_voids(random_stack(seed).stack);
  }
}

TEST(Voids, OfNestedIslandsAreSurroundedAsTheyStand) {
  const ConformedSlice slice = conformed(islands_nested_four_deep()).front();
  const SliceVoids voids = voids_of(slice);
  EXPECT_EQ(voids.count(), 3u);
  // From outside inwards: outside | contour | material | contour | void | contour | material | contour | void.
  std::vector<std::uint32_t> inwards(slice.contour_number.size());
  for (std::uint32_t c = 0; c < inwards.size(); ++c) inwards[c] = c;
  std::sort(inwards.begin(), inwards.end(),
            [&](std::uint32_t a, std::uint32_t b) { return area_of(ring_of(slice, a)) > area_of(ring_of(slice, b)); });
  ASSERT_EQ(inwards.size(), 4u);
  EXPECT_EQ(voids.of_contour[inwards[0]], outside);
  EXPECT_NE(voids.of_contour[inwards[1]], outside);
  EXPECT_EQ(voids.of_contour[inwards[1]], voids.of_contour[inwards[2]]);
  EXPECT_NE(voids.of_contour[inwards[3]], outside);
  EXPECT_NE(voids.of_contour[inwards[3]], voids.of_contour[inwards[1]]);
}

TEST(Voids, AnIslandAloneStandsOutside) {
  const ConformedSlice slice = conformed(islands_nested_four_deep()).front();
  std::vector<bool> chosen(slice.regions(), false);
  const SliceVoids voids = voids_of(slice);
  std::uint32_t island = 0;  // the region whose outer contour has a hole's void beside it
  while (voids.of_contour[slice.outer_contour[island]] == outside) ++island;
  chosen[island] = true;
  const Planar alone = part_of(slice, numbers_of(chosen));
  const PlanarVoids found = voids_in(alone, slice, voids);
  EXPECT_EQ(std::set<std::uint32_t>(found.beside_point.begin(), found.beside_point.end()).count(outside), 1u);
  expect_true_voids(slice, alone, chosen);
}

TEST(VoidLinks, OfNamedShapes) {
  EXPECT_EQ(linked(annulus_over_shifted_annulus()), (Pairs{{0, 0}, {1, 1}}));
  EXPECT_EQ(linked(annulus_over_disc()), (Pairs{{0, 0}})) << "the hole ends blind";
  EXPECT_EQ(linked(annulus_over_disc_with_two_holes()), (Pairs{{0, 0}, {1, 1}, {1, 2}}));
  EXPECT_EQ(linked(hole_between_roots(), 0), (Pairs{{0, 0}, {0, 1}})) << "the hole opens between the roots";
  EXPECT_EQ(linked(hole_between_roots(), 1), (Pairs{{0, 0}})) << "and is closed above";
  EXPECT_EQ(linked(triangular_hole_under_disc()), (Pairs{{0, 0}}));
  EXPECT_EQ(linked(triangular_ring_alone()), (Pairs{{0, 0}, {1, 0}})) << "an empty slice is outside everywhere";
  EXPECT_EQ(linked(islands_nested_four_deep()), (Pairs{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(VoidLinks, HaveADualPointInBothVoids) {
  int compared = 0;
  const auto compare = [&](const ContourStack& stack) {
    const auto slices = conformed(stack);
    for (std::size_t k = 0; k + 1 < slices.size(); ++k) {
      if (slices[k].regions() == 0 || slices[k + 1].regions() == 0) continue;
      const VoidSlab slab(slices[k], slices[k + 1]);
      const std::optional<Pairs> truth = looked_up(slab);
      if (!truth) continue;
      EXPECT_EQ(pairs_of(slab.links()), *truth);
      ++compared;
    }
  };
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    compare(random_stack(seed).stack);
  }
  EXPECT_GT(compared, 40);
}

TEST(VoidLinks, EachCriterionIncludesTheOneBefore) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto slices = conformed(random_stack(seed).stack);
    for (std::size_t k = 0; k + 1 < slices.size(); ++k) {
      const VoidSlab slab(slices[k], slices[k + 1]);
      const Pairs reverse = pairs_of(slab.links(Correspondence::reverse)),
                  medial = pairs_of(slab.links(Correspondence::medial)), overlap = pairs_of(slab.links());
      EXPECT_TRUE(std::includes(medial.begin(), medial.end(), reverse.begin(), reverse.end())) << seed;
      EXPECT_TRUE(std::includes(overlap.begin(), overlap.end(), medial.begin(), medial.end())) << seed;
      EXPECT_TRUE(reverse.contains({outside, outside})) << seed;
    }
  }
}

TEST(VoidLinks, OfMaterialAndVoidChangePlacesInAFrame) {
  // A ring's hole is to its neighbours what a disc of that size is as material.
  const double radius = 1;
  for (double radii : {0.2, 0.9, 1.5, 2.5}) {
    const Ring frame = rectangle({-6, -6}, {9, 6}), below = circle(radius), above = circle(radius, {radii * radius, 0});
    const auto holes = conformed(stack_of({{frame, below}, {frame, above}})),
               discs = conformed(stack_of({{below}, {above}}));
    const auto of_void = VoidSlab(holes[0], holes[1]).links();
    const auto of_disc = witnessed_links(triangulate_slab(discs[0].planar, discs[1].planar), discs[0].planar,
                                         discs[1].planar, Correspondence::overlap);
    EXPECT_EQ(pairs_of(of_void).contains({1, 1}), pairs_of(of_disc).contains({0, 0})) << radii;
  }
}

}  // namespace
}  // namespace odontoscope::test
