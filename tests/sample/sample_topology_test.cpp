// What a dentist counts: roots, canals, horns and cusps, slice by slice; and that each stays connected from slice to
// slice.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sample/made_once.h"
#include "tests/sample/stack_queries.h"

namespace odontoscope::test {
namespace {

class SampleTopology : public testing::TestWithParam<ToothKind> {
 protected:
  SampleFacts facts = sample_facts(GetParam());
  const ContourStack& stack = made_once(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Kinds, SampleTopology,
                         testing::Values(ToothKind::molar, ToothKind::premolar, ToothKind::incisor),
                         [](const auto& kind) { return name(kind.param); });

template <class Things, class Height>
double highest(const Things& things, const Height& height) {
  double high = height(things.front());
  for (const auto& thing : things) high = std::max(high, height(thing));
  return high;
}

TEST_P(SampleTopology, RootsAreApartBelowTheFurcationAndJoinedAbove) {
  const double apices = highest(facts.roots, [](const NamedPoint& root) { return root.at.z; });
  std::size_t seen = 0;
  for (const Slice& slice : stack.slices) {
    if (slice.z > facts.furcation_z + 0.25 && slice.z < facts.cervix_z) {
      EXPECT_EQ(count(slice, "dentine"), 1u) << slice.z;
    }
    if (slice.z < apices + 0.25 || slice.z > facts.furcation_z - 0.4) continue;
    EXPECT_EQ(count(slice, "dentine"), facts.roots.size()) << slice.z;
    ++seen;
  }
  EXPECT_GT(seen, 15u);
}

TEST_P(SampleTopology, EveryCanalShowsInEverySliceOfTheRoots) {
  const double ends = highest(facts.canals, [](const CanalFact& canal) { return canal.low_z; });
  std::size_t seen = 0;
  for (const Slice& slice : stack.slices) {
    if (slice.z < ends + 0.25 || slice.z > facts.chamber_low_z - 0.25) continue;
    EXPECT_EQ(count(slice, "pulp"), facts.canals.size()) << slice.z;
    ++seen;
  }
  EXPECT_GT(seen, 30u);
}

// The lower parts of low horns flow together with the roof.
TEST_P(SampleTopology, EveryHornShowsAboveTheChamber) {
  double lowest = facts.top_z;
  for (const NamedPoint& horn : facts.horns) lowest = std::min(lowest, horn.at.z);
  std::size_t seen = 0;
  const double fine = GetParam() == ToothKind::incisor ? 0.05 : 0.1;
  for (const Slice& slice : made_once(GetParam(), fine).slices) {
    if (slice.z < (facts.chamber_high_z + lowest) / 2 || slice.z > lowest - 0.05) continue;
    EXPECT_EQ(count(slice, "pulp"), facts.horns.size()) << slice.z;
    ++seen;
  }
  EXPECT_GE(seen, 2u);
}

TEST_P(SampleTopology, ThePulpLiesInAClosedCavityOfTheDentine) {
  for (const Slice& slice : stack.slices) {
    EXPECT_EQ(count(slice, "pulp", false), 0u) << slice.z;
    const auto holes = contours(slice, "dentine", false);
    for (const Contour* pulp : contours(slice, "pulp", true)) {
      EXPECT_EQ(std::count_if(holes.begin(), holes.end(),
                              [&](const Contour* h) { return inside(pulp->points.front(), h->points); }),
                1)
          << slice.z;
    }
  }
  // The canals end short of the apex, the horns short of the enamel.
  EXPECT_EQ(count(stack.slices.front(), "pulp"), 0u);
  EXPECT_EQ(count(stack.slices.front(), "dentine", false), 0u);
  EXPECT_EQ(count(slice_at(stack, facts.cervix_z), "pulp"), 1u);
  EXPECT_EQ(count(slice_at(stack, facts.cervix_z), "dentine", false), 1u);
}

/// Outer contours of a structure with no outer contour of the next slice (in the given direction) over or under them.
std::size_t ends(const ContourStack& stack, const std::string& structure, bool upwards) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    const bool last = upwards ? i + 1 == stack.slices.size() : i == 0;
    for (const Contour* contour : contours(stack.slices[i], structure, true)) {
      bool goes_on = false;
      if (!last) {
        for (const Contour* next : contours(stack.slices[upwards ? i + 1 : i - 1], structure, true)) {
          const auto lies_in = [](const Contour* a, const Contour* b) {
            return std::any_of(a->points.begin(), a->points.end(), [b](Point2 p) { return inside(p, b->points); });
          };
          goes_on = goes_on || lies_in(next, contour) || lies_in(contour, next);
        }
      }
      if (!goes_on) ++found;
    }
  }
  return found;
}

TEST_P(SampleTopology, EnamelEndsInAsManyTipsAsThereAreCusps) {
  const std::size_t tips = GetParam() == ToothKind::incisor ? 1 : facts.cusps.size();
  EXPECT_EQ(ends(stack, "enamel", true), tips);
}

TEST_P(SampleTopology, PulpEndsInItsCanalsAndHornsOnly) {
  EXPECT_EQ(ends(stack, "pulp", false), facts.canals.size());
  EXPECT_EQ(ends(stack, "pulp", true), facts.horns.size());
}

TEST_P(SampleTopology, DentineEndsInItsRootsBelow) { EXPECT_EQ(ends(stack, "dentine", false), facts.roots.size()); }

// Canals are thin and curved: their sections in neighbouring slices must overlap well, or a reconstruction tears them.
TEST_P(SampleTopology, CanalSectionsOverlapFromSliceToSliceEvenAtTheWidestSpacing) {
  const ContourStack coarse = sample_tooth(GetParam(), {.slice_spacing = 0.35});
  const double ends_z = highest(facts.canals, [](const CanalFact& canal) { return canal.low_z; });
  for (std::size_t i = 0; i + 1 < coarse.slices.size(); ++i) {
    const Slice &lower = coarse.slices[i], &upper = coarse.slices[i + 1];
    if (lower.z < ends_z || upper.z > facts.chamber_low_z) continue;
    for (const Contour* contour : contours(lower, "pulp", true))
      EXPECT_TRUE(in_region(centroid(contour->points), upper, "pulp")) << lower.z;
  }
}

TEST_P(SampleTopology, EnamelIsThickUnderCuspsAndEndsAtTheCervix) {
  double dentine_top = 0, enamel_top = 0, enamel_low = facts.top_z;
  for (const Slice& slice : stack.slices) {
    if (count(slice, "dentine") > 0) dentine_top = std::max(dentine_top, slice.z);
    if (count(slice, "enamel") == 0) continue;
    enamel_top = std::max(enamel_top, slice.z);
    enamel_low = std::min(enamel_low, slice.z);
  }
  EXPECT_GT(enamel_top - dentine_top, 1.0);
  EXPECT_LT(enamel_top - dentine_top, 2.3);
  EXPECT_GE(enamel_low, facts.cervix_z);
  EXPECT_LE(enamel_low, facts.cervix_z + 0.3);
}

// The cap is closed all round: from where the cervical line is passed on all sides, one ring with the dentine inside.
TEST_P(SampleTopology, EnamelIsARingAroundTheDentine) {
  const double above = facts.cervix_z + facts.proportions.cervical_curve_mesial + 0.5;
  std::size_t rings = 0;
  for (const Slice& slice : stack.slices) {
    if (slice.z < above || count(slice, "dentine") != 1 || count(slice, "enamel") != 1) continue;
    EXPECT_GE(count(slice, "enamel", false), 1u) << slice.z;
    ++rings;
  }
  EXPECT_GE(rings, 6u);
}

}  // namespace
}  // namespace odontoscope::test
