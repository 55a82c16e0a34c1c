// Virtual slices of random stacks: whatever the slices and links are, the outlines are fit to be an input.

#include <gtest/gtest.h>

#include <array>

#include "recon/between/blend.h"
#include "recon/input/validate.h"
#include "tests/between/slabs.h"
#include "tests/support/random_numbers.h"
#include "tests/support/random_stacks.h"

namespace odontoscope::test {
namespace {

constexpr std::array shares{0.25, 0.5, 0.75};

ContourStack stack_of_outlines(const std::vector<Outline>& outlines) {
  ContourStack stack;
  for (const Outline& outline : outlines) {
    Slice& slice = stack.slices.emplace_back(Slice{static_cast<double>(stack.slices.size()), {}});
    for (const Ring& ring : outline) slice.contours.push_back({"tooth", ring});
  }
  return stack;
}

/// Valid, and already turned as `ordered` turns them.
void expect_fit(const std::vector<Outline>& outlines, const std::string& where) {
  ContourStack stack = stack_of_outlines(outlines);
  bool any = false;
  for (const Outline& outline : outlines) any = any || !outline.empty();
  if (!any) return;
  ASSERT_NO_THROW(validate(stack)) << where;
  const ContourStack turned = ordered(stack).stack;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    for (std::size_t c = 0; c < stack.slices[s].contours.size(); ++c)
      ASSERT_EQ(turned.slices[s].contours[c].points, stack.slices[s].contours[c].points) << where;
  }
}

enum class Linking { overlap, none, random };

Links links_for(Linking linking, const Outline& lower, const Outline& upper, RandomNumbers& random) {
  Links links;
  if (linking == Linking::overlap) return overlap_links(lower, upper);
  if (linking == Linking::none) return links;
  for (std::size_t a = 0; a < lower.size(); ++a) {
    for (std::size_t b = 0; b < upper.size(); ++b) {
      if (!random.chance(0.3)) continue;
      const bool outer_a = area({lower[a]}) > 0, outer_b = area({upper[b]}) > 0;
      if (outer_a && outer_b) links.material.push_back({a, b});
      if (!outer_a && !outer_b) links.voids.push_back({a, b});
      if (!outer_a && random.chance(0.2)) links.voids.push_back({a, between::outside});
      if (!outer_b && random.chance(0.2)) links.voids.push_back({between::outside, b});
    }
  }
  return links;
}

TEST(RandomBlend, IsValidAndTheSameEachTimeWhateverTheLinks) {
  std::size_t slabs = 0, contours = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const RandomStack made = random_stack(seed);
    const ContourStack stack = ordered(made.stack).stack;
    RandomNumbers random(seed);
    for (const std::string& name : structures_of(stack)) {
      for (std::size_t k = 0; k + 1 < stack.slices.size(); ++k) {
        std::array<Outline, 4> outlines;
        for (std::size_t n = 0; n < 4; ++n) {
          if (k + n >= 1 && k + n - 1 < stack.slices.size()) outlines[n] = outline_of(stack.slices[k + n - 1], name);
        }
        const Linking linking = static_cast<Linking>(seed % 3);
        const Links links = links_for(linking, outlines[1], outlines[2], random);
        between::Surroundings s;
        s.lower = &outlines[1], s.upper = &outlines[2];
        s.z_lower = stack.slices[k].z, s.z_upper = stack.slices[k + 1].z;
        if (k > 0) s.before = &outlines[0], s.z_before = stack.slices[k - 1].z;
        if (k + 2 < stack.slices.size()) s.after = &outlines[3], s.z_after = stack.slices[k + 2].z;
        s.material = links.material, s.voids = links.voids;
        const std::vector<Outline> blended = between::blend(s, shares);
        const std::string where = made.kind + ", seed " + std::to_string(seed) + ", slab " + std::to_string(k);
        expect_fit(blended, where);
        if (k == 0) {
          ASSERT_EQ(between::blend(s, shares), blended) << where;
        }
        ++slabs;
        for (const Outline& outline : blended) contours += outline.size();
      }
    }
  }
  EXPECT_GT(slabs, 100u);
  EXPECT_GT(contours, 3 * slabs);
}

}  // namespace
}  // namespace odontoscope::test
