// The makers of test data, tested: what they call valid is valid, and a seed is a stack.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "tests/support/plane_check.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"
#include "tests/support/shrink.h"
#include "tests/support/stack_text.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

std::string refusal(const ContourStack& stack) {
  try {
    validate(stack);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Shapes, AreValid) {
  for (const auto& [name, stack] : all_shapes()) {
    EXPECT_EQ(breach(stack), "") << name;
    EXPECT_EQ(refusal(stack), "") << name;
  }
}

TEST(RandomStacks, AreValidAndOfEveryKind) {
  std::set<std::string> kinds;
  std::size_t nested = 0, empty_between = 0, several_structures = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const RandomStack random = random_stack(seed);
    EXPECT_EQ(breach(random.stack), "") << seed;
    EXPECT_EQ(refusal(random.stack), "") << seed;
    kinds.insert(random.kind);
    std::set<std::string> structures;
    for (const Slice& slice : random.stack.slices) {
      empty_between += slice.contours.empty();
      std::vector<std::vector<Point2>> rings;
      for (const Contour& contour : slice.contours) {
        structures.insert(contour.structure);
        if (contour.structure == "tooth") rings.push_back(contour.points);
      }
      for (std::size_t i = 0; i < rings.size(); ++i) nested += depth_of(rings, i) > 1;
    }
    several_structures += structures.size() > 1;
  }
  EXPECT_EQ(kinds.size(), 5u);
  EXPECT_GT(nested, 10u);
  EXPECT_GT(empty_between, 10u);
  EXPECT_GT(several_structures, 10u);
}

TEST(RandomStacks, SameSeedSameStack) {
  EXPECT_EQ(to_text(random_stack(7).stack), to_text(random_stack(7).stack));
  EXPECT_NE(to_text(random_stack(7).stack), to_text(random_stack(8).stack));
}

TEST(Variants, AreValid) {
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    for (const Variant& variant : variants_of(random_stack(seed).stack, seed))
      EXPECT_EQ(breach(variant.stack), "") << seed << " " << variant.name;
}

TEST(StackText, ComesBackBitForBit) {
  const ContourStack stack = random_stack(3).stack;
  const ContourStack back = from_text(to_text(stack));
  ASSERT_EQ(back.slices.size(), stack.slices.size());
  for (std::size_t k = 0; k < stack.slices.size(); ++k) {
    EXPECT_EQ(back.slices[k].z, stack.slices[k].z);
    for (std::size_t c = 0; c < stack.slices[k].contours.size(); ++c)
      EXPECT_EQ(back.slices[k].contours[c].points, stack.slices[k].contours[c].points);
  }
}

TEST(PlaneCheck, SeesEveryBreach) {
  const auto of = [](const Ring& ring, const Ring& second = {}) {
    return breach(second.empty() ? stack_of({{ring}, {}}) : stack_of({{ring, second}, {}}));
  };
  const Ring square = rectangle({0, 0}, {2, 2});
  EXPECT_EQ(of(square), "");
  EXPECT_NE(of({{0, 0}, {1, 0}}), "");
  EXPECT_NE(of({{0, 0}, {1, 0}, {2, 0}}), "") << "no area";
  EXPECT_NE(of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), "") << "crossing itself";
  EXPECT_NE(of({{0, 0}, {2, 0}, {1, 0}, {1, 2}}), "") << "folding back";
  EXPECT_NE(of({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "") << "touching itself";
  EXPECT_NE(of({{0, 0}, {1, 0}, {1, 1}, {1, 0}, {0, 1}}), "") << "a point twice";
  EXPECT_NE(of(square, rectangle({1, 1}, {3, 3})), "") << "crossing another";
  EXPECT_NE(of(square, rectangle({2, 0}, {3, 2})), "") << "touching another";
  EXPECT_EQ(of(square, rectangle({0.5, 0.5}, {1, 1})), "") << "a hole is no breach";
  EXPECT_NE(of({{0, 0}, {1, 0}, {0, std::nan("")}}), "");
}

TEST(Shrink, LeavesOnlyWhatMatters) {
  // "Fails" whenever a hole is there.
  const auto has_hole = [](const ContourStack& stack) {
    for (const Slice& slice : stack.slices) {
      std::vector<Ring> rings;
      for (const Contour& contour : slice.contours) rings.push_back(contour.points);
      for (std::size_t i = 0; i < rings.size(); ++i)
        if (depth_of(rings, i) == 1) return true;
    }
    return false;
  };
  const ContourStack small = shrunk(islands_nested_four_deep(), has_hole);
  ASSERT_EQ(small.slices.size(), 2u);
  std::size_t contours = 0, points = 0;
  for (const Slice& slice : small.slices)
    for (const Contour& contour : slice.contours) {
      ++contours;
      points += contour.points.size();
    }
  EXPECT_EQ(contours, 2u);
  EXPECT_LE(points, 7u);
}

}  // namespace
}  // namespace odontoscope::test
