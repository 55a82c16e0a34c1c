// Virtual slices whose layers, glued where they overlap, have the topology that the links imply. What the library
// counts is counted again from the contours alone, on a finer raster.

#include "recon/between/joined.h"

#include <gtest/gtest.h>

#include <array>

#include "recon/between/simple_point.h"
#include "recon/core/union_find.h"
#include "recon/input/validate.h"
#include "tests/between/slabs.h"
#include "tests/support/random_numbers.h"
#include "tests/support/random_stacks.h"

namespace odontoscope::test {
namespace {

using between::blend;
using between::blend_joined;
using between::JoinedBlend;
using between::LayerTopology;
using between::Surroundings;

constexpr std::array quarters{0.25, 0.5, 0.75};
constexpr int fine = 700;

Surroundings between_slices(const Outline& lower, const Outline& upper, const Links& links) {
  Surroundings s;
  s.lower = &lower, s.upper = &upper;
  s.z_lower = 0, s.z_upper = 1;
  s.material = links.material, s.voids = links.voids;
  return s;
}

std::vector<Outline> layers_of(const Outline& lower, const std::vector<Outline>& between, const Outline& upper) {
  std::vector<Outline> layers{lower};
  layers.insert(layers.end(), between.begin(), between.end());
  layers.push_back(upper);
  return layers;
}

void expect_fit(const std::vector<Outline>& outlines, const std::string& where) {
  ContourStack stack;
  for (const Outline& outline : outlines) {
    Slice& slice = stack.slices.emplace_back(Slice{static_cast<double>(stack.slices.size()), {}});
    for (const Ring& ring : outline) slice.contours.push_back({"tooth", ring});
  }
  ASSERT_NO_THROW(validate(stack)) << where;
}

/// Links of the layers name contours that are there, of the right kind.
void expect_links_meant(const JoinedBlend& made, const std::vector<Outline>& layers, const std::string& where) {
  ASSERT_EQ(made.links.size() + 1, layers.size()) << where;
  for (std::size_t k = 0; k < made.links.size(); ++k) {
    const auto is = [&](std::size_t layer, std::size_t contour, bool outer) {
      if (contour == between::outside) return !outer;
      return contour < layers[layer].size() && (area({layers[layer][contour]}) > 0) == outer;
    };
    for (const auto& link : made.links[k].material)
      ASSERT_TRUE(is(k, link.lower, true) && is(k + 1, link.upper, true)) << where;
    for (const auto& link : made.links[k].voids)
      ASSERT_TRUE(is(k, link.lower, false) && is(k + 1, link.upper, false)) << where;
  }
}

void expect_as_implied(const Outline& lower, const Outline& upper, const Links& links, const LayerTopology& truth,
                       const std::string& where) {
  const JoinedBlend made = blend_joined(between_slices(lower, upper, links), quarters);
  EXPECT_TRUE(made.as_implied()) << where;
  EXPECT_EQ(made.implied, truth) << where;
  const std::vector<Outline> layers = layers_of(lower, made.outlines, upper);
  expect_fit(layers, where);
  expect_links_meant(made, layers, where);
  const LayerTopology counted = glued_topology(layers, fine);
  EXPECT_EQ(counted, truth) << where << ": pieces " << counted.pieces << ", voids " << counted.voids << ", loops "
                            << counted.loops;
}

Outline ring(double outer, double inner, Point2 centre = {}) {
  return {circle(outer, centre), hole(circle(inner, centre))};
}

TEST(JoinedBlend, HasTheTopologyThatTheLinksImply) {
  const auto overlapping = [](const Outline& lower, const Outline& upper, const LayerTopology& truth,
                              const std::string& where) {
    expect_as_implied(lower, upper, overlap_links(lower, upper), truth, where);
  };
  overlapping({circle(1)}, {circle(1, {0.5, 0})}, {1, 1, 0}, "shifted circle");
  overlapping(ring(3, 2.5), {circle(3)}, {1, 2, 0}, "flat roof");
  overlapping({circle(1)}, {circle(0.6, {-0.8, 0}), circle(0.6, {0.8, 0})}, {1, 1, 0}, "fork");
  overlapping({c_shape(2, 1.6, 0.5)}, ring(2, 1.6), {1, 1, 1}, "C to ring");
  overlapping({ellipse(3, 0.5, {0, 1}), ellipse(3, 0.5, {0, -1})}, {ellipse(0.5, 3, {1, 0}), ellipse(0.5, 3, {-1, 0})},
              {1, 1, 1}, "two over two crosswise");
}

TEST(JoinedBlend, JoinsWhatIsLinkedWithoutOverlap) {
  expect_as_implied({circle(0.3)}, {circle(0.3, {0.9, 0})}, {{{0, 0}}, {}}, {1, 1, 0}, "canal slanted by three radii");
  const Links both{{{0, 0}}, {{1, 1}}};
  expect_as_implied(ring(2, 1.8), ring(2, 1.8, {0.4, 0}), both, {1, 2, 1}, "ring that drifts by twice its width");
  expect_as_implied(ring(2, 1.8), ring(2, 1.8, {1.4, 0}), both, {1, 2, 1}, "ring that drifts by seven widths");
  expect_as_implied({circle(4), hole(circle(0.3))}, {circle(4), hole(circle(0.3, {0.9, 0}))}, both, {1, 2, 1},
                    "canal in its tooth");
  expect_as_implied({circle(1)}, {circle(0.6, {2.2, 0}), circle(0.6, {3.8, 0})}, {{{0, 0}, {0, 1}}, {}}, {1, 1, 0},
                    "fork that drifts");
}

TEST(JoinedBlend, JoinsOnceWhatOverlapsInSeveralPieces) {
  const Outline teeth{comb(4, 2, 0.3)}, bar{rectangle({0, 1}, {3, 1.3})};
  ASSERT_GT(glued_topology({teeth, bar}, fine).loops, 0);
  expect_as_implied(teeth, bar, overlap_links(teeth, bar), {1, 1, 0}, "a bar over a comb's teeth");
}

TEST(JoinedBlend, KeepsApartWhatOverlapsAndIsNotLinked) {
  expect_as_implied({circle(1)}, {circle(1, {0.2, 0})}, {}, {2, 1, 0}, "two circles");
}

TEST(JoinedBlend, ChangesNothingThatIsRightAlready) {
  const Outline lower = ring(3, 2), upper = ring(3.2, 2.1, {0.2, 0});
  const Links links = overlap_links(lower, upper);
  const JoinedBlend made = blend_joined(between_slices(lower, upper, links), quarters);
  EXPECT_TRUE(made.corrections.empty());
  const std::vector<Outline> plain = blend(between_slices(lower, upper, links), quarters);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(area(made.outlines[n]), area(plain[n]), 0.002 * area(plain[n]));
}

TEST(JoinedBlend, TellsWhatItCut) {
  const Outline teeth{comb(4, 2, 0.3)}, bar{rectangle({0, 1}, {3, 1.3})};
  const JoinedBlend made = blend_joined(between_slices(teeth, bar, overlap_links(teeth, bar)), quarters);
  ASSERT_FALSE(made.corrections.empty());
  for (const between::Correction& correction : made.corrections) {
    EXPECT_GT(correction.volume, 0);
    EXPECT_GT(correction.place.z, 0);
    EXPECT_LT(correction.place.z, 1);
    EXPECT_GT(correction.place.x, 0);
    EXPECT_LT(correction.place.x, 3);
  }
}

TEST(JoinedBlend, IsRightForRandomSlicesThatTheGridResolves) {
  std::size_t resolved = 0, right = 0, counted_right = 0;
  std::string wrong;
  for (std::uint64_t seed = 0; seed < 36; ++seed) {
    const RandomStack random = random_stack(seed);
    const ContourStack stack = ordered(random.stack).stack;
    const std::string name = structures_of(stack).front();
    const Outline lower = outline_of(stack.slices[0], name), upper = outline_of(stack.slices[1], name);
    if (random.kind == "stars" || lower.empty() || upper.empty()) continue;
    const Links links = overlap_links(lower, upper);
    const JoinedBlend made = blend_joined(between_slices(lower, upper, links), quarters);
    const std::vector<Outline> layers = layers_of(lower, made.outlines, upper);
    expect_fit(layers, random.kind + std::to_string(seed));
    if (!made.resolved) continue;
    ++resolved;
    right += made.as_implied();
    expect_links_meant(made, layers, random.kind + std::to_string(seed));
    LayerTopology counted = glued_topology(layers, fine);
    if (counted != made.found)
      counted = glued_topology(layers, 2 * fine);  // slivers narrower than a point of the raster
    counted_right += counted == made.found;
    if (counted != made.found) {
      wrong += random.kind + std::to_string(seed) + ": " + std::to_string(counted.pieces) + " " +
               std::to_string(counted.voids) + " " + std::to_string(counted.loops) + " for " +
               std::to_string(made.found.pieces) + " " + std::to_string(made.found.voids) + " " +
               std::to_string(made.found.loops) + "; ";
    }
  }
  EXPECT_GT(resolved, 15u);
  EXPECT_EQ(right, resolved);
  EXPECT_EQ(counted_right, resolved) << wrong;
}

/// Topology of the 26 neighbours, told by counting the whole block with and without its middle.
TEST(SimplePoint, AgreesWithTheCountOfTheBlock) {
  RandomNumbers random(7);
  const auto count = [](std::uint32_t block) {
    constexpr int n = 5;  // a border of void around
    std::array<bool, n * n * n> solid{};
    for (int b = 0; b < 27; ++b)
      solid[static_cast<std::size_t>((b % 3 + 1) + n * ((b / 3 % 3 + 1) + n * (b / 9 + 1)))] = block >> b & 1;
    UnionFind sets(solid.size());
    int euler = 0;
    const auto place = [&](int x, int y, int z) { return static_cast<std::size_t>(x + n * (y + n * z)); };
    for (int z = 0; z < n; ++z) {
      for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
          for (int to = 0; to < 27; ++to) {
            const int u = x + to % 3 - 1, v = y + to / 3 % 3 - 1, w = z + to / 9 - 1;
            if (u < 0 || v < 0 || w < 0 || u >= n || v >= n || w >= n) continue;
            const bool face = std::abs(u - x) + std::abs(v - y) + std::abs(w - z) == 1;
            if (solid[place(u, v, w)] == solid[place(x, y, z)] && (!solid[place(x, y, z)] || face))
              sets.join(static_cast<std::uint32_t>(place(x, y, z)), static_cast<std::uint32_t>(place(u, v, w)));
          }
          for (int cell = 0; cell < 8; ++cell) {
            bool whole = true;
            for (int corner = 0; corner < 8; ++corner) {
              const int u = x + (corner & 1), v = y + (corner >> 1 & 1), w = z + (corner >> 2);
              if ((corner & cell) == corner) whole = whole && u < n && v < n && w < n && solid[place(u, v, w)];
            }
            if (whole) euler += ((cell & 1) + (cell >> 1 & 1) + (cell >> 2)) % 2 == 0 ? 1 : -1;
          }
        }
      }
    }
    std::array<int, 3> result{0, 0, euler};
    for (std::uint32_t v = 0; v < solid.size(); ++v) {
      if (sets.find(v) == v) ++result[solid[v] ? 0 : 1];
    }
    return result;
  };
  int simple = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto block = static_cast<std::uint32_t>(random.bits() & random.bits() & 0x7ffffffu) |
                       static_cast<std::uint32_t>(random.bits() & 0x1ffu);
    const std::uint32_t with = block | 1u << 13, without = block & ~(1u << 13);
    if (!between::local_pieces(block).simple()) continue;
    ++simple;
    ASSERT_EQ(count(with), count(without)) << block;
  }
  EXPECT_GT(simple, 200);
}

}  // namespace
}  // namespace odontoscope::test
