// A root of each of Vertucci's types, at random, from slices of 0.1 mm. odontoscope_canal_family tries as many as one likes.

#include <gtest/gtest.h>

#include "tests/cavity/canal_family.h"

namespace odontoscope {
namespace {

TEST(CanalFamily, IsToldRightFromSlicesOfATenthOfAMillimetre) {
  constexpr double spacing = 0.1;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const test::FamilyVerdict verdict = test::judge(test::random_root(seed), spacing);
    EXPECT_TRUE(verdict.counted) << seed << ": " << verdict.told;
    EXPECT_LT(verdict.length_error, 0.02) << seed << ": " << verdict.told;
    EXPECT_LT(verdict.width_error, 0.03) << seed << ": " << verdict.told;
  }
}

}  // namespace
}  // namespace odontoscope
