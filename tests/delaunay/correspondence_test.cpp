// Which regions are joined, by criterion and by the user's word.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/plane_check.h"
#include "tests/support/random_numbers.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

const std::string ball = "tooth external genus 0";

ReconstructOptions by(Correspondence criterion, std::vector<Link> links = {}) {
  return {.correspondence = criterion, .links = std::move(links), .threads = 1};
}

std::size_t pieces(double radii, Correspondence criterion) {
  return certified(shifted_circles(radii), by(criterion)).solids.at(0).report.shells.size();
}

// A circle's medial axis is its centre. So two circles have no reverse tetrahedron unless concentric (to within
// rounding); a circumcentre of one lies in the other up to a shift of one radius; and they overlap up to two.
TEST(Correspondence, ShiftedCirclesByReverseTetrahedra) {
  for (double radii : {0.2, 0.5, 0.9, 1.5, 2.5}) EXPECT_EQ(pieces(radii, Correspondence::reverse), 2u) << radii;
}

TEST(Correspondence, ShiftedCirclesByMedialAxis) {
  for (double radii : {0.2, 0.5, 0.9}) EXPECT_EQ(pieces(radii, Correspondence::medial), 1u) << radii;
  for (double radii : {1.5, 2.5}) EXPECT_EQ(pieces(radii, Correspondence::medial), 2u) << radii;
}

TEST(Correspondence, ShiftedCirclesByOverlap) {
  for (double radii : {0.2, 0.5, 0.9, 1.5}) EXPECT_EQ(pieces(radii, Correspondence::overlap), 1u) << radii;
  EXPECT_EQ(pieces(2.5, Correspondence::overlap), 2u);
}

TEST(Correspondence, CrossingEllipsesHaveReverseTetrahedra) {
  const Reconstruction result = certified(two_over_two_crosswise(), by(Correspondence::reverse));
  ASSERT_EQ(result.links.size(), 4u);
  for (const MadeLink& made : result.links) EXPECT_EQ(made.criterion, LinkCriterion::reverse);
}

TEST(Correspondence, ALinkIsReportedWithTheNarrowestCriterionThatMakesIt) {
  const auto criterion = [](double radii) {
    const Reconstruction result = certified(shifted_circles(radii), by(Correspondence::overlap));
    return result.links.at(0).criterion;
  };
  EXPECT_EQ(criterion(0.5), LinkCriterion::medial);
  EXPECT_EQ(criterion(1.5), LinkCriterion::overlap);
}

using Pair = std::tuple<std::string, std::size_t, std::size_t, std::size_t>;
Pair pair_of(const Link& link) { return {link.structure, link.slice, link.lower, link.upper}; }

std::set<Pair> linked_by_geometry(const Reconstruction& result) {
  std::set<Pair> pairs;
  for (const MadeLink& made : result.links)
    if (made.criterion != LinkCriterion::crossing) pairs.insert(pair_of(made.link));
  return pairs;
}

/// What is linked does not depend on what is interpolated, which takes longer.
ReconstructOptions alone(ReconstructOptions options) {
  options.between = Between::delaunay;
  return options;
}

TEST(Correspondence, EachCriterionIncludesTheOneBefore) {
  for (std::uint64_t seed = 0; seed < random_stacks_of(50); ++seed) {
    const ContourStack stack = random_stack(seed).stack;
    const auto reverse = linked_by_geometry(reconstruct(stack, alone(by(Correspondence::reverse))));
    const auto medial = linked_by_geometry(reconstruct(stack, alone(by(Correspondence::medial))));
    const auto overlap = linked_by_geometry(reconstruct(stack, alone(by(Correspondence::overlap))));
    EXPECT_TRUE(std::includes(medial.begin(), medial.end(), reverse.begin(), reverse.end())) << seed;
    EXPECT_TRUE(std::includes(overlap.begin(), overlap.end(), medial.begin(), medial.end())) << seed;
  }
}

// --- the user's word -------------------------------------------------------------------------------------------------

TEST(Links, ForceWhatNoCriterionJoins) {
  const std::vector<Link> force{{"tooth", 0, 0, 0, true}};
  for (double radii : {1.5, 2.5, 6.0}) {
    const Reconstruction result = certified(shifted_circles(radii), by(Correspondence::reverse, force));
    EXPECT_EQ(topology_of(result), shells({ball})) << radii;
    ASSERT_EQ(result.links.size(), 1u);
    EXPECT_EQ(result.links[0].criterion, LinkCriterion::user);
  }
}

TEST(Links, ForceAcrossNearerNeighbours) {
  // Two columns, and the foot of one linked with the head of the other: they become one piece.
  const ContourStack stack = stack_of({{circle(1), circle(1, {10, 0})}, {circle(1, {0.3, 0}), circle(1, {9.7, 0})}});
  const Reconstruction result = certified(stack, by(Correspondence::medial, {{"tooth", 0, 0, 1, true}}));
  EXPECT_EQ(result.solids[0].report.shells.size(), 1u);
}

TEST(Links, ForbidWhatEveryCriterionJoins) {
  const std::vector<Link> forbid{{"tooth", 0, 0, 0, false}};
  for (double radii : {0.0, 0.5, 1.5}) {
    const Reconstruction result = certified(shifted_circles(radii), by(Correspondence::overlap, forbid));
    EXPECT_EQ(topology_of(result), shells({ball, ball})) << radii;
    EXPECT_TRUE(result.links.empty());
  }
}

TEST(Links, ForbidOneOfTwoBranches) {
  const Reconstruction result = certified(one_over(2), by(Correspondence::medial, {{"tooth", 0, 1, 0, false}}));
  EXPECT_EQ(topology_of(result), shells({ball, ball}));
}

TEST(Links, OpenTheWindowOfFourCrossings) {
  // Keeping one crossing apart breaks the chain through the other three as well, or its ends would be joined after all.
  const std::vector<Link> forbid{{"tooth", 0, 0, 0, false}};
  EXPECT_EQ(topology_of(certified(two_over_two_crosswise(), by(Correspondence::medial, forbid))), shells({ball, ball}));
}

std::string cause_of(const std::vector<Link>& links, const ContourStack& stack) {
  try {
    reconstruct(stack, by(Correspondence::medial, links));
    return "accepted";
  } catch (const InputError& error) {
    return error.cause();
  }
}

TEST(Links, ThatMakeNoSenseAreRefused) {
  const ContourStack stack = annulus_over_disc();  // slice 0: outer 0, hole 1
  EXPECT_EQ(cause_of({{"tooth", 0, 0, 0, true}}, stack), "accepted");
  EXPECT_EQ(cause_of({{"tooth", 0, 0, 0, true}, {"tooth", 0, 0, 0, false}}, stack), "link-contradiction");
  EXPECT_EQ(cause_of({{"nobody", 0, 0, 0, true}}, stack), "link-unknown-structure");
  EXPECT_EQ(cause_of({{"tooth", 1, 0, 0, true}}, stack), "link-unknown-slice");
  EXPECT_EQ(cause_of({{"tooth", 0, 7, 0, true}}, stack), "link-unknown-contour");
  EXPECT_EQ(cause_of({{"tooth", 0, 1, 0, true}}, stack), "link-not-outer");
}

/// Every pair of outer contours of one structure in neighbouring slices.
std::vector<Link> all_pairs(const ContourStack& stack) {
  const auto outer = [](const Slice& slice, std::size_t contour) {
    std::vector<std::vector<Point2>> rings{slice.contours[contour].points};
    for (std::size_t i = 0; i < slice.contours.size(); ++i)
      if (i != contour && slice.contours[i].structure == slice.contours[contour].structure)
        rings.push_back(slice.contours[i].points);
    return depth_of(rings, 0) % 2 == 0;
  };
  std::vector<Link> links;
  for (std::size_t k = 0; k + 1 < stack.slices.size(); ++k)
    for (std::size_t a = 0; a < stack.slices[k].contours.size(); ++a)
      for (std::size_t b = 0; b < stack.slices[k + 1].contours.size(); ++b) {
        const std::string& structure = stack.slices[k].contours[a].structure;
        if (structure == stack.slices[k + 1].contours[b].structure && outer(stack.slices[k], a) &&
            outer(stack.slices[k + 1], b))
          links.push_back({structure, k, a, b, true});
      }
  return links;
}

/// Empty if the result honours every wish; the oracle has already proven that the solid is joined as `links` says.
std::string ignored_wish(const Reconstruction& result, const std::vector<Link>& wishes) {
  std::set<Pair> made, by_user;
  for (const MadeLink& link : result.links) {
    made.insert(pair_of(link.link));
    if (link.criterion == LinkCriterion::user) by_user.insert(pair_of(link.link));
  }
  for (const Link& wish : wishes) {
    const std::string where =
        " slice " + std::to_string(wish.slice) + " " + std::to_string(wish.lower) + "-" + std::to_string(wish.upper);
    if (wish.connect && !by_user.contains(pair_of(wish))) return "not forced:" + where;
    if (!wish.connect && made.contains(pair_of(wish))) return "not forbidden:" + where;
  }
  return {};
}

std::vector<Link> random_wishes(const ContourStack& stack, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<Link> wishes;
  for (Link link : all_pairs(stack)) {
    link.connect = random.chance(0.4);
    if (random.chance(0.4)) wishes.push_back(link);
  }
  return wishes;
}

TEST(Links, WinOnRandomStacks) {
  int refused = 0, honoured = 0;
  for (std::uint64_t seed = 0; seed < random_stacks_of(100); ++seed) {
    const ContourStack stack = sorted(random_stack(seed).stack);
    const std::vector<Link> wishes = random_wishes(stack, seed);
    try {
      const bool interpolated = seed % 4 == 0;  // it takes as long as all the others
      const ReconstructOptions options = by(Correspondence::medial, wishes);
      const Reconstruction result = reconstruct(stack, interpolated ? options : alone(options));
      for (const std::string& fault : faults_of(result, stack)) ADD_FAILURE() << "seed " << seed << ": " << fault;
      EXPECT_EQ(ignored_wish(result, wishes), "") << "seed " << seed;
      ++honoured;
    } catch (const InputError& error) {
      // Wishes drawn by lot may contradict each other through a third region, or ask for solids that cross.
      EXPECT_TRUE(error.cause() == "link-contradiction" || error.cause() == "link-impossible") << error.what();
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
  }
  EXPECT_GT(honoured, 3 * refused);
}

}  // namespace
}  // namespace odontoscope::test
