// Shapes of canals, what joins them sideways, and what slices leave uncertain.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/cavity/anatomy.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "tests/cavity/voids.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

constexpr double pi = std::numbers::pi;

Anatomy in_block(const Cavity& cavity) {
  const SurfaceMesh block = shapes::together(shapes::cube(-10, -10, -14, 20), cavity.wall);
  return measure_anatomy({{"block", &block}});
}

TEST(CanalShape, OfARodWithRoundEnds) {
  const double tube = 10, radius = 0.5, whole = tube + 2 * radius;
  const Anatomy made = in_block(test::straight_tube(tube, radius));
  ASSERT_EQ(made.shapes.size(), 1u);
  const CanalShape& shape = made.shapes[0];
  EXPECT_NEAR(shape.thirds[1].volume, pi * radius * radius * whole / 3, 0.02 * shape.thirds[1].volume);
  EXPECT_NEAR(shape.thirds[1].area, 2 * pi * radius * whole / 3, 0.03 * shape.thirds[1].area);
  EXPECT_NEAR(shape.thirds[0].volume + shape.thirds[1].volume + shape.thirds[2].volume, made.cavity_volume,
              0.02 * made.cavity_volume);
  EXPECT_NEAR(shape.thirds[0].area + shape.thirds[1].area + shape.thirds[2].area, made.cavity_area,
              0.001 * made.cavity_area);
  const double volume = pi * radius * radius * tube + 4 * pi * std::pow(radius, 3) / 3,
               area = 2 * pi * radius * tube + 4 * pi * radius * radius, growth = 2 * pi * tube + 8 * pi * radius;
  ASSERT_TRUE(shape.structure_model_index);
  EXPECT_NEAR(*shape.structure_model_index, 6 * growth * volume / (area * area), 0.03 * 3.17);
  ASSERT_EQ(shape.apical.size(), 4u);
  for (const ApicalSection& section : shape.apical) {
    EXPECT_NEAR(section.width, 2 * radius, 0.02) << section.from_apex;
    EXPECT_NEAR(section.area, pi * radius * radius, 0.02) << section.from_apex;
  }
}

TEST(CanalShape, CountsNoFloorAndNoMouthAsItsWall) {
  // From a chamber's ball to where the block ends, 9 mm below the chamber's middle.
  const double radius = 0.4, chamber = 1.4, low = -9;
  const auto open = [=](const Point3& p) {
    return std::min(test::ball_distance(p, {}, chamber), test::tube_distance(p, {{0, 0, 0}, {0, 0, -12}}, radius));
  };
  const auto block = [=](const Point3& p) {
    return std::max({std::hypot(p.x, p.y) - 3, p.z - 3, low - p.z, -open(p)});
  };
  const Cavity solid =
      test::void_of(block, {-3.2, -3.2, low - 0.2}, {3.2, 3.2, 3.2}, 0.08);  // turned inside out: a body
  SurfaceMesh surface = solid.wall;
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  const Anatomy made = measure_anatomy({{"block", &surface}});
  ASSERT_EQ(made.mouths.size(), 1u);
  ASSERT_EQ(made.shapes.size(), 1u);
  const double whole = made.canals[0].length;
  EXPECT_NEAR(whole, -low - std::sqrt(chamber * chamber - radius * radius), 0.2);
  for (const CanalThird& third : made.shapes[0].thirds)
    EXPECT_NEAR(third.area, 2 * pi * radius * whole / 3, 0.05 * third.area);
}

/// Two canals with a wing between them, so thick, from x = -1 to `reach`.
Anatomy two_canals_with_a_wing(double thick, double reach) {
  const auto winged = [=](const Point3& p) {
    const double wing = std::max({std::abs(p.y) - thick / 2, -1 - p.x, p.x - reach, p.z + 5.5, -9 - p.z});
    return std::min({test::ball_distance(p, {}, 1.3),
                     test::tube_distance(p, {{0, 0, 0}, {-1, 0, -3}, {-1, 0, -11}}, 0.35),
                     test::tube_distance(p, {{0, 0, 0}, {1, 0, -3}, {1, 0, -10.5}}, 0.35), wing});
  };
  return in_block(test::void_of(winged, {-2, -2, -12}, {2, 2, 2}, 0.06));
}

TEST(Isthmuses, AreToldByHsuAndKimsTypes) {
  const struct {
    double thick, reach;
    const char* type;
  } shapes_of[] = {{0.13, 1, "II"}, {0.4, 1, "V"}, {0.3, 0.3, "IV"}};
  for (const auto& one : shapes_of) {
    const Anatomy made = two_canals_with_a_wing(one.thick, one.reach);
    ASSERT_EQ(made.roots.size(), 1u) << one.type;
    ASSERT_EQ(made.roots[0].isthmuses.size(), 1u) << one.type;
    const Isthmus& told = made.roots[0].isthmuses[0];
    EXPECT_EQ(told.type, one.type);
    EXPECT_NEAR(told.from_apex, 11.35 - 9, 0.3) << one.type;
    EXPECT_NEAR(told.to_apex, 11.35 - 5.5, 0.3) << one.type;
    if (told.type != "IV") {
      EXPECT_NEAR(told.narrowest, one.thick, 0.03) << one.type;
    }
  }
}

TEST(AccessoryCanals, AreToldWithTheThirdThatTheyLeave) {
  const auto sided = [](const Point3& p) {
    return std::min({test::ball_distance(p, {}, 1.3), test::tube_distance(p, {{0, 0, 0}, {0, 0, -11}}, 0.4),
                     test::tube_distance(p, {{0, 0, -9}, {1.8, 0, -9.3}}, 0.13)});
  };
  const Anatomy made = in_block(test::void_of(sided, {-2, -2, -12}, {2.2, 2, 2}, 0.06));
  EXPECT_EQ(made.canals.size(), 1u);
  ASSERT_EQ(made.accessory_canals.size(), 1u);
  const AccessoryCanal& told = made.accessory_canals[0];
  EXPECT_EQ(told.third, 2u);
  EXPECT_NEAR(told.mean_width, 0.26, 0.04);
  EXPECT_NEAR(told.length, 1.93 - 0.4, 0.25);
  EXPECT_EQ(made.roots.at(0).vertucci, "I");
}

TEST(AhmedsCode, IsMadeOfRootsAndTheCourseOfTheirCanals) {
  MeasuredRoot one, other;
  one.sections = {2, 1};
  other.sections = {1};
  EXPECT_EQ(ahmed_code({one}), "\u00b9TN\u00b2\u207b\u00b9");
  EXPECT_EQ(ahmed_code({one, other}), "\u00b2TN R\u2081\u00b2\u207b\u00b9 R\u2082\u00b9");
  EXPECT_EQ(ahmed_code({}), "");
  EXPECT_EQ(ahmed_code({MeasuredRoot{}}), "");
}

Anatomy of_incisor(double spacing, double without_above) {
  SampleOptions options;
  options.slice_spacing = spacing;
  ContourStack stack = sample_tooth(ToothKind::incisor, options);
  for (Slice& slice : stack.slices) {
    const auto is_hole = [](const Contour& contour) {
      double twice = 0;
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point2 &a = contour.points[i], &b = contour.points[(i + 1) % contour.points.size()];
        twice += a.x * b.y - b.x * a.y;
      }
      return twice < 0;
    };
    std::erase_if(slice.contours, [&](const Contour& contour) {
      return contour.structure != "dentine" || (slice.z > without_above && is_hole(contour));
    });
  }
  std::erase_if(stack.slices, [](const Slice& slice) { return slice.contours.empty(); });
  const Reconstruction tooth = reconstruct(stack);
  return measure_anatomy({{"dentine", &tooth.solids.at(0).surface}}, {}, tooth.counts.slices);
}

TEST(Orifice, OfAnIncisorStaysWhereItIsWhateverTheSlices) {
  for (const double spacing : {0.15, 0.25, 0.35}) {
    const Anatomy made = of_incisor(spacing, 100);
    ASSERT_EQ(made.canals.size(), 1u) << spacing;
    EXPECT_NEAR(made.canals[0].length, 11.55, 0.2) << spacing;
    EXPECT_NEAR(made.slice_spacing, spacing, 1e-6);
    EXPECT_GT(made.uncertainties[0].length, spacing);
    EXPECT_GT(made.uncertainties[0].mean_width, 0);
  }
  // Without horns, too: an end is an end, however blunt.
  const Anatomy blunt = of_incisor(0.25, 18);
  ASSERT_EQ(blunt.canals.size(), 1u);
  EXPECT_NEAR(blunt.canals[0].length, 11.55, 0.3);
}

}  // namespace
}  // namespace odontoscope
