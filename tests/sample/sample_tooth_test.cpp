// Sample teeth: determinism, validity, proportions after Wheeler, and that what sample_facts says is true of the
// contours.

#include "recon/sample/sample_tooth.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/input/validate.h"
#include "recon/sample/tooth_number.h"
#include "tests/sample/made_once.h"
#include "tests/sample/stack_queries.h"

namespace odontoscope::test {
namespace {

constexpr double slice_apart = 0.2;  // mm; slices are no farther apart at cervix, horns, cusps and apices

const ToothKind kinds[] = {ToothKind::molar, ToothKind::premolar, ToothKind::incisor};

class SampleTooth : public testing::TestWithParam<ToothKind> {
 protected:
  SampleFacts facts = sample_facts(GetParam());
  const ContourStack& stack = made_once(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Kinds, SampleTooth, testing::ValuesIn(kinds),
                         [](const auto& kind) { return name(kind.param); });

bool same(const ContourStack& a, const ContourStack& b) {
  if (a.slices.size() != b.slices.size()) return false;
  for (std::size_t s = 0; s < a.slices.size(); ++s) {
    if (a.slices[s].z != b.slices[s].z || a.slices[s].contours.size() != b.slices[s].contours.size()) return false;
    for (std::size_t c = 0; c < a.slices[s].contours.size(); ++c) {
      const Contour &p = a.slices[s].contours[c], &q = b.slices[s].contours[c];
      if (p.structure != q.structure || p.points != q.points) return false;
    }
  }
  return true;
}

TEST_P(SampleTooth, IsDeterministic) { EXPECT_TRUE(same(stack, sample_tooth(GetParam()))); }

TEST_P(SampleTooth, IsValidWithAnyOptions) {
  EXPECT_NO_THROW(validate(stack));
  for (const SampleOptions& options : {SampleOptions{0.35, 0.05}, SampleOptions{0.13, 1.0, SampleWalls::apart, false},
                                       SampleOptions{0.13, 1.0, SampleWalls::filled}})
    EXPECT_NO_THROW(validate(sample_tooth(GetParam(), options))) << *options.slice_spacing;
}

TEST_P(SampleTooth, HasThreeStructuresOnAscendingEvenlySpacedSlicesIfAsked) {
  constexpr double spacing = 0.25;
  const ContourStack& even = made_once(GetParam(), spacing);
  EXPECT_EQ(structures_of(even).size(), 3u);
  for (const char* structure : {"enamel", "dentine", "pulp"})
    EXPECT_NE(
        std::count_if(even.slices.begin(), even.slices.end(), [&](const Slice& s) { return count(s, structure) > 0; }),
        0);
  for (std::size_t i = 1; i < even.slices.size(); ++i)
    EXPECT_NEAR(even.slices[i].z - even.slices[i - 1].z, spacing, 1e-9);
  EXPECT_NEAR(static_cast<double>(even.slices.size()), facts.top_z / spacing, 1);
}

/// Widest distance of neighbouring slices that touch a range of heights.
double widest_gap(const ContourStack& stack, double low, double high) {
  double widest = 0;
  for (std::size_t i = 1; i < stack.slices.size(); ++i)
    if (stack.slices[i].z > low && stack.slices[i - 1].z < high)
      widest = std::max(widest, stack.slices[i].z - stack.slices[i - 1].z);
  return widest;
}

// What a slice apart would show as a step: apices, the chamber's floor and roof, the cervical line, cusps and edge.
TEST_P(SampleTooth, SlicesAreCloserWhereTheShapeIsSteep) {
  constexpr double close = 0.2, usual = 0.25;
  for (const NamedPoint& root : facts.roots) EXPECT_LT(widest_gap(stack, root.at.z + 0.1, root.at.z + 0.6), close);
  for (const NamedPoint& horn : facts.horns) EXPECT_LT(widest_gap(stack, horn.at.z - 0.4, horn.at.z), close);
  EXPECT_LT(widest_gap(stack, facts.cervix_z, facts.cervix_z + facts.proportions.cervical_curve_mesial), close);
  for (const NamedPoint& cusp : facts.cusps) EXPECT_LT(widest_gap(stack, cusp.at.z - 0.3, cusp.at.z), close);
  if (facts.roots.size() > 1) {
    EXPECT_LT(widest_gap(stack, facts.chamber_low_z - 0.2, facts.chamber_low_z + 0.2), close);
  }
  std::size_t points = 0, even_points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  for (const Slice& slice : made_once(GetParam(), usual).slices)
    for (const Contour& contour : slice.contours) even_points += contour.points.size();
  EXPECT_LT(static_cast<double>(points), 1.4 * static_cast<double>(even_points));
}

TEST_P(SampleTooth, OuterContoursRunCounterClockwiseAndHolesClockwise) {
  for (const Slice& slice : stack.slices) {
    for (const char* structure : {"enamel", "dentine", "pulp"}) {
      for (const Contour* contour : contours(slice, structure, true))
        EXPECT_GT(area(contour->points), 0) << structure << slice.z;
      for (const Contour* contour : contours(slice, structure, false))
        EXPECT_LT(area(contour->points), 0) << structure << slice.z;
    }
  }
}

TEST_P(SampleTooth, PointsAreAsDenseAsAsked) {
  const SampleOptions options;
  for (const Slice& slice : stack.slices) {
    for (const Contour& contour : slice.contours) {
      double length = 0, longest = 0;
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point2 &p = contour.points[i], &q = contour.points[(i + 1) % contour.points.size()];
        longest = std::max(longest, std::hypot(q.x - p.x, q.y - p.y));
        length += std::hypot(q.x - p.x, q.y - p.y);
      }
      // A point that is kept may be one grid step later than asked.
      EXPECT_LE(longest, options.point_spacing + 2 * limits::sample_grid);
      EXPECT_GE(contour.points.size(), 8u);
      if (length > 15) {
        EXPECT_GE(contour.points.size(), 70u);
        EXPECT_LE(static_cast<double>(contour.points.size()), 2 * length / options.point_spacing);
      }
    }
  }
}

// Wheeler's averages within a few per cent: the crown where it is widest, the neck at the cervical line.
TEST_P(SampleTooth, KeepsToWheelersProportions) {
  constexpr double tolerance = 0.15;  // mm
  const Proportions& wheeler = facts.proportions;
  const Extents whole = extents(stack, 0, facts.top_z), crown = extents(stack, facts.cervix_z, facts.top_z);
  const double spacing = slice_apart;
  const Extents neck = extents(stack, facts.cervix_z - spacing, facts.cervix_z + spacing);
  EXPECT_NEAR(crown.x.size(), wheeler.crown_mesiodistal, tolerance);
  EXPECT_NEAR(crown.y.size(), wheeler.crown_buccolingual, tolerance);
  EXPECT_NEAR(neck.x.size(), wheeler.cervix_mesiodistal, 2 * tolerance);
  EXPECT_NEAR(neck.y.size(), wheeler.cervix_buccolingual, 2 * tolerance);
  EXPECT_NEAR(whole.z.high - facts.cervix_z, wheeler.crown_length, tolerance);
  EXPECT_NEAR(facts.cervix_z - whole.z.low, wheeler.root_length, tolerance);
}

/// Lowest slice in which the enamel covers the given side: +x mesial, -x distal, +y buccal.
double enamel_begins(const ContourStack& stack, Point2 side) {
  for (const Slice& slice : stack.slices) {
    for (const Contour* contour : contours(slice, "enamel", true))
      for (const Point2& p : contour->points) {
        const double along = p.x * side.x + p.y * side.y, across = std::abs(p.x * side.y - p.y * side.x);
        if (along > 1 && across < 0.3) return slice.z;
      }
  }
  return -1;
}

TEST_P(SampleTooth, CervicalLineRisesAsWheelerSays) {
  const double tolerance = 0.3 + slice_apart, buccal = enamel_begins(stack, {0, 1});
  EXPECT_NEAR(buccal, facts.cervix_z, tolerance);
  EXPECT_NEAR(enamel_begins(stack, {1, 0}) - buccal, facts.proportions.cervical_curve_mesial, tolerance);
  EXPECT_NEAR(enamel_begins(stack, {-1, 0}) - buccal, facts.proportions.cervical_curve_distal, tolerance);
}

TEST_P(SampleTooth, CanalsLieInsideThePulpAllTheirWay) {
  ASSERT_FALSE(facts.canals.empty());
  for (const CanalFact& canal : facts.canals) {
    EXPECT_LT(canal.low_z, canal.high_z);
    EXPECT_NEAR(canal.axis.front().z, canal.low_z, 1e-9);
    EXPECT_NEAR(canal.axis.back().z, canal.high_z, 1e-9);
    for (const Point3& p : canal.axis) {
      if (p.z < canal.low_z + 0.5) continue;  // the blind end is round
      EXPECT_TRUE(in_region({p.x, p.y}, slice_at(stack, p.z), "pulp")) << canal.name << " at z = " << p.z;
    }
  }
}

TEST_P(SampleTooth, HornsEndInThePulpAndCuspsInTheEnamel) {
  const double spacing = slice_apart;
  for (const NamedPoint& horn : facts.horns) {
    EXPECT_TRUE(in_region({horn.at.x, horn.at.y}, slice_at(stack, horn.at.z - spacing), "pulp")) << horn.name;
    EXPECT_FALSE(in_region({horn.at.x, horn.at.y}, slice_at(stack, horn.at.z + spacing), "pulp")) << horn.name;
  }
  for (const NamedPoint& cusp : facts.cusps) {
    EXPECT_TRUE(in_region({cusp.at.x, cusp.at.y}, slice_at(stack, cusp.at.z - 2 * spacing), "enamel")) << cusp.name;
    if (cusp.at.z + spacing > stack.slices.back().z) continue;
    EXPECT_FALSE(in_region({cusp.at.x, cusp.at.y}, slice_at(stack, cusp.at.z + spacing), "enamel")) << cusp.name;
  }
  for (const NamedPoint& root : facts.roots)
    EXPECT_TRUE(in_region({root.at.x, root.at.y}, slice_at(stack, root.at.z + spacing), "dentine")) << root.name;
}

TEST_P(SampleTooth, StructuresKeepApartIfAsked) {
  for (const Slice& slice : sample_tooth(GetParam(), {.walls = SampleWalls::apart}).slices)
    for (const Contour& contour : slice.contours)
      for (const Point2& p : contour.points)
        for (const char* other : {"enamel", "dentine", "pulp"})
          if (contour.structure != other) {
            ASSERT_FALSE(in_region(p, slice, other)) << contour.structure << " in " << other << " at z = " << slice.z;
          }
}

double area_of(const Slice& slice, const std::string& structure) {
  double sum = 0;
  for (const Contour& contour : slice.contours)
    if (structure.empty() || contour.structure == structure) sum += area(contour.points);
  return sum;
}

TEST_P(SampleTooth, NeighboursShareTheirWallsToTheBit) {
  for (const Slice& slice : stack.slices) {
    std::set<std::pair<double, double>> dentine;
    for (const Contour& contour : slice.contours)
      if (contour.structure == "dentine")
        for (const Point2& p : contour.points) dentine.emplace(p.x, p.y);
    for (const Contour& contour : slice.contours)
      if (contour.structure == "pulp")
        for (const Point2& p : contour.points) ASSERT_TRUE(dentine.contains({p.x, p.y})) << slice.z;
  }
}

TEST_P(SampleTooth, WhatFilledStructuresCoverIsWhollyGivenAway) {
  const ContourStack filled = sample_tooth(GetParam(), {.walls = SampleWalls::filled});
  ASSERT_EQ(filled.slices.size(), stack.slices.size());
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const Slice &own = stack.slices[s], &whole = filled.slices[s];
    ASSERT_NEAR(area_of(own, "pulp"), area_of(whole, "pulp"), 1e-9) << own.z;
    ASSERT_NEAR(area_of(own, "pulp") + area_of(own, "dentine"), area_of(whole, "dentine"), 1e-9) << own.z;
    ASSERT_GE(area_of(own, "enamel"), 0) << own.z;
  }
}

TEST_P(SampleTooth, FilledDentineHoldsThePulp) {
  const ContourStack filled = sample_tooth(GetParam(), {.walls = SampleWalls::apart, .hollow_dentine = false});
  for (const Slice& slice : filled.slices)
    for (const Contour& contour : slice.contours)
      for (const Point2& p : contour.points)
        if (contour.structure == "pulp") {
          ASSERT_TRUE(in_region(p, slice, "dentine")) << slice.z;
        }
  EXPECT_NO_THROW(validate(together(filled, {"dentine", "pulp"})));
}

TEST(SampleToothOptions, OutOfRangeIsAUsageError) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double spacing : {0.0, -0.25, 0.049, 0.36, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(sample_tooth(ToothKind::incisor, {.slice_spacing = spacing}), UsageError) << spacing;
  for (const double spacing : {0.0, 0.04, 1.1, nan})
    EXPECT_THROW(sample_tooth(ToothKind::incisor, {.point_spacing = spacing}), UsageError) << spacing;
}

TEST(SampleToothFacts, NameWhatAnatomyCountsOn) {
  const SampleFacts molar = sample_facts(ToothKind::molar);
  const auto names = [](const auto& things) {
    std::vector<std::string> result;
    for (const auto& thing : things) result.push_back(thing.name);
    return result;
  };
  EXPECT_EQ(molar.fdi, "36");
  EXPECT_EQ(names(molar.roots), (std::vector<std::string>{"mesial", "distal"}));
  EXPECT_EQ(names(molar.canals), (std::vector<std::string>{"mesiobuccal", "mesiolingual", "distal"}));
  EXPECT_EQ(names(molar.cusps),
            (std::vector<std::string>{"mesiobuccal", "distobuccal", "distal", "mesiolingual", "distolingual"}));
  EXPECT_EQ(names(molar.horns), names(molar.cusps));
  EXPECT_EQ(sample_facts(ToothKind::premolar).canals.size(), 2u);
  EXPECT_EQ(sample_facts(ToothKind::incisor).canals.size(), 1u);
  // Published means and their spread, see sample_tooth.h.
  EXPECT_NEAR(molar.cervix_z - molar.furcation_z, 3.07, 0.82);
  EXPECT_NEAR(molar.chamber_low_z - molar.furcation_z, 2.96, 0.78);
  EXPECT_NEAR(molar.chamber_high_z - molar.chamber_low_z, 1.57, 0.68);
}

// Mesial is +x, buccal +y: the names of the molar's cusps say where they must lie.
TEST(SampleToothFacts, AxesAreMesialAndBuccal) {
  for (const NamedPoint& cusp : sample_facts(ToothKind::molar).cusps) {
    EXPECT_EQ(cusp.name.starts_with("mesio"), cusp.at.x > 0) << cusp.name;
    EXPECT_EQ(cusp.name.ends_with("lingual"), cusp.at.y < 0) << cusp.name;
  }
}

TEST(ToothNumber, FollowsTheMouthAround) {
  EXPECT_EQ(universal_number("18"), 1);
  EXPECT_EQ(universal_number("11"), 8);
  EXPECT_EQ(universal_number("21"), 9);
  EXPECT_EQ(universal_number("28"), 16);
  EXPECT_EQ(universal_number("38"), 17);
  EXPECT_EQ(universal_number("31"), 24);
  EXPECT_EQ(universal_number("41"), 25);
  EXPECT_EQ(universal_number("48"), 32);
  for (const char* none : {"", "1", "19", "10", "51", "366"}) EXPECT_EQ(universal_number(none), 0) << none;
  EXPECT_EQ(tooth_in_words(ToothKind::molar), "lower left first molar: FDI 36, Universal 19");
  EXPECT_EQ(tooth_in_words(ToothKind::premolar), "upper right first premolar: FDI 14, Universal 5");
  EXPECT_EQ(tooth_in_words(ToothKind::incisor), "upper right central incisor: FDI 11, Universal 8");
}

}  // namespace
}  // namespace odontoscope::test
