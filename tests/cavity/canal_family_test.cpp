// Roots with known canals, from slices of 0.1 mm. odontoscope_canal_family tries as many as one likes.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cavity/canal_family.h"

namespace odontoscope {
namespace {

class CanalFamily : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(CanalFamily, IsToldRightFromSlicesOfATenthOfAMillimetre) {
  constexpr double spacing = 0.1, length = 0.02, width = 0.03, bend = 0.05;
  ReconstructOptions engine;
  engine.between = Between::blended;
  const test::KnownRoot root = test::random_root(GetParam());
  const test::FamilyVerdict verdict = test::judge(root, test::anatomy_of(reconstruct(test::slices_of(root, spacing), engine)));
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
  EXPECT_GE(10 * covered, 7 * verdict.figures.size()) << verdict.told;
}

// A leaning oval canal, an arc of 8 mm, a leaning one of 15 mm, two leaning tapers, an accessory canal, an isthmus of type II, a ribbon, type VII with nodes of the medial graph in one place.
INSTANTIATE_TEST_SUITE_P(OfEachKind, CanalFamily, ::testing::Values(0, 9, 10, 13, 16, 18, 20, 27), [](const auto& seed) { return std::to_string(seed.param); });

}  // namespace
}  // namespace odontoscope
