// Where a canal or a root runs out: what is a bit of a body beside it, and what is a choice that must be asked about.

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

}  // namespace
}  // namespace odontoscope::test
