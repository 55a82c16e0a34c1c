// One of each kind of root with known canals, from slices of 0.1 mm. odontoscope_canal_family tries as many as one likes.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cavity/canal_family.h"

namespace odontoscope {
namespace {

TEST(CanalFamily, IsToldRightFromSlicesOfATenthOfAMillimetre) {
  constexpr double spacing = 0.1;
  ReconstructOptions engine;
  engine.between = Between::blended;
  for (std::uint64_t seed = 0; seed < test::kinds_of_roots; ++seed) {
    const test::KnownRoot root = test::random_root(seed);
    const test::FamilyVerdict verdict = test::judge(root, test::anatomy_of(reconstruct(test::slices_of(root, spacing), engine)));
    EXPECT_TRUE(verdict.counted) << seed << ": " << verdict.told;
  }
}

}  // namespace
}  // namespace odontoscope
