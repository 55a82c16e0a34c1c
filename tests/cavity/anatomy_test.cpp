// Numbers of teeth and shapes whose numbers are known.

#include "recon/cavity/anatomy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/cavity/names.h"
#include "recon/cavity/plane_loops.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "tests/cavity/voids.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

constexpr double percent = 0.01;

/// A block of 20 mm about a void: the solid that it lies in.
SurfaceMesh block_round(const Cavity& cavity) { return shapes::together(shapes::cube(-10, -10, -14, 20), cavity.wall); }

Anatomy anatomy_in_block(const Cavity& cavity) {
  const SurfaceMesh block = block_round(cavity);
  return measure_anatomy({{"block", &block}});
}

TEST(Anatomy, OfAStraightTubeInABlock) {
  const double tube = 10, radius = 0.5;
  const Anatomy made = anatomy_in_block(test::straight_tube(tube, radius));
  ASSERT_EQ(made.structures.size(), 1u);
  EXPECT_NEAR(made.structures[0].area, 6 * 400, 1e-6);
  EXPECT_NEAR(made.structures[0].volume + made.cavity_volume, 8000, 1e-6);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(made.cavity_volume, pi * radius * radius * tube + 4 * pi * std::pow(radius, 3) / 3, 2 * percent * made.cavity_volume);
  EXPECT_NEAR(made.cavity_area, 2 * pi * radius * tube + 4 * pi * radius * radius, 2 * percent * made.cavity_area);
  ASSERT_EQ(made.canals.size(), 1u);
  const MeasuredCanal& canal = made.canals[0];
  EXPECT_NEAR(canal.length, tube + 2 * radius, 0.4);   // without what lies behind its first point, 0.35 radii from the wall
  ASSERT_TRUE(canal.narrowest);
  EXPECT_NEAR(canal.narrowest->width, 2 * radius, percent * 2 * radius);
  EXPECT_EQ(canal.schneider_deg, 0);
  EXPECT_GT(canal.smallest_bend, 100 * radius);
  ASSERT_TRUE(canal.thinnest_wall);
  EXPECT_NEAR(canal.thinnest_wall->width, 14 - tube - radius, percent * 14);   // straight down
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].vertucci, "I");
}

TEST(Anatomy, KnowsTheRadiusOfABend) {
  const double bend = 4, radius = 0.5;
  const Anatomy made = anatomy_in_block(test::bent_tube(bend, 1.5, radius));
  ASSERT_EQ(made.canals.size(), 1u);
  EXPECT_NEAR(made.canals[0].smallest_bend, bend, 0.1 * bend);
  EXPECT_GT(made.canals[0].schneider_deg, 20);
}

TEST(Anatomy, TellsTheWallOfEachOfThreeCanals) {
  const test::ThreeCanals shape;
  const Anatomy made = anatomy_in_block(test::three_canals(shape));
  ASSERT_EQ(made.canals.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& end = shape.ends[i];
    const double wall = std::min({10 - std::abs(end.x), 10 - std::abs(end.y), 14 + end.z}) - shape.radii[i];
    ASSERT_TRUE(made.canals[i].thinnest_wall);
    EXPECT_NEAR(made.canals[i].thinnest_wall->width, wall, percent * wall);
    EXPECT_NEAR(made.canals[i].mean_width, 2 * shape.radii[i], 0.1 * shape.radii[i]);
  }
  // All in one block: one root with three canals from chamber to end.
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].canals.size(), 3u);
  EXPECT_EQ(made.roots[0].vertucci, "VIII");
}

TEST(Anatomy, OfACanalThatForksIsVertucciFive) {
  // A chamber, one canal, two ends.
  const Cavity forked = test::void_of(
      [](const Point3& p) {
        return std::min({test::ball_distance(p, {}, 1.4), test::tube_distance(p, {{0, 0, 0}, {0, 0, -5}, {-2, 0, -9}}, 0.4),
                         test::tube_distance(p, {{0, 0, -5}, {2, 0, -9}}, 0.4)});
      },
      {-3, -2, -10}, {3, 2, 2}, 0.08);
  const Anatomy made = anatomy_in_block(forked);
  ASSERT_EQ(made.canals.size(), 2u);
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].sections, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(made.roots[0].vertucci, "V");
  EXPECT_EQ(made.roots[0].uncounted, 0u);
}

TEST(Anatomy, TellsThatALateForkIsNotCounted) {
  const auto late = [](const Point3& p) {
    return std::min({test::ball_distance(p, {}, 1.4), test::tube_distance(p, {{0, 0, 0}, {0, 0, -9}, {-0.8, 0, -11}}, 0.25), test::tube_distance(p, {{0, 0, -9}, {0.8, 0, -10.8}}, 0.25)});
  };
  const Anatomy made = anatomy_in_block(test::void_of(late, {-2, -2, -12}, {2, 2, 2}, 0.08));
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.canals.size(), 1u);
  EXPECT_EQ(made.roots[0].uncounted, 1u);
}

TEST(Anatomy, OfACanalThatIsAllEndTellsNoNarrowestPlace) {
  const auto ellipse = [](const Point3& p) { return std::max(1.5 * (std::hypot(p.x / 2.2, p.y / 1.5) - 1), std::abs(p.z) - 1.2); };
  const Anatomy made = anatomy_in_block(test::void_of(ellipse, {-3, -2, -2}, {3, 2, 2}, 0.1));
  ASSERT_EQ(made.canals.size(), 1u);
  EXPECT_LT(made.canals[0].length, 2 * made.canals[0].mean_width);
  EXPECT_FALSE(made.canals[0].narrowest);
}

TEST(Anatomy, OfARingTellsItsHandleAndNoCanals) {
  const Anatomy made = anatomy_in_block(test::ring(3, 0.6));
  EXPECT_EQ(made.handles, 1);
  EXPECT_TRUE(made.canals.empty() && made.roots.empty());
}

TEST(Anatomy, WithoutAVoidHasStructuresOnly) {
  const SurfaceMesh cube = shapes::cube();
  const Anatomy made = measure_anatomy({{"cube", &cube}});
  EXPECT_EQ(made.cavity_of, "");
  ASSERT_EQ(made.structures.size(), 1u);
  EXPECT_NEAR(made.structures[0].volume, 1, 1e-12);
  EXPECT_NEAR(made.structures[0].area, 6, 1e-12);
}

TEST(Anatomy, OfTheSampleMolarIsWhatItWasMadeTo) {
  const SampleFacts facts = sample_facts(ToothKind::molar);
  const Reconstruction tooth = reconstruct(sample_tooth(ToothKind::molar));
  std::vector<StructureSurface> model;
  for (const Solid& solid : tooth.solids) model.push_back({solid.structure, &solid.surface});
  const Anatomy made = measure_anatomy(model);
  EXPECT_EQ(made.cavity_of, "dentine");
  EXPECT_EQ(made.horns, facts.horns.size());
  ASSERT_EQ(made.canals.size(), facts.canals.size());
  for (const CanalFact& fact : facts.canals) {
    const auto canal = std::find_if(made.canals.begin(), made.canals.end(), [&](const MeasuredCanal& c) { return c.name == fact.name + " canal"; });
    ASSERT_NE(canal, made.canals.end()) << fact.name;
    double length_of_axis = 0;
    for (std::size_t i = 1; i < fact.axis.size(); ++i) length_of_axis += length(fact.axis[i] - fact.axis[i - 1]);
    EXPECT_NEAR(canal->length, length_of_axis, 0.02 * length_of_axis) << fact.name;
    EXPECT_TRUE(canal->thinnest_wall);
  }
  ASSERT_EQ(made.roots.size(), 2u);   // mesial with two canals, distal with one
  for (const MeasuredRoot& root : made.roots) EXPECT_EQ(root.vertucci, root.canals.size() == 2 ? "IV" : "I");
}

TEST(Names, OfAnotherToothAreNumbers) {
  CentreLines lines = centre_lines(test::three_canals());
  name_as_sample(lines);
  EXPECT_EQ(lines.canals[0].name, "canal 1");
  EXPECT_EQ(lines.canals[2].name, "canal 3");
}

TEST(PlaneLoops, AreTheClosedSectionsOfASurface) {
  const SurfaceMesh two = shapes::together(shapes::cube(0, 0, 0, 2), shapes::cube(5, 0, 0, 1));
  const std::vector<cavity::Loop> low = cavity::loops_at(two, 0.5), high = cavity::loops_at(two, 1.5);
  ASSERT_EQ(low.size(), 2u);
  ASSERT_EQ(high.size(), 1u);
  EXPECT_TRUE(cavity::is_inside(high[0], {1, 1}));
  EXPECT_FALSE(cavity::is_inside(high[0], {5.5, 0.5}));
  EXPECT_TRUE(cavity::loops_at(two, 7).empty());
}

}  // namespace
}  // namespace odontoscope
