// The oracle's topological certificate on solids of cubes, whose topology is known: it must pass what the links imply,
// and see planted handles, sheets, beads and bubbles.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/cube_solids.h"
#include "tests/support/oracle_topology.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

using Voids = std::vector<VoidLink>;
const Link joined{"tooth", 0, 0, 0, true};

JudgedSlab judged(const std::vector<Picture>& layers, const std::vector<Link>& links, const Voids& voids) {
  const auto slabs = slab_topology(cubes(layers), stack_of_cubes(layers, {0, layers.size()}), links, voids);
  EXPECT_EQ(slabs.size(), 1u);
  return slabs[0];
}

std::string words(const JudgedSlab& slab) {
  std::string all;
  for (const std::string& fault : slab.faults) all += fault + "; ";
  return all;
}

void expect_green(const JudgedSlab& slab, SlabCount count) {
  EXPECT_EQ(words(slab), "");
  EXPECT_EQ(slab.found, count) << slab.found.pieces << " pieces, " << slab.found.handles << " handles, "
                               << slab.found.bubbles << " bubbles";
  EXPECT_EQ(slab.expected, count);
}

void expect_red(const JudgedSlab& slab, const std::string& fault) {
  EXPECT_NE(words(slab).find(fault), std::string::npos) << words(slab);
}

const Picture full{"#####", "#####", "#####", "#####", "#####"};
const Picture ring{"#####", "#...#", "#...#", "#...#", "#####"};
const Picture empty{".....", ".....", ".....", ".....", "....."};
const Picture open_ring{"#####", "#...#", "#....", "#...#", "#####"};  // a C
const Picture corner{"##...", "##...", ".....", ".....", "....."};
/// A ring's hole is contour 1: outlines are numbered from the left.
const VoidLink canal{"tooth", 0, 1, 1};

TEST(Topology, PassesABlock) { expect_green(judged({full, full, full}, {joined}, {}), {1, 0, 0}); }

TEST(Topology, PassesACanal) { expect_green(judged({ring, ring, ring}, {joined}, {canal}), {1, 1, 0}); }

TEST(Topology, PassesAHoleThatEndsBlind) { expect_green(judged({ring, ring, full}, {joined}, {}), {1, 0, 0}); }

TEST(Topology, PassesAHoleThatOpensIntoAGap) {
  expect_green(judged({ring, ring, open_ring}, {joined}, {{"tooth", 0, 1, std::nullopt}}), {1, 1, 0});
}

TEST(Topology, PassesBarsLaidCrosswise) {
  const Picture lying{"#####", ".....", ".....", ".....", "#####"},
      standing{"#...#", "#...#", "#...#", "#...#", "#...#"};
  const Picture both{"#...#", ".....", ".....", ".....", "#...#"};
  std::vector<Link> links;
  for (std::size_t a : {0, 1})
    for (std::size_t b : {0, 1}) links.push_back({"tooth", 0, a, b, true});
  expect_green(judged({lying, both, standing}, links, {}), {1, 1, 0});
  links.pop_back();
  expect_red(judged({lying, both, standing}, links, {}), "a handle too many");
}

TEST(Topology, PassesPlatesAndTheirAbsence) {
  expect_green(judged({full, empty, empty}, {}, {}), {1, 0, 0});
  expect_green(judged({full, empty, full}, {}, {}), {2, 0, 0});
  expect_green(judged({ring, empty, empty}, {}, {{"tooth", 0, 1, std::nullopt}}), {1, 1, 0});
  expect_green(judged({ring, empty, empty}, {}, {}), {1, 1, 0});
  // The lower region has its plate below: its contours mean nothing here.
  const std::vector<Picture> above{empty, empty, full}, with_lower{ring, empty, full};
  const auto slab =
      slab_topology(cubes(above), stack_of_cubes(with_lower, {0, 3}), {}, Voids{{"tooth", 0, 1, std::nullopt}})[0];
  expect_green(slab, {1, 0, 0});
}

TEST(Topology, TellsSlabsApart) {
  const std::vector<Picture> layers{full, full, full, ring, full};
  const auto slabs =
      slab_topology(cubes(layers), stack_of_cubes(layers, {0, 2, 5}), {joined, {"tooth", 1, 0, 0, true}}, Voids{});
  ASSERT_EQ(slabs.size(), 2u);
  EXPECT_EQ(words(slabs[0]), "");
  expect_red(slabs[1], "has a bubble");
}

TEST(Topology, SeesAHandle) {
  const Picture pierced{"#####", "#####", ".....", "#####", "#####"};  // a tunnel from side to side
  expect_red(judged({full, pierced, full}, {joined}, {}), "a handle too many");
}

TEST(Topology, SeesASheet) {
  expect_red(judged({ring, full, ring}, {joined}, {canal}), "closes what a void link joins");
  expect_red(judged({ring, full, ring}, {joined}, {canal}), "lacks a handle");
}

TEST(Topology, SeesASheetThatAHandleMakesUpFor) {
  // Closed in the lower layer, pierced from side to side above it: as many handles as a canal has.
  const Picture pierced{"#####", "#...#", ".....", "#...#", "#####"};
  const JudgedSlab slab = judged({ring, full, pierced, ring, ring}, {joined}, {canal});
  expect_red(slab, "closes what a void link joins");
  expect_red(slab, "opens what no void link joins");
}

TEST(Topology, SeesABead) { expect_red(judged({full, empty, full}, {joined}, {}), "2 pieces where links join one"); }

TEST(Topology, SeesABridge) {
  const Picture two{"##.##", "##.##", "##.##", "##.##", "##.##"};
  const std::vector<Link> each{{"tooth", 0, 0, 0, true}, {"tooth", 0, 1, 1, true}};
  expect_green(judged({two, two, two}, each, {}), {2, 0, 0});
  expect_red(judged({two, full, two}, each, {}), "joins what no link joins");
}

TEST(Topology, SeesABubbleAndAGhost) {
  expect_red(judged({full, ring, full}, {joined}, {}), "has a bubble");
  const Picture speck{".....", ".....", "..#..", ".....", "....."};
  expect_red(judged({ring, ring, Picture{"#####", "#...#", "#.#.#", "#...#", "#####"}, ring, ring}, {joined}, {canal}),
             "a piece that holds no region");
  expect_red(judged({corner, empty, speck, empty, corner}, {}, {}), "a piece that holds no region");
}

TEST(Topology, SeesAHoleOpenedWithoutALink) {
  expect_red(judged({ring, ring, ring}, {joined}, {}), "opens what no void link joins");
  expect_red(judged({ring, open_ring, full}, {joined}, {}), "opens what no void link joins");
}

TEST(Topology, SeesARegionCarriedInPart) {
  std::vector<Picture> layers{full, full, full};
  Solid solid = cubes(layers);
  const ContourStack stack = stack_of_cubes(layers, {0, 3});
  std::erase_if(solid.tetrahedra.tetrahedra, [&](const Tetrahedron& t) {
    return std::all_of(t.begin(), t.end(), [&](PointIndex v) {
      return solid.tetrahedra.points[v].x >= 3 && solid.tetrahedra.points[v].z <= 1;
    });
  });
  expect_red(slab_topology(solid, stack, {joined}, Voids{})[0], "carries a region in part");
}

TEST(Topology, SeesLinksThatNameNothing) {
  expect_red(judged({ring, ring, ring}, {{"tooth", 0, 1, 0, true}}, {canal}), "a link that names no region");
  expect_red(judged({ring, ring, ring}, {joined}, {{"tooth", 0, 0, 1}}), "a void link that names no hole");
  expect_red(judged({ring, empty, empty}, {{"tooth", 0, 0, 7, true}}, {}), "a link that names no region");
}

TEST(Topology, ComparesWithWhatTheResultSays) {
  const std::vector<Picture> layers{ring, ring, ring};
  Reconstruction result;
  result.solids = {cubes(layers)};
  result.links = {{joined, LinkCriterion::medial}};
  result.void_links = {{"tooth", 0, 1, 1, LinkCriterion::medial}};
  result.topology = {{"tooth", 0, {1, 1, 0}, {1, 1, 0}, 0}};
  const auto untrue = [&] { return judge_topology(result, stack_of_cubes(layers, {0, 3})).untrue; };
  EXPECT_EQ(untrue(), std::vector<std::string>{});
  result.topology[0].found.handles = 0;
  EXPECT_EQ(untrue(),
            std::vector<std::string>{
                "tooth, slab 0: found 1 pieces, 1 handles, 0 bubbles, told are 1 pieces, 0 handles, 0 bubbles"});
  result.topology[0] = {"tooth", 0, {1, 0, 0}, {1, 1, 0}, 0};
  EXPECT_EQ(untrue(),
            std::vector<std::string>{
                "tooth, slab 0: implied are 1 pieces, 1 handles, 0 bubbles, told are 1 pieces, 0 handles, 0 bubbles"});
  result.topology.clear();
  EXPECT_EQ(untrue(), std::vector<std::string>{"tooth, slab 0: the result does not tell its topology"});
}

// --- pictures at random, laid on each other --------------------------------------------------------------------------

Picture random_picture(RandomNumbers& random) {
  for (;;) {
    Picture picture(7, std::string(7, '.'));
    const double share = random.between(0.4, 0.9);
    for (auto& row : picture)
      for (char& cell : row) cell = random.chance(share) ? '#' : '.';
    for (std::size_t i = 0; i < 60 && !has_plain_corners(picture); ++i)  // smooth what meets across corners
      for (std::size_t y = 0; y + 1 < 7; ++y)
        for (std::size_t x = 0; x + 1 < 7; ++x)
          if (picture[y][x] == picture[y + 1][x + 1] && picture[y + 1][x] == picture[y][x + 1] &&
              picture[y][x] != picture[y][x + 1])
            picture[y][x] = picture[y][x + 1];
    if (has_plain_corners(picture) && !Outlines(picture).rings().empty()) return picture;
  }
}

Picture common(const Picture& a, const Picture& b) {
  Picture both = a;
  for (std::size_t y = 0; y < both.size(); ++y)
    for (std::size_t x = 0; x < both[y].size(); ++x)
      if (b[y][x] != '#') both[y][x] = '.';
  return both;
}

/// What a middle layer joins, counted on the pictures: regions of both slices and void regions, and how often.
struct Truth {
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::size_t>>
      overlaps;  // of linked regions: the middle's pieces
  Voids voids;
};

Truth truth_of(const Picture& lower, const Picture& middle, const Picture& upper) {
  const Outlines below(lower), above(upper);
  std::size_t count = 0;
  const auto pieces = pieces_of(middle, count);
  Truth truth;
  std::map<std::size_t, std::set<std::optional<std::size_t>>> below_of, above_of;  // void regions by the middle's void
  for (std::size_t y = 0; y < middle.size(); ++y)
    for (std::size_t x = 0; x < middle[y].size(); ++x) {
      if (middle[y][x] == '#')
        truth.overlaps[{*below.contour_round(x, y), *above.contour_round(x, y)}].insert(pieces[y][x]);
      else {
        if (lower[y][x] != '#') below_of[pieces[y][x]].insert(below.contour_round(x, y));
        if (upper[y][x] != '#') above_of[pieces[y][x]].insert(above.contour_round(x, y));
      }
    }
  below_of[0].insert(std::nullopt);
  above_of[0].insert(std::nullopt);
  for (auto& [piece, from] : below_of)
    for (const auto& a : from)
      for (const auto& b : above_of[piece]) truth.voids.push_back({"tooth", 0, a, b});
  return truth;
}

TEST(Topology, CountsRandomPicturesRight) {
  RandomNumbers random(13);
  int plain = 0, with_handles = 0;
  for (int tries = 0; tries < 4000 && (plain < 40 || with_handles < 40); ++tries) {
    const Picture lower = random_picture(random), upper = random_picture(random), middle = common(lower, upper);
    if (!has_plain_corners(middle)) continue;
    const Truth truth = truth_of(lower, middle, upper);
    std::vector<Link> links;
    long spare = 0;
    for (const auto& [pair, pieces] : truth.overlaps) {
      links.push_back({"tooth", 0, pair.first, pair.second, true});
      spare += long(pieces.size()) - 1;
    }
    const JudgedSlab slab = judged({lower, middle, upper}, links, truth.voids);
    EXPECT_EQ(slab.found.handles - slab.expected.handles, spare);
    if (spare == 0)
      EXPECT_EQ(words(slab), "");
    else
      expect_red(slab, "a handle too many");
    (spare == 0 ? plain : with_handles) += 1;
  }
  EXPECT_GE(plain, 40);
  EXPECT_GE(with_handles, 40);
}

TEST(Topology, SeesWhateverChangesInRandomPictures) {
  // One cell is taken out of the middle: green exactly if pieces, hollows and their number stay.
  RandomNumbers random(14);
  int red = 0, green = 0;
  for (int tries = 0; tries < 9000 && (red < 30 || green < 30); ++tries) {
    const Picture lower = random_picture(random), upper = random_picture(random), middle = common(lower, upper);
    Picture cut = middle;
    cut[std::size_t(random.below(7))][std::size_t(random.below(7))] = '.';
    if (cut == middle || !has_plain_corners(middle) || !has_plain_corners(cut)) continue;
    const Truth truth = truth_of(lower, middle, upper), now = truth_of(lower, cut, upper);
    std::vector<Link> links;
    bool simple = truth.overlaps.size() == now.overlaps.size();
    for (const auto& [pair, pieces] : truth.overlaps) {
      links.push_back({"tooth", 0, pair.first, pair.second, true});
      if (pieces.size() != 1) simple = false;
    }
    if (!simple) continue;
    std::size_t before = 0, after = 0;
    pieces_of(middle, before);
    pieces_of(cut, after);
    bool same = before == after;
    for (const auto& [pair, pieces] : now.overlaps) same = same && pieces.size() == 1;
    const JudgedSlab slab = judged({lower, cut, upper}, links, truth.voids);
    EXPECT_EQ(slab.faults.empty(), same) << words(slab);
    (slab.faults.empty() ? green : red) += 1;
  }
  EXPECT_GE(red, 30);
  EXPECT_GE(green, 30);
}

}  // namespace
}  // namespace odontoscope::test
