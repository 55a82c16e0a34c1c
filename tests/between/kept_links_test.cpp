// Interpolated slices hold to the links, where distances alone would close or open passages, or end a lobe all at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "recon/between/blend.h"
#include "tests/between/slabs.h"

namespace odontoscope::test {
namespace {

using between::blend;
using between::Surroundings;

constexpr std::array quarters{0.25, 0.5, 0.75};

/// The slab between two slices, linked where they overlap; they outlive it.
Surroundings slab_between(const Outline& lower, const Outline& upper) {
  const Links links = overlap_links(lower, upper);
  Surroundings s;
  s.lower = &lower;
  s.upper = &upper;
  s.z_lower = 0;
  s.z_upper = 1;
  s.material = links.material;
  s.voids = links.voids;
  return s;
}

std::vector<Outline> blended(const Outline& lower, const Outline& upper, bool keep_links) {
  return blend(slab_between(lower, upper), quarters, {.keep_links = keep_links});
}

std::size_t holes(const Outline& outline) {
  return static_cast<std::size_t>(
      std::count_if(outline.begin(), outline.end(), [](const Ring& ring) { return area(Outline{ring}) < 0; }));
}

/// A ring whose ends leave a gap of this width, towards +x turned by an angle.
Outline open_ring(double outer, double inner, double gap, double turned) {
  Ring points;
  constexpr int steps = 200;
  const auto add = [&](double radius, int n) {
    const double half = std::asin(gap / 2 / radius),
                 angle = turned + half + (2 * std::numbers::pi - 2 * half) * n / steps;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  for (int n = 0; n <= steps; ++n) add(outer, n);
  for (int n = steps; n >= 0; --n) add(inner, n);
  return {points};
}

// Enamel's margin in a slice: the gap in one slice lies beside the gap in the next, and half-way there is none.
TEST(KeptLinks, AnOpenRingStaysOpen) {
  const Outline lower = open_ring(4, 3.8, 0.12, 0), upper = open_ring(4, 3.8, 0.12, 0.06);
  const auto closed = [](const std::vector<Outline>& slices) {
    return std::count_if(slices.begin(), slices.end(), [](const Outline& o) { return holes(o) > 0; });
  };
  EXPECT_GT(closed(blended(lower, upper, false)), 0);  // or the test shows nothing
  for (const Outline& slice : blended(lower, upper, true)) {
    EXPECT_EQ(slice.size(), 1U);
    EXPECT_EQ(holes(slice), 0U);
  }
}

// Between the hollows of two cusps: a wall thinner than a step of the grid.
TEST(KeptLinks, AWallBetweenTwoVoidsStays) {
  const auto lower = [](double at) {
    return Outline{rectangle({-5, -3}, {5, 3}), hole(rectangle({-4, -2}, {at - 0.004, 2})),
                   hole(rectangle({at + 0.004, -2}, {4, 2}))};
  };
  const Outline below = lower(0.353), above = lower(0.357);
  const auto merged = [](const std::vector<Outline>& slices) {
    return std::count_if(slices.begin(), slices.end(), [](const Outline& o) { return holes(o) != 2; });
  };
  EXPECT_GT(merged(blended(below, above, false)), 0);
  for (const Outline& slice : blended(below, above, true)) EXPECT_EQ(holes(slice), 2U);
}

// The same for material: two bodies that all but touch.
TEST(KeptLinks, BodiesThatTouchNowhereStayApart) {
  const auto pair = [](double at) {
    return Outline{rectangle({-4, -2}, {at - 0.003, 2}), rectangle({at + 0.003, -2}, {4, 2})};
  };
  const auto one = [](const std::vector<Outline>& slices) {
    return std::count_if(slices.begin(), slices.end(), [](const Outline& o) { return o.size() == 1; });
  };
  EXPECT_GT(one(blended(pair(0.341), pair(0.343), false)), 0);
  for (const Outline& slice : blended(pair(0.341), pair(0.343), true)) EXPECT_EQ(slice.size(), 2U);
}

TEST(KeptLinks, WhatHoldsToThemIsLeftAsItIs) {
  const Outline lower = open_ring(4, 3, 1, 0), upper = open_ring(4.2, 3.1, 1.2, 0.1);
  EXPECT_EQ(blended(lower, upper, true), blended(lower, upper, false));
}

// A lobe beside a body, with a groove between them: it ends between the two slices.
TEST(DrawnBack, ALobeGrowsShorterBeforeItIsGone) {
  const Outline lower{{{0, 0}, {4, 0}, {4, 6}, {-1.5, 6}, {-1.5, 0}, {-0.5, 0}, {-0.5, 5}, {0, 5}}},
      upper{rectangle({0.1, 0}, {4, 6})};
  const Surroundings s = slab_between(lower, upper);
  const auto lowest_of_lobe = [](const Outline& outline) {
    double lowest = 6;
    for (const Ring& ring : outline)
      for (const Point2 p : ring)
        if (p.x < -0.6) lowest = std::min(lowest, p.y);
    return lowest;
  };
  double at_once = 0, longest = 0, before = 0;
  for (const Outline& slice : blend(s, quarters, {.strips = false})) {
    at_once = std::max(at_once, lowest_of_lobe(slice) - before);
    before = lowest_of_lobe(slice);
  }
  EXPECT_GT(at_once, 4);  // or the test shows nothing
  before = 0;
  double share = 0;
  const auto stages = between::blend_in_stages(s, quarters, {.strips = false, .draw_back = true});
  EXPECT_GT(stages.size(), 3U);
  for (const between::StagedOutline& stage : stages) {
    EXPECT_GT(stage.share, share);
    EXPECT_EQ(stage.outline.size(), 1U);
    share = stage.share;
    longest = std::max(longest, lowest_of_lobe(stage.outline) - before);
    before = lowest_of_lobe(stage.outline);
  }
  EXPECT_LT(share, 1);
  EXPECT_LT(longest, 1);
}

TEST(DrawnBack, NothingIsAddedWhereNothingEndsAtOnce) {
  const Outline lower{rectangle({0, 0}, {4, 6})}, upper{rectangle({0.1, 0}, {4, 6.1})};
  EXPECT_EQ(between::blend_in_stages(slab_between(lower, upper), quarters, {.draw_back = true}).size(), 3U);
}

TEST(KeptLinks, NothingBetweenTwoEmptySlices) { EXPECT_EQ(blended({}, {}, true), std::vector<Outline>(3)); }

}  // namespace
}  // namespace odontoscope::test
