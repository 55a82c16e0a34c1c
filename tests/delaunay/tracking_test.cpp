// Correspondence over several slices: what a person would say is one thing is linked to one thing, and what ends
// stays an end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "tests/delaunay/tracking_scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

using namespace delaunay;

// --- one thing -------------------------------------------------------------------------------------------------------

TEST(Tracking, CirclesThatShiftSteadilyAreOnePiece) {
  for (double radii : {0.5, 1.0, 1.5, 2.0, 3.0}) {
    SCOPED_TRACE(radii);
    expect_one_chain(tracked(stack_of_discs(straight(8, radii, 1), cut)), 8);
    expect_one_chain(tracked(stack_of_discs(straight(10, radii, 1), 1.0)), 10);
    expect_one_chain(tracked_voids(stack_of_holes(straight(8, radii, 1), cut)), 8);
  }
}

TEST(Tracking, CirclesBeyondReachAreNotLinked) {
  EXPECT_EQ(tracked(stack_of_discs(straight(8, 6, 1), cut)).count(), 0u);
}

TEST(Tracking, TwoBeadsAloneSayNothing) { EXPECT_EQ(tracked(stack_of_discs(straight(2, 3, 1), cut)).count(), 0u); }

TEST(Tracking, AThinCanalAt45DegreesIsOnePiece) {
  expect_one_chain(tracked(stack_of_discs(straight(8, cut, thin), cut)), 8);
  expect_one_chain(tracked_voids(stack_of_holes(straight(8, cut, thin), cut)), 8);
}

TEST(Tracking, ABentCanalIsOnePiece) {
  Scene scene;  // a circle of radius 8 mm from upright to 45 degrees, width not quite even
  for (int k = 0; k < 12; ++k) {
    const double z = cut * k;
    scene.push_back({{{8 - std::sqrt(64 - z * z), 0.02 * ((k * 7) % 3 - 1)}, thin * (1 + 0.1 * ((k * 5) % 3 - 1))}});
  }
  expect_one_chain(tracked(stack_of_discs(scene, cut)), 12);
  expect_one_chain(tracked_voids(stack_of_holes(scene, cut)), 12);
}

TEST(Tracking, SlicesNeedNotBeEvenlySpaced) {
  ContourStack stack;
  for (const double z : {0.0, 0.5, 0.75, 1.5, 1.7, 2.3, 2.8})
    stack.slices.push_back({z, {{"tooth", disc_ring({{z, 0}, thin})}}});
  expect_one_chain(tracked(stack), 7);
}

// --- several ---------------------------------------------------------------------------------------------------------

TEST(Tracking, ParallelCanalsDoNotSwap) {
  for (double gap : {0.7, 0.8, 1.0 + cut / 3}) {
    SCOPED_TRACE(gap);
    for (const Tracked& made : {tracked(stack_of_discs(parallel_canals(gap), cut)),
                                tracked_voids(stack_of_holes(parallel_canals(gap), cut))}) {
      EXPECT_EQ(made.pieces(), 2u);
      for (const auto& [k, a, b] : made.links()) EXPECT_EQ(a, b);
    }
  }
}

TEST(Tracking, PassingCanalsDoNotSwap) {
  const Tracked made = tracked(stack_of_discs(passing_canals(), cut));
  EXPECT_EQ(made.pieces(), 2u);
  for (const auto& [k, a, b] : made.links()) EXPECT_EQ(a, b);
}

TEST(Tracking, ACanalThatEndsIsNotLinkedToAFarOne) {
  const Tracked made = tracked(stack_of_discs(canal_that_ends(), cut));
  EXPECT_EQ(made.pieces(), 2u);
  EXPECT_TRUE(made.tracking.links[4].empty());
  EXPECT_TRUE(tracked_voids(stack_of_holes(canal_that_ends(), cut)).tracking.links[4].empty()) << "the hole ends blind";
}

TEST(Tracking, AForkIsOnePiece) {
  for (const Tracked& made : {tracked(stack_of_discs(fork(), cut)), tracked_voids(stack_of_holes(fork(), cut))}) {
    EXPECT_EQ(made.pieces(), 1u);
    EXPECT_EQ(made.tracking.links[3].size(), 2u);
  }
}

TEST(Tracking, AnAccessoryCanalJoinsTheChamber) {
  for (const Tracked& made :
       {tracked(stack_of_discs(accessory_canal(), cut)), tracked_voids(stack_of_holes(accessory_canal(), cut))}) {
    EXPECT_EQ(made.pieces(), 1u);
    EXPECT_EQ(made.count(TrackedBy::entry), 1u);
    EXPECT_EQ(made.tracking.links[4].size(), 1u);
  }
}

// --- what is two things ----------------------------------------------------------------------------------------------

TEST(Tracking, CuspTipsAreNotLinked) {
  const Tracked made = tracked(stack_of_discs(leaning_cusps(), cut));
  EXPECT_EQ(made.count(), 0u);
  EXPECT_EQ(made.pieces(), 1u) << "they stand on one base";
}

TEST(Tracking, ATipThatRunsOutIsNotLinkedWithWhatItLeansOn) {
  const Tracked made = tracked(stack_of_discs(tip_that_leans_on_a_column(), cut));
  EXPECT_EQ(made.count(), 0u);
  EXPECT_EQ(made.pieces(), 2u);
}

TEST(Tracking, AnApexIsNotLinkedWithTheRootBeside) {
  const Tracked made = tracked(stack_of_discs(apex_beside_root(), cut));
  EXPECT_EQ(made.count(), 0u);
  EXPECT_EQ(made.pieces(), 2u);
}

TEST(Tracking, StrewnIslandsAreNotLinked) {
  std::size_t linked = 0, asked = 0, histories = 0;
  const std::uint64_t stacks = 40;
  for (std::uint64_t seed = 0; seed < stacks; ++seed) {
    const Tracked made = tracked(stack_of_discs(strewn(seed), cut));
    linked += made.count(TrackedBy::drift) + made.count(TrackedBy::entry);
    histories += 2 * (made.links().size() - made.count(TrackedBy::drift) - made.count(TrackedBy::entry));
    for (const DoubtfulLink& choice : made.tracking.doubtful) asked += choice.by != TrackedBy::overlap;
  }
  // What the limits promise: so many by chance a stack, and so many for each end of what lies over another island by
  // chance.
  EXPECT_LE(double(linked), limits::track_chance * double(stacks + histories));
  EXPECT_LE(double(asked), limits::track_chance_doubtful * double(stacks + histories));
  // An island has some two others within reach: linking the nearest would make thousands.
  EXPECT_LE(linked, 12u);
  EXPECT_GT(histories, 100u);
}

TEST(Tracking, ACanalIsFoundAmongStrewnIslands) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Scene scene = strewn(seed, 10, 8);
    for (int k = 0; k < 10; ++k) {
      std::erase_if(scene[k], [&](const Disc& d) { return std::hypot(d.at.x - cut * k, d.at.y - 5) < 0.6; });
      scene[k].insert(scene[k].begin(), {{cut * k - 2, 5}, thin});
    }
    const auto links = tracked(stack_of_discs(scene, cut)).links();
    for (std::size_t k = 0; k < 9; ++k) EXPECT_TRUE(links.contains({k, 0, 0})) << seed << " " << k;
  }
}

// --- overlap, and the user's word ------------------------------------------------------------------------------------

TEST(Tracking, AFreeEndTakesWhatItOverlapsMost) {
  const Tracked made = tracked(stack_of({{circle(1)}, {circle(1, {1.5, 0}), circle(1, {-1.6, 0})}}));
  ASSERT_EQ(made.count(TrackedBy::overlap), 2u) << "both ends above hang free, and overlap the one below";
  const Tracked two = tracked(stack_of({{circle(1), circle(1, {3, 0})}, {circle(1, {1.5, 0})}, {circle(1, {1.5, 0})}}));
  EXPECT_EQ(two.count(TrackedBy::overlap), 2u);
  EXPECT_EQ(tracked(stack_of({{circle(1)}, {circle(1, {1.95, 0})}})).count(), 0u) << "a touch";
}

TEST(Tracking, NothingIsLinkedThatTheUserKeepsApart) {
  const ContourStack stack = stack_of_discs(straight(8, 1.5, 1), cut);
  const Tracked made = tracked(stack, Correspondence::medial, {{3, {{0, 0}}}});
  EXPECT_EQ(made.pieces(), 2u);
  EXPECT_TRUE(made.tracking.links[3].empty());
}

TEST(Tracking, NeverTakesALinkBackAndOnlyLinksFreeEnds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Tracked made = tracked(stack_of_discs(strewn(seed, 6, 25), cut));
    for (std::size_t k = 0; k < made.slabs.size(); ++k)
      for (const TrackedLink& link : made.tracking.links[k]) {
        const auto has = [&](auto end) {
          return std::any_of(made.slabs[k].made.begin(), made.slabs[k].made.end(), end);
        };
        EXPECT_FALSE(has([&](const RegionLink& l) { return l.lower == link.lower; }) &&
                     has([&](const RegionLink& l) { return l.upper == link.upper; }));
      }
  }
}

TEST(Tracking, ClosesNoLoopByItself) {
  Scene scene = fork();
  for (int k = 7; k-- > 0;) scene.push_back(fork()[std::size_t(k)]);  // the branches come together again
  const Tracked made = tracked(stack_of_discs(scene, cut));
  std::size_t shapes = 0;
  for (const auto& slice : made.slices) shapes += slice.shapes.size();
  EXPECT_EQ(made.links().size(), shapes - made.pieces()) << "a forest";
  const auto& doubtful = made.tracking.doubtful;
  EXPECT_TRUE(std::any_of(doubtful.begin(), doubtful.end(),
                          [](const DoubtfulLink& d) { return d.choice == Choice::may_connect; }));
}

// --- the same seen differently ---------------------------------------------------------------------------------------

/// Links by place, as they were before the stack was changed by `back`'s inverse.
std::set<std::vector<long>> places(const Tracked& made, const std::function<Point3(Point3)>& back) {
  std::set<std::vector<long>> all;
  for (const auto& [k, a, b] : made.links()) {
    const auto end = [&](std::size_t slice, std::uint32_t i) {
      const TrackedShape& shape = made.slices[slice].shapes[i];
      const Point3 p = back({shape.centroid.x, shape.centroid.y, made.slices[slice].z});
      return std::vector<long>{std::lround(p.z * 1e6), std::lround(p.x * 1e6), std::lround(p.y * 1e6)};
    };
    std::vector<long> first = end(k, a), second = end(k + 1, b);
    if (second < first) std::swap(first, second);
    first.insert(first.end(), second.begin(), second.end());
    all.insert(first);
  }
  return all;
}

TEST(Tracking, LooksTheSameFromEverySide) {
  const std::map<std::string, std::function<Point3(Point3)>> back{{"rotated by 90 degrees",
                                                                   [](Point3 p) {
                                                                     return Point3{p.y, -p.x, p.z};
                                                                   }},
                                                                  {"mirrored",
                                                                   [](Point3 p) {
                                                                     return Point3{-p.x, p.y, p.z};
                                                                   }},
                                                                  {"z reversed",
                                                                   [](Point3 p) {
                                                                     return Point3{p.x, p.y, -p.z};
                                                                   }},
                                                                  {"permuted", [](Point3 p) { return p; }},
                                                                  {"doubled", [](Point3 p) {
                                                                     return Point3{p.x / 2, p.y / 2, p.z / 2};
                                                                   }}};
  std::map<std::string, Scene> scenes{{"canal", straight(8, cut, thin)},
                                      {"parallel", parallel_canals(0.7)},
                                      {"passing", passing_canals()},
                                      {"ends", canal_that_ends()},
                                      {"fork", fork()},
                                      {"accessory", accessory_canal()},
                                      {"cusps", leaning_cusps()},
                                      {"apex", apex_beside_root()}};
  for (std::uint64_t seed = 0; seed < 6; ++seed) scenes["strewn " + std::to_string(seed)] = strewn(seed, 6, 30);
  for (const auto& [name, scene] : scenes)
    for (const bool holes : {false, true}) {
      const ContourStack stack = holes ? stack_of_holes(scene, cut) : stack_of_discs(scene, cut);
      const auto links = [&](const ContourStack& of, const auto& undo) {
        return places(holes ? tracked_voids(of) : tracked(of), undo);
      };
      const auto expected = links(stack, back.at("permuted"));
      for (const Variant& variant : variants_of(stack, 5))
        EXPECT_EQ(links(variant.stack, back.at(variant.name)), expected)
            << name << ", " << variant.name << (holes ? ", holes" : "");
    }
}

// --- overlapping areas -----------------------------------------------------------------------------------------------

TrackedShape shape_of(const std::vector<Ring>& rings) {
  return region_shapes(conformed(stack_of({rings, {}})).front()).shapes.at(0);
}

TEST(OverlapArea, OfSquaresIsTheirCommonRectangle) {
  const TrackedShape square = shape_of({rectangle({0, 0}, {2, 2})});
  for (double x : {-2.5, -2.0, -0.5, 0.0, 0.75, 2.0, 3.0})
    for (double y : {-1.0, 0.0, 0.25, 2.0}) {
      const double expected = std::max(0.0, 2 - std::abs(x)) * std::max(0.0, 2 - std::abs(y));
      EXPECT_NEAR(overlap_area(square, {x, y}, square), expected, 1e-12) << x << " " << y;
    }
}

TEST(OverlapArea, OfCirclesIsTheirLens) {
  const TrackedShape disc = shape_of({regular_polygon(2000, 1)});
  for (double d : {0.0, 0.3, 1.0, 1.7, 1.99, 2.01}) {
    const double lens = d < 2 ? 2 * std::acos(d / 2) - d / 2 * std::sqrt(4 - d * d) : 0;
    EXPECT_NEAR(overlap_area(disc, {d, 0}, disc), lens, 2e-5) << d;
  }
}

TEST(OverlapArea, LeavesHolesOutOnBothSides) {
  const TrackedShape frame = shape_of({rectangle({-3, -3}, {3, 3}), rectangle({-1, -1}, {1, 1})});
  const TrackedShape square = shape_of({rectangle({-2, -2}, {2, 2})});
  EXPECT_NEAR(net_area(frame), 32, 1e-12);
  EXPECT_NEAR(overlap_area(square, {}, frame), 12, 1e-12);
  EXPECT_NEAR(overlap_area(frame, {}, square), 12, 1e-12);
  EXPECT_NEAR(overlap_area(frame, {1, 0}, frame), 5 * 6 - 3 * 2, 1e-12);
}

TEST(OverlapArea, OfTheOutsideIsWhatNoRegionCovers) {
  const auto slices = conformed(stack_of({{rectangle({-3, -3}, {3, 3}), rectangle({-1, -1}, {1, 1})}, {}}));
  const ShapeSlice voids = void_shapes(slices[0], voids_of(slices[0]));
  const TrackedShape square = shape_of({rectangle({0, 0}, {2, 2})});
  EXPECT_NEAR(overlap_area(square, {0, 0}, voids.shapes[0]), 0, 1e-12);
  EXPECT_NEAR(overlap_area(square, {2, 2}, voids.shapes[0]), 3, 1e-12);
  EXPECT_NEAR(overlap_area(square, {9, 9}, voids.shapes[0]), 4, 1e-12);
  EXPECT_NEAR(overlap_area(square, {0, 0}, voids.shapes[1]), 1, 1e-12);
}

TEST(TrackedShapes, AreFilledOutlines) {
  const TrackedShape ring = shape_of({circle(2, {1000, 5}), circle(1, {1000.5, 5})});
  EXPECT_NEAR(ring.centroid.x, 1000, 1e-9);
  EXPECT_NEAR(ring.radius, 2, 0.01);
  const auto slice = conformed(islands_nested_four_deep()).front();
  const ShapeSlice voids = void_shapes(slice, voids_of(slice));
  ASSERT_EQ(voids.shapes.size(), 3u);
  std::multiset<std::size_t> contours;
  for (const TrackedShape& shape : voids.shapes) contours.insert(shape.contours.size());
  EXPECT_EQ(contours, (std::multiset<std::size_t>{1, 1, 2}));
}

}  // namespace
}  // namespace odontoscope::test
