// That the sample teeth are shaped like teeth: pulp, canals and apices, on slices so close that they show the field.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sample/made_once.h"
#include "tests/sample/stack_queries.h"

namespace odontoscope::test {
namespace {

constexpr double fine = 0.1;  // mm

/// Of the pulp's section that holds a place; nothing if none does.
const Contour* pulp_at(const ContourStack& stack, Point3 at) {
  for (const Contour* contour : contours(slice_at(stack, at.z), "pulp", true))
    if (inside({at.x, at.y}, contour->points)) return contour;
  return nullptr;
}

/// Diameter of the disc of its area.
double diameter(const Contour& contour) { return std::sqrt(4 * area(contour.points) / std::numbers::pi); }

struct Box {
  Extent x, y;
};
Box box(const Contour& contour) {
  Box made;
  for (const Point2& p : contour.points) {
    made.x.add(p.x);
    made.y.add(p.y);
  }
  return made;
}

Point3 axis_at(const CanalFact& canal, double z) {
  const auto above = std::find_if(canal.axis.begin(), canal.axis.end(), [z](const Point3& p) { return p.z >= z; });
  if (above == canal.axis.begin() || above == canal.axis.end()) return canal.axis.front();
  const Point3 &low = *(above - 1), &high = *above;
  const double share = (z - low.z) / (high.z - low.z);
  return {low.x + share * (high.x - low.x), low.y + share * (high.y - low.y), z};
}

double apex_of(const SampleFacts& facts, const CanalFact& canal) {
  for (const NamedPoint& root : facts.roots)
    if (root.name == canal.root) return root.at.z;
  return -1;
}

class SampleShapes : public testing::TestWithParam<ToothKind> {
 protected:
  SampleFacts facts = sample_facts(GetParam());
  const ContourStack& stack = made_once(GetParam(), fine);
};
INSTANTIATE_TEST_SUITE_P(Kinds, SampleShapes,
                         testing::Values(ToothKind::molar, ToothKind::premolar, ToothKind::incisor),
                         [](const auto& kind) { return name(kind.param); });

// Cones, not spikes: half way up as wide as 0.4 of their height and more, and no higher than a young tooth's.
TEST_P(SampleShapes, HornsAreBroadAndLow) {
  for (const NamedPoint& horn : facts.horns) {
    const double height = horn.at.z - facts.chamber_high_z;
    EXPECT_GT(height, 0.3) << horn.name;
    EXPECT_LT(height, 1.7) << horn.name;
    double widest = 0;
    for (const Contour* contour : contours(slice_at(stack, facts.chamber_high_z + height / 2), "pulp", true)) {
      const Point2 middle = centroid(contour->points);
      if (std::hypot(middle.x - horn.at.x, middle.y - horn.at.y) < 0.8) widest = diameter(*contour);
    }
    EXPECT_GT(widest, 0.4 * height) << horn.name;
  }
}

// Narrowest above the foramen, 0.2 to 0.3 mm wide there, and twice as wide and more where they leave the root.
TEST_P(SampleShapes, OpenCanalsNarrowToAConstrictionAndLeaveThroughAForamen) {
  const ContourStack open = sample_tooth(GetParam(), {.slice_spacing = fine, .open_apex = true});
  for (const CanalFact& canal : facts.canals) {
    const double apex = apex_of(facts, canal);
    double narrowest = 9, narrowest_z = 0;
    Point3 place = axis_at(canal, apex + 3);
    double foramen = 0;
    for (std::size_t s = open.slices.size(); s-- > 0;) {
      const Slice& slice = open.slices[s];
      if (slice.z > apex + 3 || slice.z < apex) continue;
      const Contour* section = pulp_at(open, {place.x, place.y, slice.z});
      ASSERT_NE(section, nullptr) << canal.name << " at z = " << slice.z;
      const Point2 middle = centroid(section->points);
      place = {middle.x, middle.y, slice.z};
      foramen = diameter(*section);
      EXPECT_GT(count(slice, "dentine", false), 0u) << "a rim all round at z = " << slice.z;
      if (foramen >= narrowest) continue;
      narrowest = foramen;
      narrowest_z = slice.z;
    }
    EXPECT_GT(narrowest, 0.2) << canal.name;
    EXPECT_LT(narrowest, 0.31) << canal.name;
    EXPECT_NEAR(narrowest_z - apex, 0.75, 0.2) << canal.name;
    EXPECT_GT(foramen, 1.6 * narrowest) << canal.name;
  }
}

TEST_P(SampleShapes, ClosedCanalsEndHalfAMillimetreAboveTheApex) {
  for (const CanalFact& canal : facts.canals) {
    const double apex = apex_of(facts, canal);
    EXPECT_NEAR(canal.low_z - apex, 0.5, 1e-9);
    const Contour* section = pulp_at(stack, axis_at(canal, apex + 0.9));
    ASSERT_NE(section, nullptr) << canal.name;
    EXPECT_LT(diameter(*section), 0.32) << canal.name;
    EXPECT_EQ(pulp_at(stack, axis_at(canal, apex + 0.45)), nullptr) << canal.name;
  }
}

TEST_P(SampleShapes, CanalsAreRoundNearTheApex) {
  for (const CanalFact& canal : facts.canals) {
    const Contour* section = pulp_at(stack, axis_at(canal, apex_of(facts, canal) + 1));
    ASSERT_NE(section, nullptr) << canal.name;
    const Box sides = box(*section);
    EXPECT_NEAR(sides.x.size() / sides.y.size(), 1, 0.15) << canal.name;
  }
}

TEST(SampleMolar, CanalsAreOvalBelowTheirOrifices) {
  const SampleFacts facts = sample_facts(ToothKind::molar);
  const ContourStack& stack = made_once(ToothKind::molar, fine);
  for (const CanalFact& canal : facts.canals) {
    const Contour* section = pulp_at(stack, axis_at(canal, 11));
    ASSERT_NE(section, nullptr) << canal.name;
    const Box sides = box(*section);
    EXPECT_GT(sides.y.size() / sides.x.size(), canal.name == "distal" ? 2 : 1.15) << canal.name;
  }
}

TEST(SamplePremolar, HasAnOvalChamberBroadBuccolingually) {
  const SampleFacts facts = sample_facts(ToothKind::premolar);
  const ContourStack& stack = made_once(ToothKind::premolar, fine);
  const Contour* section = pulp_at(stack, {0, 0, facts.cervix_z});
  ASSERT_NE(section, nullptr);
  const Box sides = box(*section);
  EXPECT_GT(sides.y.size(), 2.5 * sides.x.size());
  // An ellipse fills pi / 4 of its box, a box all of it.
  EXPECT_LT(area(section->points), 0.85 * sides.x.size() * sides.y.size());
}

TEST(SampleIncisor, HasAChamberThatFollowsTheCrown) {
  const SampleFacts facts = sample_facts(ToothKind::incisor);
  const ContourStack& stack = made_once(ToothKind::incisor, fine);
  const auto sides_at = [&](double z, double y) {
    const Contour* section = pulp_at(stack, {0, y, z});
    return section ? box(*section) : Box{};
  };
  const Box neck = sides_at(facts.cervix_z, 0), roof = sides_at(18, 0.6);
  EXPECT_GT(roof.x.size(), 2.8 * roof.y.size()) << "wide and thin";
  EXPECT_GT(roof.x.size(), 1.2 * neck.x.size()) << "wider towards the edge";
  EXPECT_LT(roof.y.size(), 0.75 * neck.y.size()) << "thinner towards the edge";
  for (const NamedPoint& horn : facts.horns) EXPECT_LT(horn.at.z - facts.chamber_high_z, 0.6) << "no fork";
}

// The incisor's dentine ends in an edge that is round from corner to corner and thin from lip to tongue.
TEST(SampleIncisor, HasDentineThatTapersToARoundEdge) {
  const ContourStack& stack = made_once(ToothKind::incisor, fine);
  double top = 0;
  for (const Slice& slice : stack.slices)
    if (count(slice, "dentine") > 0) top = slice.z;
  EXPECT_GT(top, 21);
  EXPECT_LT(top, 22.2);
  const auto sides_at = [&](double z) {
    Box made;
    for (const Contour* contour : contours(slice_at(stack, z), "dentine", true))
      for (const Point2& p : contour->points) {
        made.x.add(p.x);
        made.y.add(p.y);
      }
    return made;
  };
  EXPECT_LT(sides_at(top - 0.5).x.size(), 0.93 * sides_at(top - 1.5).x.size());
  EXPECT_LT(sides_at(top - 0.5).y.size(), 0.75 * sides_at(top - 1.5).y.size());
}

}  // namespace
}  // namespace odontoscope::test
