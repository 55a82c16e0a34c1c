// Correspondence over several slices: what a person would say is one thing is linked to one thing, and what ends
// stays an end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "recon/core/union_find.h"
#include "recon/delaunay/track.h"
#include "tests/delaunay/conformed.h"
#include "tests/support/random_numbers.h"
#include "tests/support/shapes.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

using namespace delaunay;

// --- scenes ----------------------------------------------------------------------------------------------------------

struct Disc {
  Point2 at;
  double radius;
};
using Scene = std::vector<std::vector<Disc>>;  // of each slice, upwards

Ring disc_ring(const Disc& disc) { return regular_polygon(24, disc.radius, disc.at, 0.1); }

ContourStack stack_of_discs(const Scene& scene, double height) {
  ContourStack stack;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    stack.slices.push_back({height * double(k), {}});
    for (const Disc& disc : scene[k]) stack.slices.back().contours.push_back({"tooth", disc_ring(disc)});
  }
  return stack;
}

/// The same discs as holes in one large outline.
ContourStack stack_of_holes(const Scene& scene, double height) {
  ContourStack stack = stack_of_discs(scene, height);
  for (Slice& slice : stack.slices)
    slice.contours.insert(slice.contours.begin(), {"tooth", rectangle({-20, -20}, {40, 20})});
  return stack;
}

constexpr double cut = 0.5;    // mm between slices
constexpr double thin = 0.15;  // radius of a canal, mm

Scene straight(int slices, double step, double radius) {
  Scene scene;
  for (int k = 0; k < slices; ++k) scene.push_back({{{step * k, 0}, radius}});
  return scene;
}

/// Two canals at 45 degrees side by side, `gap` apart along their drift.
Scene parallel_canals(double gap) {
  Scene scene;
  for (int k = 0; k < 8; ++k) scene.push_back({{{cut * k, 0}, thin}, {{cut * k + gap, 0}, thin}});
  return scene;
}

/// Two canals at 45 degrees that pass each other.
Scene passing_canals() {
  Scene scene;
  for (int k = 0; k < 9; ++k) scene.push_back({{{cut * (k - 4), 0.2}, thin}, {{-cut * (k - 4), -0.2}, thin}});
  return scene;
}

/// A canal that ends, and another one that begins in the next slice somewhere else.
Scene canal_that_ends() {
  Scene scene;
  for (int k = 0; k < 10; ++k) {
    if (k < 5)
      scene.push_back({{{cut * k, 0}, thin}});
    else
      scene.push_back({{{1.0 + cut * (k - 5), 0.8}, thin}});
  }
  return scene;
}

/// An upright canal that forks into two at 45 degrees.
Scene fork() {
  Scene scene;
  for (int k = 0; k < 8; ++k) {
    const double away = cut * (k - 3);
    if (k <= 3)
      scene.push_back({{{0, 0}, thin}});
    else
      scene.push_back({{{away, 0}, thin}, {{-away, 0}, thin}});
  }
  return scene;
}

/// A chamber through all slices, and a canal at 45 degrees that runs into it.
Scene accessory_canal() {
  Scene scene;
  for (int k = 0; k < 10; ++k) {
    scene.push_back({{{0, 0}, 1.5}});
    if (k < 5) scene.back().push_back({{1.9 + cut * (4 - k), 0}, thin});
  }
  return scene;
}

/// Two domes on one base that lean towards each other, one higher than the other.
Scene leaning_cusps() {
  Scene scene{{{{0, 0}, 3}}, {{{0, 0}, 2.9}}};
  for (int k = 0; k < 6; ++k) {
    scene.emplace_back();
    for (const double side : {-1.0, 1.0}) {
      const double height = (side < 0 ? 2.0 : 3.2) - cut * k;
      if (height > 0) scene.back().push_back({{side * (1.4 - 0.15 * k), 0}, 0.7 * std::sqrt(height / 3.2)});
    }
  }
  return scene;
}

/// A root that tapers to its apex, upside down, beside another one that goes on.
Scene apex_beside_root() {
  Scene scene;
  for (int k = 0; k < 8; ++k) {
    scene.push_back({{{0, 0}, 1}});
    const double radius = 0.6 - 0.13 * k;
    if (radius > 0) scene.back().push_back({{2.0 - 0.2 * k, 0}, radius});
  }
  return scene;
}

/// A cone that leans so far over that, moved on, its tip would lie in the column beside it.
Scene tip_that_leans_on_a_column() {
  return {{{{0, 0}, 1}, {{1.85, 0}, 0.5}}, {{{0, 0}, 1}, {{1.4, 0}, 0.35}}, {{{0, 0}, 1}}, {{{0, 0}, 1}}};
}

/// Islands strewn at random, none touching another.
Scene strewn(std::uint64_t seed, int slices = 8, int islands = 15) {
  RandomNumbers random(seed);
  Scene scene;
  for (int k = 0; k < slices; ++k) {
    scene.emplace_back();
    while (int(scene.back().size()) < islands) {
      const Disc disc{{random.between(-4, 4), random.between(-4, 4)}, random.between(0.1, 0.25)};
      const auto near = [&](const Disc& other) {
        return std::hypot(disc.at.x - other.at.x, disc.at.y - other.at.y) < 1.2 * (disc.radius + other.radius);
      };
      if (std::none_of(scene.back().begin(), scene.back().end(), near)) scene.back().push_back(disc);
    }
  }
  return scene;
}

// --- what tracking makes of them -------------------------------------------------------------------------------------

struct Tracked {
  std::vector<ShapeSlice> slices;
  std::vector<KnownLinks> slabs;
  Tracking tracking;

  std::size_t count(TrackedBy by) const {
    std::size_t found = 0;
    for (const auto& links : tracking.links)
      found += std::count_if(links.begin(), links.end(), [by](const TrackedLink& link) { return link.by == by; });
    return found;
  }
  std::size_t count() const {
    return count(TrackedBy::drift) + count(TrackedBy::entry) + count(TrackedBy::overlap) + count(TrackedBy::beside);
  }

  /// All links, made and tracked: slab, lower, upper.
  std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> links() const {
    std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> all;
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      for (const RegionLink& link : slabs[k].made) all.insert({k, link.lower, link.upper});
      for (const TrackedLink& link : tracking.links[k]) all.insert({k, link.lower, link.upper});
    }
    return all;
  }

  /// Connected things, the outside left out.
  std::size_t pieces() const {
    std::vector<std::size_t> first;
    std::size_t count = 0;
    for (const ShapeSlice& slice : slices) {
      first.push_back(count);
      count += slice.shapes.size();
    }
    UnionFind groups(count);
    for (const auto& [k, a, b] : links())
      if (!slices[k].shapes[a].unbounded && !slices[k + 1].shapes[b].unbounded)
        groups.join(std::uint32_t(first[k] + a), std::uint32_t(first[k + 1] + b));
    std::set<std::uint32_t> heads;
    for (std::size_t k = 0; k < slices.size(); ++k)
      for (std::uint32_t i = 0; i < slices[k].shapes.size(); ++i)
        if (!slices[k].shapes[i].unbounded) heads.insert(groups.find(std::uint32_t(first[k] + i)));
    return heads.size();
  }
};

std::vector<RegionLink> region_witnesses(const ConformedSlice& lower, const ConformedSlice& upper) {
  if (lower.regions() == 0 || upper.regions() == 0) return {};
  return witnessed_links(triangulate_slab(lower.planar, upper.planar), lower.planar, upper.planar,
                         Correspondence::overlap);
}

std::vector<RegionLink> void_witnesses(const ConformedSlice& lower, const ConformedSlice& upper) {
  std::vector<SlabTetrahedron> tetrahedra;
  if (lower.regions() > 0 && upper.regions() > 0) tetrahedra = triangulate_slab(lower.planar, upper.planar);
  return witnessed_void_links(tetrahedra, lower.planar, upper.planar, voids_in(lower.planar, lower, voids_of(lower)),
                              voids_in(upper.planar, upper, voids_of(upper)), Correspondence::overlap);
}

Tracked tracked(const ContourStack& stack, Correspondence criterion = Correspondence::medial,
                const std::map<std::size_t, ShapePairs>& apart = {}) {
  const auto slices = conformed(stack);
  Tracked result;
  for (const ConformedSlice& slice : slices) result.slices.push_back(region_shapes(slice));
  for (std::size_t k = 0; k + 1 < slices.size(); ++k) {
    result.slabs.push_back(links_by(region_witnesses(slices[k], slices[k + 1]), criterion));
    if (apart.contains(k)) result.slabs.back().apart = apart.at(k);
  }
  result.tracking = track(result.slices, result.slabs);
  return result;
}

Tracked tracked_voids(const ContourStack& stack) {
  const auto slices = conformed(stack);
  Tracked result;
  for (const ConformedSlice& slice : slices) result.slices.push_back(void_shapes(slice, voids_of(slice)));
  for (std::size_t k = 0; k + 1 < slices.size(); ++k)
    result.slabs.push_back(links_by(void_witnesses(slices[k], slices[k + 1]), Correspondence::medial));
  result.tracking = track(result.slices, result.slabs);
  return result;
}

/// One piece, each slice linked with the next once.
void expect_one_chain(const Tracked& made, std::size_t slices) {
  EXPECT_EQ(made.pieces(), 1u);
  std::set<std::size_t> slabs;
  std::size_t bounded = 0;
  for (const auto& [k, a, b] : made.links())
    if (!made.slices[k].shapes[a].unbounded) slabs.insert(k), ++bounded;
  EXPECT_EQ(slabs.size(), slices - 1);
  EXPECT_EQ(bounded, slices - 1);
}

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

// --- bits beside a body ----------------------------------------------------------------------------------------------

/// A chamber through ten slices, and a canal so flat that only two sections show, `gap` mm from it and from each other.
Scene flat_canal(double gap) {
  Scene scene;
  for (int k = 0; k < 10; ++k) scene.push_back({{{0, 0}, 0.4}});
  scene[5].push_back({{0.4 + gap + thin, 0}, thin});
  scene[4].push_back({{0.4 + 2 * gap + 3 * thin, 0.1}, thin});
  return scene;
}

TEST(Tracking, BeadsBesideABodyAreItsPartsAndAreAskedAbout) {
  for (const Tracked& made :
       {tracked(stack_of_discs(flat_canal(0.2), cut)), tracked_voids(stack_of_holes(flat_canal(0.2), cut))}) {
    EXPECT_EQ(made.pieces(), 1u);
    EXPECT_EQ(made.count(TrackedBy::beside), 2u);
    EXPECT_EQ(
        std::count_if(made.tracking.doubtful.begin(), made.tracking.doubtful.end(),
                      [](const DoubtfulLink& d) { return d.by == TrackedBy::beside && d.choice == Choice::may_part; }),
        2);
  }
}

TEST(Tracking, BeadsFarFromTheBodyAreLeftAlone) {
  const Tracked made = tracked(stack_of_discs(flat_canal(0.8), cut));
  EXPECT_EQ(made.count(TrackedBy::beside), 0u);
  EXPECT_EQ(made.pieces(), 3u);
}

TEST(Tracking, BeadsThatTheUserKeepsApartAreLeftAlone) {
  const Tracked made = tracked(stack_of_discs(flat_canal(0.2), cut), Correspondence::medial, {{4, {{1, 1}}}});
  EXPECT_TRUE(made.tracking.links[4].empty() || !made.links().contains({4, 1, 1}));
}

TEST(Tracking, OfManyBitsNoneIsToldFromNoise) {
  Scene scene = flat_canal(0.2);
  for (int i = 0; i < 60; ++i) scene[2 * (i % 4) + 1].push_back({{3 + 0.5 * (i / 4), 0.5 * (i % 4)}, 0.05});
  EXPECT_EQ(tracked(stack_of_discs(scene, cut)).count(TrackedBy::beside), 0u);
}

/// A root with a canal in its middle and, in slice 5, a bead beside it that hangs on the canal of slice 6. In slice 4
/// the root is 1.4 mm wide or as wide as is asked for, and has a notch where the bead's canal would leave, or none.
ContourStack bead_beside_surface(bool notch, double radius_below = 1.4) {
  ContourStack stack;
  for (int k = 0; k < 10; ++k) {
    Ring root = regular_polygon(60, k <= 4 ? radius_below : 1.4, {0, 0}, 0);
    if (notch && k == 4)
      for (Point2& p : root)
        if (p.x > 0 && std::abs(p.y) < 0.2) p = {0.95, p.y};
    stack.slices.push_back({cut * k, {{"tooth", root}, {"tooth", disc_ring({{k < 6 ? 0 : 0.1, 0}, 0.4})}}});
    if (k == 5) stack.slices.back().contours.push_back({"tooth", disc_ring({{0.75, 0}, thin})});
  }
  return stack;
}

TEST(Tracking, ACanalLeavesThroughANotchOfTheSurface) {
  const auto opens = [](const ContourStack& stack) {
    const Tracked made = tracked_voids(stack);
    EXPECT_EQ(made.pieces(), 1u) << "the bead hangs on the canal";
    return std::count_if(made.tracking.links[4].begin(), made.tracking.links[4].end(),
                         [](const TrackedLink& link) { return link.lower == outside && link.by == TrackedBy::beside; });
  };
  EXPECT_EQ(opens(bead_beside_surface(true)), 1);
  EXPECT_EQ(opens(bead_beside_surface(false)), 0) << "the wall is whole";
  EXPECT_EQ(opens(bead_beside_surface(false, 0.95)), 0) << "the root ends, and its canal may close";
}

/// A root of 1.4 mm with a canal of 0.4 mm all the way. In slice 5 the canal has a lobe up to x = `lobe`, in slice 4
/// the root a notch down to x = `notch`.
ContourStack lobe_over_notch(double lobe, double canal = 0.4, double notch = 0.7) {
  ContourStack stack;
  for (int k = 0; k < 10; ++k) {
    Ring root = regular_polygon(60, 1.4, {0, 0}, 0), hollow = disc_ring({{0, 0}, canal});
    if (k == 4)
      for (Point2& p : root)
        if (p.x > 0 && std::abs(p.y) < 0.2) p = {notch, p.y};
    if (k == 5)
      for (Point2& p : hollow)
        if (p.x > 0.8 * canal) p = {lobe, p.y};
    stack.slices.push_back({cut * k, {{"tooth", root}, {"tooth", hollow}}});
  }
  return stack;
}

long asked_of_lobe(const ContourStack& stack) {
  const Tracked made = tracked_voids(stack);
  return std::count_if(made.tracking.doubtful.begin(), made.tracking.doubtful.end(), [](const DoubtfulLink& d) {
    return d.choice == Choice::may_connect && d.slab == 4 && d.lower == outside;
  });
}

TEST(Tracking, AnAccessoryCanalLeavesFromALobeOfTheCanalThroughANotchBeyond) {
  const auto opens = [](const ContourStack& stack) {
    const Tracked made = tracked_voids(stack);
    std::size_t count = 0;
    for (const auto& links : made.tracking.links) count += links.size();
    EXPECT_EQ(made.tracking.doubtful.size(), count) << "each is told";
    return count;
  };
  EXPECT_EQ(opens(lobe_over_notch(0.8)), 1u);
  EXPECT_EQ(opens(lobe_over_notch(0.65)), 0u) << "no point in common";
  EXPECT_EQ(asked_of_lobe(lobe_over_notch(0.69)), 1) << "but nearly";
  EXPECT_EQ(opens(lobe_over_notch(0.95, 0.8, 0.9)), 0u) << "no canal, but a thin wall that drifts";
}

/// Two roots, one of them shorter, with a canal as wide in its last two slices as is asked for.
ContourStack short_root(double last, double last_but_one) {
  ContourStack stack;
  for (int k = 0; k < 6; ++k) {
    stack.slices.push_back({cut * k, {{"tooth", disc_ring({{5, 0}, 1})}}});
    if (k < 2) continue;
    stack.slices.back().contours.push_back({"tooth", disc_ring({{0, 0}, 1})});
    stack.slices.back().contours.push_back({"tooth", disc_ring({{0, 0},
                                                                k == 2   ? last
                                                                : k == 3 ? last_but_one
                                                                         : 0.35})});
  }
  return stack;
}

TEST(Doubts, ACanalThatIsRunningOutMayCloseWhereItsRootEnds) {
  const auto closing = [](const ContourStack& stack) {
    const Tracked made = tracked_voids(stack);
    return std::count_if(made.tracking.doubtful.begin(), made.tracking.doubtful.end(), [](const DoubtfulLink& d) {
      return d.choice == Choice::may_part && d.slab == 1 && d.lower == outside;
    });
  };
  EXPECT_EQ(closing(short_root(0.17, 0.3)), 1);
  EXPECT_EQ(closing(short_root(0.3, 0.32)), 0) << "as wide as before";
}

/// A canal that leans by 0.2 mm a slice and is running out at x = -0.8 in slice 1; the tip of the root, in slice 0,
/// lies where it is asked for.
ContourStack leaning_canal_over_tip(double tip) {
  ContourStack stack;
  stack.slices.push_back({0, {{"tooth", disc_ring({{tip, 0}, 0.25})}}});
  for (int k = 1; k < 6; ++k) {
    const double radius = k == 1 ? 0.15 : k == 2 ? 0.25 : 0.3;
    stack.slices.push_back(
        {cut * k, {{"tooth", disc_ring({{0, 0}, 2})}, {"tooth", disc_ring({{-0.2 * (5 - k), 0}, radius})}}});
  }
  return stack;
}

long asked_in_lowest_slab(const Tracked& made, Choice choice) {
  return std::count_if(made.tracking.doubtful.begin(), made.tracking.doubtful.end(), [choice](const DoubtfulLink& d) {
    return d.choice == choice && d.slab == 0 && d.lower == outside;
  });
}

TEST(Tracking, ACanalThatRunsOutTowardsTheTipOfItsRootCloses) {
  const Tracked under = tracked_voids(leaning_canal_over_tip(-1.1)), away = tracked_voids(leaning_canal_over_tip(1.1));
  EXPECT_EQ(under.tracking.closed[0].size(), 1u);
  EXPECT_EQ(asked_in_lowest_slab(under, Choice::may_connect), 1);
  EXPECT_EQ(away.tracking.closed[0].size(), 0u);
  EXPECT_EQ(asked_in_lowest_slab(away, Choice::may_part), 1);
}

TEST(Doubts, ACanalThatRunsOutTowardsTheSurfaceMayOpen) {
  EXPECT_EQ(asked_in_lowest_slab(tracked_voids(leaning_canal_over_tip(-0.65)), Choice::may_connect), 1);
  EXPECT_EQ(asked_in_lowest_slab(tracked_voids(leaning_canal_over_tip(-0.9)), Choice::may_connect), 0)
      << "it stays within";
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

// --- doubts ----------------------------------------------------------------------------------------------------------

TEST(Doubts, AClearCanalHasNone) {
  EXPECT_TRUE(tracked(stack_of_discs(straight(8, cut, thin), cut)).tracking.doubtful.empty());
  EXPECT_TRUE(tracked(stack_of_discs(accessory_canal(), cut)).tracking.doubtful.empty());
}

TEST(Doubts, ATouchMayConnect) {
  const Tracked made = tracked(stack_of({{circle(1)}, {circle(1, {1.85, 0})}}));
  ASSERT_EQ(made.tracking.doubtful.size(), 1u);
  const DoubtfulLink& choice = made.tracking.doubtful[0];
  EXPECT_EQ(choice.choice, Choice::may_connect);
  EXPECT_EQ(choice.by, TrackedBy::overlap);
  EXPECT_EQ(std::tuple(choice.slab, choice.lower_contour, choice.upper_contour), std::tuple(0u, 0u, 0u));
  EXPECT_NEAR(choice.at.x, 0.925, 1e-9);
  EXPECT_NEAR(choice.at.z, spacing / 2, 1e-12);
}

TEST(Doubts, ASmallOverlapMayClose) {
  const Tracked made = tracked(stack_of({{circle(1)}, {circle(1, {1.6, 0})}}));
  ASSERT_EQ(made.count(TrackedBy::overlap), 1u);
  ASSERT_EQ(made.tracking.doubtful.size(), 1u);
  EXPECT_EQ(made.tracking.doubtful[0].choice, Choice::may_part);
}

// A sliver in the last slice of a wall, as at enamel's margin.
TEST(Doubts, AnEndThatLiesOverNothingElseIsNoChoice) {
  EXPECT_TRUE(tracked(stack_of({{circle(1)}, {circle(1, {1.6, 0})}, {circle(1, {1.6, 0})}})).tracking.doubtful.empty());
  const Tracked two = tracked(stack_of(
      {{circle(1)}, {circle(1, {1.6, 0}), circle(1, {-1.6, 0})}, {circle(1, {1.6, 0}), circle(1, {-1.6, 0})}}));
  EXPECT_FALSE(two.tracking.doubtful.empty()) << "it lies over two";
}

/// A canal, and a branch that comes down towards it by 0.3 mm a slice and would lie `off` its middle in the slice where
/// it is gone.
ContourStack fork(double off) {
  ContourStack stack;
  for (int k = 0; k < 9; ++k) {
    stack.slices.push_back({cut * k, {{"tooth", disc_ring({{0, 0}, 0.3})}}});
    if (k >= 4) stack.slices.back().contours.push_back({"tooth", disc_ring({{off + 0.3 * (k - 3), 0}, 0.2})});
  }
  return stack;
}

TEST(Doubts, AForkOfWhichAQuarterMeetsTheCanalIsJoinedAndTold) {
  const Tracked made = tracked(fork(0.36));  // a little more than a quarter of its area
  EXPECT_EQ(made.count(TrackedBy::entry), 1u);
  ASSERT_EQ(made.tracking.doubtful.size(), 1u);
  EXPECT_EQ(made.tracking.doubtful[0].choice, Choice::may_part);
  EXPECT_EQ(tracked(fork(0.46)).count(TrackedBy::entry), 0u) << "less than a tenth";
}

/// Two canals that begin over one, like it in size but narrowing towards it; the second lies less over it, by so much
/// aside.
ContourStack two_over_one(double aside) {
  ContourStack stack;
  for (int k = 0; k < 7; ++k) {
    stack.slices.push_back({cut * k, {}});
    auto& contours = stack.slices.back().contours;
    if (k < 3) contours.push_back({"tooth", disc_ring({{0, 0}, 0.35})});
    const double radius = k == 3 ? 0.19 : 0.28;
    if (k >= 3) contours.push_back({"tooth", disc_ring({{-0.2, 0}, radius})});
    if (k >= 3) contours.push_back({"tooth", disc_ring({{aside, 0}, radius})});
  }
  return stack;
}

TEST(Doubts, ACanalThatNarrowsTowardsItsForkIsAskedAbout) {
  const auto settled = [](double aside) {
    const Tracked made = tracked(two_over_one(aside));
    const auto joined = made.links();
    const bool linked =
        std::any_of(joined.begin(), joined.end(), [](const auto& link) { return link == std::tuple(2u, 0u, 1u); });
    return linked || std::any_of(made.tracking.doubtful.begin(), made.tracking.doubtful.end(),
                                 [](const DoubtfulLink& d) { return d.slab == 2 && d.upper == 1; });
  };
  EXPECT_TRUE(settled(0.42));
  EXPECT_FALSE(settled(0.7)) << "beside it";
}

/// A wall of seven slices, and below it a sliver beside it that is its margin; below that another one, if asked for.
ContourStack wall_with_margin(bool deeper) {
  ContourStack stack;
  for (int k = 0; k < 9; ++k) {
    if (k == 0 && !deeper) continue;
    const double x = k == 0 ? 2.2 : k == 1 ? 1.35 : 0;
    stack.slices.push_back({cut * k, {{"tooth", disc_ring({{x, 0}, k < 2 ? 0.2 : 1})}}});
  }
  return stack;
}

TEST(Doubts, TheMarginBesideItsWallIsNoChoice) {
  const Tracked margin = tracked(wall_with_margin(false)), two = tracked(wall_with_margin(true));
  EXPECT_EQ(margin.count(TrackedBy::beside), 1u);
  EXPECT_TRUE(margin.tracking.doubtful.empty());
  EXPECT_FALSE(two.tracking.doubtful.empty()) << "the second is not the first slice of all";
}

TEST(Doubts, AnOverlapThatDriftPassesOverIsAskedAbout) {
  // Each canal overlaps a fifth of the other one slice on.
  const Tracked made = tracked(stack_of_discs(parallel_canals(0.7), cut));
  EXPECT_TRUE(std::any_of(made.tracking.doubtful.begin(), made.tracking.doubtful.end(), [](const DoubtfulLink& d) {
    return d.choice == Choice::may_connect && d.by == TrackedBy::overlap && d.lower != d.upper;
  }));
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
