// Faults planted between two slices, in models like those that interpolated slices make: a slice is put in on purpose
// and hidden from the judge. The oracle must see each, and see through a result that tells of none.

#include <gtest/gtest.h>

#include <algorithm>

#include "recon/delaunay/face_table.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/delaunay/topology.h"
#include "tests/support/oracle_topology.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

using Rings = std::vector<Ring>;

const Rings disc{circle(2)}, ring{circle(2), circle(0.8)}, nothing{};
const Rings slit{rectangle({-1, -1}, {1, -0.2}), rectangle({-1, 0.2}, {1, 1})};
const Rings two{circle(0.5, {-1, 0}), circle(0.5, {1, 0})};
const MadeLink joined{{"tooth", 0, 0, 0, true}, LinkCriterion::medial},
    joined_too{{"tooth", 0, 1, 1, true}, LinkCriterion::medial};
const MadeVoidLink canal{"tooth", 0, 1, 1, LinkCriterion::medial};

/// The model of lower, hidden and upper, told as one slab that is what its links imply.
Reconstruction planted(const Rings& lower, const Rings& hidden, const Rings& upper, const std::vector<MadeLink>& links,
                       const std::vector<MadeVoidLink>& voids, Topology told) {
  Reconstruction result = reconstruct(stack_of({lower, hidden, upper}),
                                      {.correspondence = Correspondence::overlap, .between = Between::delaunay});
  result.links = links;
  result.void_links = voids;
  result.topology = {{"tooth", 0, told, told, 1}};
  return result;
}

ContourStack without_hidden(const Rings& lower, const Rings& upper) {
  ContourStack stack = stack_of({lower, nothing, upper});
  stack.slices.erase(stack.slices.begin() + 1);
  return stack;
}

std::string words(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

void expect_red(const Rings& lower, const Rings& hidden, const Rings& upper, const std::vector<MadeLink>& links,
                const std::vector<MadeVoidLink>& voids, Topology told, const std::string& fault) {
  const TopologyVerdict verdict =
      judge_topology(planted(lower, hidden, upper, links, voids, told), without_hidden(lower, upper));
  EXPECT_NE(words(verdict.not_as_implied).find(fault), std::string::npos) << words(verdict.not_as_implied);
  EXPECT_NE(words(verdict.untrue).find("told are"), std::string::npos) << words(verdict.untrue);
}

TEST(Planted, NothingIsGreen) {
  const TopologyVerdict verdict =
      judge_topology(planted(ring, ring, ring, {joined}, {canal}, {1, 1, 0}), without_hidden(ring, ring));
  EXPECT_EQ(words(verdict.not_as_implied) + words(verdict.untrue), "");
}

TEST(Planted, HandleIsSeen) { expect_red(disc, slit, disc, {joined}, {}, {1, 0, 0}, "has a handle too many"); }

TEST(Planted, SheetIsSeen) {
  expect_red(ring, disc, ring, {joined}, {canal}, {1, 1, 0}, "closes what a void link joins");
}

TEST(Planted, BeadsAreSeen) {
  expect_red(disc, nothing, disc, {joined}, {}, {1, 0, 0}, "2 pieces where links join one");
}

TEST(Planted, BubbleIsSeen) { expect_red(disc, ring, disc, {joined}, {}, {1, 0, 0}, "has a bubble"); }

TEST(Planted, BridgeIsSeen) {
  expect_red(two, disc, two, {joined, joined_too}, {}, {2, 0, 0}, "joins what no link joins");
}

TEST(Planted, GhostIsSeen) {
  Rings with_island = ring;
  with_island.push_back(circle(0.3));
  expect_red(ring, with_island, ring, {joined}, {canal}, {1, 1, 0}, "a piece that holds no region");
}

TEST(Planted, BlendedModelIsGreenAndItsLieIsSeen) {
  const Rings moved{circle(2, {1, 0}), circle(0.8, {1, 0})};
  const ContourStack stack = stack_of({ring, moved});
  Reconstruction made = reconstruct(stack, {.between = Between::blended});
  ASSERT_EQ(made.topology.size(), 1u);
  EXPECT_GT(made.topology[0].interpolated, 0u);
  EXPECT_EQ(words(judge_topology(made, stack).not_as_implied) + words(judge_topology(made, stack).untrue), "");
  made.topology[0].found.handles -= 1;
  EXPECT_NE(words(judge_topology(made, stack).untrue).find("found 1 pieces, 1 handles"), std::string::npos);
  made.topology[0].found.handles += 1;
  made.void_links.clear();  // then the canal is one that nothing implies
  EXPECT_NE(words(judge_topology(made, stack).not_as_implied).find("opens what no void link joins"), std::string::npos);
}

// --- what trimming may leave: solids that meet themselves ------------------------------------------------------------

Topology of_pinched(const std::vector<Tetrahedron>& tetrahedra) {
  std::vector<Triangle> boundary;
  delaunay::each_outer_face(tetrahedra, [&](const Triangle& face) { boundary.push_back(face); });
  return delaunay::counted_topology_of_pinched(tetrahedra, boundary);
}

TEST(Pinched, PiecesThatMeetInAPointOrAnEdgeAreTwo) {
  EXPECT_EQ(of_pinched({{0, 1, 2, 3}, {3, 4, 5, 6}}), (Topology{2, 0, 0}));
  EXPECT_EQ(of_pinched({{0, 1, 2, 3}, {2, 3, 4, 5}}), (Topology{2, 0, 0}));
  EXPECT_EQ(of_pinched({{0, 1, 2, 3}, {1, 2, 3, 4}}), (Topology{1, 0, 0}));
}

TEST(Pinched, AChainWhoseEndsMeetInAPointIsALoop) {
  // Seven tetrahedra, each on a face of the one before, the last with a corner of the first.
  EXPECT_EQ(
      of_pinched({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}, {3, 4, 5, 6}, {4, 5, 6, 7}, {5, 6, 7, 8}, {6, 7, 8, 0}}),
      (Topology{1, 1, 0}));
  EXPECT_EQ(
      of_pinched({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}, {3, 4, 5, 6}, {4, 5, 6, 7}, {5, 6, 7, 8}, {6, 7, 8, 9}}),
      (Topology{1, 0, 0}));
}

}  // namespace
}  // namespace odontoscope::test
