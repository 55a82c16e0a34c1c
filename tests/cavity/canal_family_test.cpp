// Roots with known canals, from slices of 0.1 mm. odontoscope_canal_family tries as many as one likes.

#include "tests/cavity/canal_family.h"

#include <gtest/gtest.h>

#include <cmath>

namespace odontoscope {
namespace {

class CanalsOfTheFamily : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(CanalsOfTheFamily, AreToldRightFromSlicesOfATenthOfAMillimetre) {
  constexpr double spacing = 0.1, length = 0.02, width = 0.03, bend = 0.05;
  ReconstructOptions engine;
  engine.between = Between::blended;
  const test::KnownRoot root = test::random_root(GetParam());
  const test::FamilyVerdict verdict =
      test::judge(root, test::anatomy_of(reconstruct(test::slices_of(root, spacing), engine)));
  EXPECT_TRUE(verdict.counted && verdict.beside) << verdict.told;
  EXPECT_LT(verdict.orifice_off, 0.15) << verdict.told;
  std::size_t covered = 0;
  for (const test::FigureVerdict& one : verdict.figures) {
    const bool is_bend = one.name.starts_with("bend") || one.name == "straight";
    covered += std::abs(one.told - one.known) <= one.off || (one.name == "straight" && one.error() == 0) ? 1 : 0;
    if (one.name == "length") {
      EXPECT_LT(std::abs(one.error()), length) << verdict.told;
    }
    if (one.name == "mean width" || one.name == "narrowest width" || one.name == "apical width") {
      EXPECT_LT(std::abs(one.error()), width) << one.name << ", " << verdict.told;
    }
    if (one.name == "thinnest wall") {
      EXPECT_LT(std::abs(one.error()), length) << verdict.told;
    }
    if (is_bend) {
      EXPECT_LT(std::abs(one.error()), bend) << one.name << ", " << verdict.told;
    }
  }
  // Of the whole family nine in ten are; one root has few figures.
  EXPECT_GE(10 * covered, 9 * verdict.figures.size()) << verdict.told;
}

// A leaning oval canal, an arc of 8 mm, a leaning one of 15 mm, two leaning tapers, an accessory canal, an isthmus of
// type II, a ribbon, type VII with nodes of the medial graph in one place.
INSTANTIATE_TEST_SUITE_P(OfEachKind, CanalsOfTheFamily, ::testing::Values(0, 9, 10, 13, 16, 18, 20, 27),
                         [](const auto& seed) { return std::to_string(seed.param); });

// The ends of a chamber three times as wide as thick protrude like canals.
TEST(CanalFamily, ALobeOfAFlatChamberIsNoCanal) {
  ReconstructOptions engine;
  engine.between = Between::blended;
  test::KnownRoot root = test::random_root(104);
  for (const double oval : {root.oval, 3.2, 3.5}) {
    root.oval = oval;
    const test::FamilyVerdict verdict =
        test::judge(root, test::anatomy_of(reconstruct(test::slices_of(root, 0.2), engine)));
    EXPECT_TRUE(verdict.counted && verdict.beside) << oval << ": " << verdict.told;
    for (const test::FigureVerdict& one : verdict.figures) {
      if (one.name == "length") {
        EXPECT_LT(std::abs(one.error()), 0.03) << oval << ": " << verdict.told;
      }
      if (one.name == "mean width") {
        EXPECT_LT(std::abs(one.error()), 0.03) << oval << ": " << verdict.told;
      }
    }
  }
}

// As a GLB has it.
TEST(CanalFamily, IsToldAlikeInSinglePrecision) {
  ReconstructOptions engine;
  engine.between = Between::blended;
  for (const std::uint64_t seed : {1u, 9u, 13u, 16u, 18u}) {
    Reconstruction model = reconstruct(test::slices_of(test::random_root(seed), 0.4), engine);
    const Anatomy one = test::anatomy_of(model);
    for (Solid& solid : model.solids)
      for (Point3& p : solid.surface.points)
        p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    const Anatomy other = test::anatomy_of(model);
    ASSERT_EQ(one.canals.size(), other.canals.size()) << seed;
    EXPECT_EQ(ahmed_code(one.roots), ahmed_code(other.roots)) << seed;
    constexpr double share = 0.02;
    for (std::size_t c = 0; c < one.canals.size(); ++c) {
      const MeasuredCanal &a = one.canals[c], &b = other.canals[c];
      EXPECT_NEAR(a.length, b.length, share * a.length) << seed;
      EXPECT_NEAR(a.mean_width, b.mean_width, share * a.mean_width) << seed;
      EXPECT_NEAR(a.narrowest.value().width, b.narrowest.value().width, share * a.narrowest->width) << seed;
      EXPECT_NEAR(a.thinnest_wall.value().width, b.thinnest_wall.value().width, share * a.thinnest_wall->width) << seed;
      for (std::size_t third = 0; third < 3; ++third)
        EXPECT_NEAR(one.shapes[c].thirds[third].volume, other.shapes[c].thirds[third].volume,
                    share * one.shapes[c].thirds[third].volume)
            << seed;
    }
  }
}

}  // namespace
}  // namespace odontoscope
