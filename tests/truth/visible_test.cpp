// Counting voxels, and the rule by which slices can or cannot tell of the truth: on pictures drawn by hand.

#include "visible.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "voxel_topology.h"

namespace odontoscope::test {
namespace {

using Picture = std::vector<std::string>;  // '#' is material; a margin of void is put round it

constexpr std::size_t side = 9;
const Raster raster{0, 0, 1, side + 2, side + 2};

Mask mask_of(const Picture& picture) {
  Mask mask(raster.size(), 0);
  for (std::size_t row = 0; row < picture.size(); ++row)
    for (std::size_t column = 0; column < picture[row].size(); ++column)
      mask[raster.index(column + 1, row + 1)] = picture[row][column] == '#';
  return mask;
}

Topology counted(const std::vector<Picture>& layers) {
  Voxels voxels(raster.columns, raster.rows, 0);
  for (const Picture& layer : layers) {
    const Mask mask = mask_of(layer);
    voxels.values.insert(voxels.values.end(), mask.begin(), mask.end());
    ++voxels.layers;
  }
  return topology_of(voxels, 1);
}

/// Slices are every second picture.
bool visible_of(const std::vector<Picture>& layers, const Topology& truth) {
  std::vector<std::vector<Mask>> slabs;
  for (std::size_t i = 0; i + 2 < layers.size(); i += 2)
    slabs.push_back({mask_of(layers[i]), mask_of(layers[i + 1]), mask_of(layers[i + 2])});
  return visible(raster, slabs, truth);
}

bool visible_of(const std::vector<Picture>& layers) { return visible_of(layers, counted(layers)); }

const Picture nothing{};
const Picture disc{"#####", "#####", "#####", "#####", "#####"};
const Picture ring{"#####", "#...#", "#...#", "#...#", "#####"};
const Picture cut_ring{"#####", "#....", "#....", "#....", "#####"};
const Picture two{"##.##", "##.##", "##.##", "##.##", "##.##"};
const Picture two_across{"#####", "#####", ".....", "#####", "#####"};

TEST(VoxelTopology, CountsPiecesHandlesAndBubbles) {
  EXPECT_EQ(counted({disc}), (Topology{1, 0, 0}));
  EXPECT_EQ(counted({ring, ring}), (Topology{1, 1, 0}));
  EXPECT_EQ(counted({disc, ring, disc}), (Topology{1, 0, 1}));
  EXPECT_EQ(counted({disc, cut_ring, disc}), (Topology{1, 0, 0}));
  EXPECT_EQ(counted({two, two}), (Topology{2, 0, 0}));
  EXPECT_EQ(counted({two, disc}), (Topology{1, 0, 0}));
  EXPECT_EQ(counted({two, two_across}), (Topology{1, 1, 0}));
}

TEST(VoxelTopology, CubesThatShareACornerAreOnePiece) {
  EXPECT_EQ(counted({{"#.", ".#"}}), (Topology{1, 0, 0}));
  EXPECT_EQ(counted({{"#"}, {".", ".#"}}), (Topology{1, 0, 0}));
}

TEST(Visible, IsWhatEverySliceShows) {
  EXPECT_TRUE(visible_of({disc, disc, disc}));
  EXPECT_TRUE(visible_of({ring, ring, ring, ring, ring}));
  EXPECT_TRUE(visible_of({disc, disc, ring, ring, ring, disc, disc}));
}

TEST(Visible, AFurcationIs) { EXPECT_TRUE(visible_of({two, two, two, disc, disc})); }

TEST(Visible, AnOpeningThatASliceCutsIs) { EXPECT_TRUE(visible_of({disc, disc, cut_ring, disc, disc})); }

TEST(Visible, ABubbleOrTunnelBetweenTwoSlicesIsNot) {
  EXPECT_FALSE(visible_of({disc, ring, disc}));
  const Picture tunnel{"#####", "#####", ".....", "#####", "#####"};
  EXPECT_FALSE(visible_of({disc, tunnel, disc}));
}

// An accessory canal from a canal that goes on to the outside, between two slices: what it joins is in both, and
// nothing tells that it is joined.
TEST(Visible, ACanalBetweenTwoSlicesFromOneThatGoesOnIsNot) {
  const Picture pierced{"#####", "#####", "....#", "#####", "#####"},
      hollow{"#####", "#####", "##.##", "#####", "#####"};
  EXPECT_FALSE(visible_of({hollow, hollow, hollow, pierced, hollow, hollow, hollow}));
  EXPECT_TRUE(visible_of({hollow, hollow, hollow, pierced, pierced, pierced, hollow}));
}

// Its bead in a slice tells of it: it must come from somewhere.
TEST(Visible, ACanalOfWhichOneSliceShowsABeadIs) {
  const Picture bead{"#######", "#######", "#.#.###", "#######", "#######"},
      hollow{"#######", "#######", "###.###", "#######", "#######"},
      branch{"#######", "#######", "#...###", "#######", "#######"};
  EXPECT_TRUE(visible_of({hollow, hollow, hollow, branch, bead, bead, hollow}));
}

TEST(Visible, ABridgeBetweenTwoSlicesOfWhatGoesOnIsNot) {
  EXPECT_FALSE(visible_of({two, two, two, disc, two, two, two}));
}

TEST(Visible, APieceBetweenTwoSlicesIsNot) {
  EXPECT_FALSE(visible_of({nothing, disc, nothing, nothing, disc, disc, disc}));
}

TEST(Visible, AnEndThatClosesBeyondTheLastSliceOfAHoleIsNot) {
  EXPECT_FALSE(visible_of({ring, ring, ring, disc, nothing}));
  EXPECT_TRUE(visible_of({ring, ring, ring, nothing, nothing}));
}

TEST(Visible, LegsThatMeetBetweenSlicesAreNot) {
  // A horseshoe whose bow no slice cuts: two regions, nothing above.
  EXPECT_FALSE(visible_of({two, two, two, disc, nothing}));
}

// Four regions in a chain: three links, and no choice.
TEST(Visible, ALoopThatNoLinksBetweenRegionsOverEachOtherMakeIsNot) {
  const Picture lower{"##.####..", "##.####.."}, upper{".####.###", ".####.###"};
  EXPECT_TRUE(visible_of({lower, upper, upper}, {1, 0, 0}));
  EXPECT_FALSE(visible_of({lower, upper, upper}, {1, 1, 0}));
}

TEST(Visible, AnyLinksThatKeepAPieceWholeAreAllowed) {
  EXPECT_TRUE(visible_of({two, disc, two_across}));  // no handle: three of the four links
  const Picture four{"##.##", "##.##", ".....", "##.##", "##.##"};
  EXPECT_TRUE(visible_of({two, four, two_across}));  // a handle: all four
}

// Between these slices nothing happens that is not on one of them: the links make the truth's pieces and bubbles, no
// others.
TEST(Visible, NeverTakesOtherPiecesOrBubblesThanTheLinksMake) {
  std::minstd_rand random(5);
  int seen = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<Picture> layers;
    for (int slice = 0; slice < 4; ++slice) {
      Picture picture(side, std::string(side, '.'));
      for (std::string& row : picture)
        for (char& c : row) c = random() % 3 ? '#' : '.';
      if (slice > 0) layers.push_back(random() % 2 ? picture : layers.back());
      layers.push_back(picture);
    }
    const Topology truth = counted(layers);
    seen += visible_of(layers, truth);
    EXPECT_FALSE(visible_of(layers, {truth.pieces + 1, truth.handles, truth.bubbles})) << n;
    EXPECT_FALSE(visible_of(layers, {truth.pieces, truth.handles, truth.bubbles + 1})) << n;
    EXPECT_FALSE(visible_of(layers, {truth.pieces, truth.handles + 1000, truth.bubbles})) << n;
  }
  RecordProperty("visible", seen);
}

}  // namespace
}  // namespace odontoscope::test
