// Numbers of teeth and shapes whose numbers are known.

#include "recon/cavity/anatomy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include "recon/cavity/canal_names.h"
#include "recon/core/polygon.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/formats/given_slices.h"
#include "recon/mesh/plane_section.h"
#include "recon/sample/sample_tooth.h"
#include "tests/cavity/fine_lines.h"
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
  EXPECT_NEAR(made.cavity_volume, pi * radius * radius * tube + 4 * pi * std::pow(radius, 3) / 3,
              2 * percent * made.cavity_volume);
  EXPECT_NEAR(made.cavity_area, 2 * pi * radius * tube + 4 * pi * radius * radius, 2 * percent * made.cavity_area);
  ASSERT_EQ(made.canals.size(), 1u);
  const MeasuredCanal& canal = made.canals[0];
  EXPECT_NEAR(canal.length, tube + 2 * radius, percent * tube);
  ASSERT_TRUE(canal.narrowest);
  EXPECT_NEAR(canal.narrowest->width, 2 * radius, percent * 2 * radius);
  EXPECT_EQ(canal.schneider_deg, 0);
  EXPECT_TRUE(std::isinf(canal.smallest_bend));
  ASSERT_TRUE(canal.thinnest_wall);
  EXPECT_NEAR(canal.thinnest_wall->width, 14 - tube - radius, percent * 14);  // straight down
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].vertucci, "I");
}

/// A block of 10 mm round and 12 mm tall with one canal from z = 1 to 11, as contours: sections of a round tube are
/// ellipses.
ContourStack canal_in_slices(double spacing, double radius, const std::function<Point2(double)>& centre,
                             const std::function<double(double)>& stretch) {
  constexpr int corners = 60;
  ContourStack stack;
  const auto steps = static_cast<int>(std::lround(12 / spacing));
  for (int k = 0; k <= steps; ++k) {
    const double z = k * spacing;
    Slice slice{z, {}};
    Contour outer, hole;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      outer.points.push_back({1.5 + 5 * std::cos(angle), 5 * std::sin(angle)});
      hole.points.push_back(
          {centre(z).x + stretch(z) * radius * std::cos(angle), centre(z).y - radius * std::sin(angle)});
    }
    slice.contours.push_back(outer);
    if (z > 1 && z < 11) slice.contours.push_back(hole);
    stack.slices.push_back(slice);
  }
  return stack;
}

Anatomy anatomy_of(const ContourStack& stack) {
  const Reconstruction made = reconstruct(stack);
  std::vector<StructureSurface> model;
  for (const Solid& solid : made.solids) model.push_back({solid.structure, &solid.surface});
  return measure_anatomy(model);
}

class Arcs : public ::testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P(Arcs, HaveTheRadiusWidthAndLengthThatTheyWereMadeWith) {
  const auto& [bend, spacing, radius] = GetParam();
  const auto rest = [bend = bend](double z) { return std::sqrt(bend * bend - (z - 6) * (z - 6)); };
  const Anatomy made = anatomy_of(canal_in_slices(
      spacing, radius,
      [&, bend = bend](double z) {
        return Point2{bend - rest(z), 0};
      },
      [&, bend = bend](double z) { return bend / rest(z); }));
  ASSERT_EQ(made.canals.size(), 1u);
  const MeasuredCanal& canal = made.canals[0];
  EXPECT_NEAR(canal.smallest_bend, bend, 0.02 * bend);
  EXPECT_NEAR(canal.mean_width, 2 * radius, 0.02 * 2 * radius);
  ASSERT_TRUE(canal.narrowest);
  EXPECT_LE(canal.narrowest->width, canal.mean_width);
  // It ends somewhere between the last slice that has it and the next.
  const auto from_to = [bend = bend](double half) { return 2 * bend * std::asin(half / bend); };
  EXPECT_GT(canal.length, (1 - percent) * from_to(5 - spacing));
  EXPECT_LT(canal.length, (1 + percent) * from_to(5));
}

INSTANTIATE_TEST_SUITE_P(Canals, Arcs,
                         ::testing::Values(std::tuple{8.0, 0.25, 0.5}, std::tuple{15.0, 0.1, 0.35},
                                           std::tuple{30.0, 0.25, 0.35}));

TEST(Anatomy, OfStraightCanalsHasNoBend) {
  const auto upright = [](double) { return Point2{0, 0}; };
  const auto tilted = [](double z) { return Point2{0.3 * (z - 6), 0.1 * z}; };
  const auto round = [](double) { return 1.0; };
  EXPECT_TRUE(std::isinf(anatomy_of(canal_in_slices(0.25, 0.5, upright, round)).canals.at(0).smallest_bend));
  EXPECT_TRUE(std::isinf(anatomy_of(canal_in_slices(0.25, 0.5, tilted, round)).canals.at(0).smallest_bend));
}

TEST(Anatomy, OfATaperHasNoBendAndTheWidthOfItsMiddle) {
  const auto made = anatomy_in_block(test::void_of(
      [](const Point3& p) { return std::max(std::hypot(p.x, p.y) - (0.5 + 0.03 * p.z), std::abs(p.z + 5) - 5); },
      {-0.7, -0.7, -10.2}, {0.7, 0.7, 0.2}, 0.06));
  ASSERT_EQ(made.canals.size(), 1u);
  EXPECT_TRUE(std::isinf(made.canals[0].smallest_bend)) << made.canals[0].smallest_bend;
  EXPECT_NEAR(made.canals[0].mean_width, 0.7, 0.03 * 0.7);
  EXPECT_LT(made.canals[0].narrowest->width, made.canals[0].mean_width);
}

TEST(Anatomy, KnowsTheRadiusOfABend) {
  const double bend = 4, radius = 0.5;
  const Anatomy made = anatomy_in_block(test::bent_tube(bend, 1.5, radius));
  ASSERT_EQ(made.canals.size(), 1u);
  EXPECT_NEAR(made.canals[0].smallest_bend, bend, 2 * percent * bend);
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
        return std::min({test::ball_distance(p, {}, 1.4),
                         test::tube_distance(p, {{0, 0, 0}, {0, 0, -5}, {-2, 0, -9}}, 0.4),
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

/// A canal of 11 mm that parts at a depth of 9, `far` aside on each side, down to `low`.
Anatomy parts_late(double far, double low, double second = 0.25) {
  const auto late = [=](const Point3& p) {
    return std::min({test::ball_distance(p, {}, 1.4),
                     test::tube_distance(p, {{0, 0, 0}, {0, 0, -9}, {-far, 0, low}}, 0.25),
                     test::tube_distance(p, {{0, 0, -9}, {far, 0, low + 0.2}}, second)});
  };
  return anatomy_in_block(test::void_of(late, {-2, -2, -12}, {2, 2, 2}, 0.08));
}

TEST(Anatomy, OfACanalThatForksLateIsVertucciFive) {
  const Anatomy made = parts_late(0.8, -11);
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.canals.size(), 2u);
  EXPECT_EQ(made.roots[0].vertucci, "V");
  EXPECT_EQ(made.roots[0].uncounted, 0u);
  ASSERT_EQ(made.parts.size(), 3u);
}

TEST(Anatomy, TellsThatAForkTooShortOrThinIsNotCounted) {
  for (const Anatomy& made : {parts_late(0.6, -10), parts_late(0.8, -11, 0.1)}) {
    ASSERT_EQ(made.roots.size(), 1u);
    EXPECT_EQ(made.canals.size(), 1u);
    EXPECT_EQ(made.roots[0].vertucci, "I");
  }
}

TEST(Anatomy, OfAFinWithTwoTipsIsOneCanal) {
  // A flat wing beside the canal, a third as thick, with a notch in its lower edge.
  const auto finned = [](const Point3& p) {
    const double wing =
        std::max({std::abs(p.y) - 0.15, -p.x, p.x - 1.6, p.z + 3, -8.5 - p.z, 0.35 - std::hypot(p.x - 0.8, p.z + 8.5)});
    return std::min({test::ball_distance(p, {}, 1.4), test::tube_distance(p, {{0, 0, 0}, {0, 0, -11}}, 0.45), wing});
  };
  const Anatomy made = anatomy_in_block(test::void_of(finned, {-2, -2, -12}, {2.2, 2, 2}, 0.08));
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.canals.size(), 1u);
  EXPECT_EQ(made.roots[0].vertucci, "I");
}

TEST(Anatomy, OfACanalThatComesOutTellsAnOpeningAndNoWall) {
  // A body of pulp whose canal ends in the plane where the block ends, too.
  const Cavity tube = test::void_of(
      [](const Point3& p) {
        return std::max(test::tube_distance(p, {{0, 0, 0}, {0, 0, -12}}, 0.5), -10 - p.z);
      },
      {-1, -1, -10.6}, {1, 1, 1}, 0.08);
  SurfaceMesh pulp = tube.wall;
  for (Triangle& t : pulp.triangles) std::swap(t[1], t[2]);
  double low = 0;
  for (const Point3& p : pulp.points) low = std::min(low, p.z);
  const SurfaceMesh block = shapes::cube(-10, -10, low, 20);
  const Anatomy made = measure_anatomy({{"Dentine", &block}, {"pulp", &pulp}});
  ASSERT_EQ(made.canals.size(), 1u);
  ASSERT_EQ(made.openings.size(), 1u);
  EXPECT_NEAR(made.openings[0].at.z, low, 1e-9);
  ASSERT_TRUE(made.canals[0].thinnest_wall);
  EXPECT_GT(made.canals[0].thinnest_wall->width, 0.5);
}

TEST(Anatomy, TellsLoosePieces) {
  const Cavity tube = test::straight_tube(8, 0.5);
  SurfaceMesh block = block_round(tube);
  SurfaceMesh bubble = shapes::cube(5, 5, -10, 0.5);
  for (Triangle& t : bubble.triangles) std::swap(t[1], t[2]);
  block = shapes::together(block, bubble);
  const Anatomy made = measure_anatomy({{"block", &block}});
  EXPECT_EQ(made.loose.count, 1u);
  EXPECT_NEAR(made.loose.volume, 0.125, 1e-9);
  EXPECT_EQ(anatomy_in_block(tube).loose.count, 0u);
}

TEST(Anatomy, OfACanalThatIsAllEndTellsNoNarrowestPlace) {
  const auto ellipse = [](const Point3& p) {
    return std::max(1.5 * (std::hypot(p.x / 2.2, p.y / 1.5) - 1), std::abs(p.z) - 1.2);
  };
  const Anatomy made = anatomy_in_block(test::void_of(ellipse, {-3, -2, -2}, {3, 2, 2}, 0.1));
  ASSERT_EQ(made.canals.size(), 1u);
  EXPECT_LT(made.canals[0].length, 2 * made.canals[0].mean_width);
  EXPECT_FALSE(made.canals[0].narrowest);
}

/// Turned about the x axis.
SurfaceMesh leaning(SurfaceMesh surface, double angle) {
  for (Point3& p : surface.points)
    p = {p.x, std::cos(angle) * p.y - std::sin(angle) * p.z, std::sin(angle) * p.y + std::cos(angle) * p.z};
  return surface;
}

TEST(Anatomy, OfALeaningToothIsThatOfTheUprightOne) {
  const test::RootShape shape = test::root_of_type("III");
  const Cavity cavity = test::void_of_root(shape);
  SurfaceMesh block = shapes::cube(-5, -5, -5, 10);
  for (Point3& p : block.points) p.z = p.z > 0 ? 4 : -16;
  block = shapes::together(block, cavity.wall);
  const Anatomy upright = measure_anatomy({{"block", &block}});
  EXPECT_FALSE(upright.axis.own);
  for (const double angle : {0.6, 1.2}) {
    const SurfaceMesh leant = leaning(block, angle);
    const Anatomy made = measure_anatomy({{"block", &leant}});
    EXPECT_TRUE(made.axis.own);
    EXPECT_NEAR(made.axis.tilt_deg, angle * 180 / std::numbers::pi, 0.1);
    ASSERT_EQ(made.roots.size(), 1u);
    EXPECT_EQ(made.roots[0].vertucci, "III");
    ASSERT_EQ(made.canals.size(), upright.canals.size());
    for (std::size_t c = 0; c < made.canals.size(); ++c)
      EXPECT_NEAR(made.canals[c].length, upright.canals[c].length, 2 * percent * made.canals[c].length);
  }
}

TEST(Anatomy, OfARingTellsItsHandleAndNoCanals) {
  const Anatomy made = anatomy_in_block(test::ring(3, 0.6));
  EXPECT_EQ(made.handles, 1u);
  EXPECT_EQ(made.narrow_handles, 0u);
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
    const auto canal = std::find_if(made.canals.begin(), made.canals.end(),
                                    [&](const MeasuredCanal& c) { return c.name == fact.name + " canal"; });
    ASSERT_NE(canal, made.canals.end()) << fact.name;
    const double known = test::ending_at(test::fine_lines(ToothKind::molar).canals, fact.axis.front()).length_to_wall();
    EXPECT_NEAR(canal->length, known, 0.02 * known) << fact.name;
    EXPECT_TRUE(canal->thinnest_wall);
  }
  ASSERT_EQ(made.roots.size(), 2u);  // mesial with two canals, distal with one
  for (const MeasuredRoot& root : made.roots) EXPECT_EQ(root.vertucci, root.canals.size() == 2 ? "IV" : "I");
}

TEST(Names, OfAnotherToothAreNumbers) {
  CentreLines lines = centre_lines(test::three_canals());
  name_as_sample(lines);
  EXPECT_EQ(lines.canals[0].name, "canal 1");
  EXPECT_EQ(lines.canals[2].name, "canal 3");
}

/// Circles of so many corners, closed above and below by slices without.
ContourStack closed_canal(int corners, double radius, double spacing) {
  ContourStack stack;
  for (int k = 0; k <= 20; ++k) {
    Slice slice{k * spacing, {}};
    for (const double r : {4.0, radius}) {
      if (r == radius && (k < 2 || k > 18)) continue;
      Contour contour;
      for (int i = 0; i < corners; ++i)
        contour.points.push_back(
            {r * std::cos(2 * std::numbers::pi * i / corners), r * std::sin(2 * std::numbers::pi * i / corners)});
      slice.contours.push_back(std::move(contour));
    }
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

TEST(Anatomy, OfAClosedCanalHasTheWidthOfItsPolygons) {
  constexpr int corners = 40;
  for (const double radius : {0.5, 0.6}) {
    const Reconstruction model = reconstruct(closed_canal(corners, radius, 0.5));
    const Anatomy made = measure_anatomy({{"tooth", &model.solids.at(0).surface}}, {}, model.counts.slices);
    ASSERT_EQ(made.canals.size(), 1u);
    const double width = 2 * radius * std::cos(std::numbers::pi / corners);
    EXPECT_NEAR(made.canals[0].mean_width, width, 0.7 * percent * width);
    ASSERT_TRUE(made.canals[0].narrowest);
    EXPECT_LE(made.canals[0].narrowest->width, made.canals[0].mean_width);
    EXPECT_NEAR(made.slice_spacing, 0.5, 1e-9);
    EXPECT_NEAR(made.canals[0].mean_width, 2 * radius, made.uncertainties[0].mean_width);  // the circle's, too
  }
}

/// A tube of 10 mm that is pinched over a part of its length.
Anatomy of_pinched(double part) {
  const auto pinched = [=](const Point3& p) {
    return test::tube_distance(p, {{0, 0, 0}, {0, 0, -10}}, 0.5) +
           0.15 * std::max(0.0, 1 - std::abs(p.z + 5) / (part / 2));
  };
  const Cavity tube = test::void_of(pinched, {-1, -1, -11}, {1, 1, 1}, 0.06);
  const SurfaceMesh block = block_round(tube);
  constexpr std::size_t slices = 41;  // of the block's 20 mm: 0.5 mm apart
  return measure_anatomy({{"block", &block}}, {}, slices);
}

TEST(Anatomy, TellsNoNarrowPlaceThatIsShorterThanSlicesAreApart) {
  const Anatomy between_slices = of_pinched(0.4), seen = of_pinched(2);
  ASSERT_TRUE(between_slices.canals.at(0).narrowest);
  EXPECT_NEAR(between_slices.canals[0].narrowest->width, 1, 0.03);
  EXPECT_LE(between_slices.canals[0].narrowest->width, between_slices.canals[0].mean_width);
  ASSERT_TRUE(seen.canals.at(0).narrowest);
  EXPECT_NEAR(seen.canals[0].narrowest->width, 0.7, 0.12);  // half a spacing away it is that much wider
  EXPECT_NEAR(seen.canals[0].narrowest->at.z, -5, 0.3);
}

TEST(Anatomy, KnowsTheGivenSlicesWhateverLiesBetween) {
  ReconstructOptions blended;
  blended.between = Between::blended;
  SampleOptions options;
  options.slice_spacing = 0.35;
  const ContourStack stack = sample_tooth(ToothKind::premolar, options);
  const Reconstruction model = reconstruct(stack, blended);
  std::vector<StructureSurface> parts;
  for (const Solid& solid : model.solids) parts.push_back({solid.structure, &solid.surface});
  const Anatomy made = measure_anatomy(parts, {}, stack.slices.size());
  EXPECT_NEAR(made.slice_spacing, 0.35, 1e-6);
  EXPECT_LT(measure_anatomy(parts).slice_spacing, 0.3);  // the wall's own heights are those of interpolated slices, too
}

TEST(SlicesGiven, AreReadFromTheCertificateOfAGltfFile) {
  const auto given = [](const std::string& extras) {
    return slices_given(R"({"asset":{"version":"2.0","extras":)" + extras + "}}", "a.gltf");
  };
  EXPECT_EQ(given(R"({"slices_checked":57})"), 57u);
  for (const char* other : {R"({})", R"([57])", R"({"slices_checked":1})", R"({"slices_checked":-3})",
                            R"({"slices_checked":2.5})", R"({"slices_checked":1e9})", R"({"slices_checked":"57"})"})
    EXPECT_FALSE(given(other)) << other;
}

TEST(PlaneLoops, AreTheClosedSectionsOfASurface) {
  const SurfaceMesh two = shapes::together(shapes::cube(0, 0, 0, 2), shapes::cube(5, 0, 0, 1));
  const std::vector<Polygon> low = section_loops(two, 0.5), high = section_loops(two, 1.5);
  ASSERT_EQ(low.size(), 2u);
  ASSERT_EQ(high.size(), 1u);
  EXPECT_TRUE(encloses(high[0], {1, 1}));
  EXPECT_FALSE(encloses(high[0], {5.5, 0.5}));
  EXPECT_TRUE(section_loops(two, 7).empty());
}

}  // namespace
}  // namespace odontoscope
