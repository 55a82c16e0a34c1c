// What --min-area leaves out is counted, and canals among it are told from noise; a canal of one voxel that runs aslant
// is told of.

#include <gtest/gtest.h>

#include "recon/volume/iso_contours.h"
#include "recon/volume/label_contours.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

/// A block of 1 with a canal of one voxel along z, and a single speck in one slice beside it.
Volume block_with_canal(bool speck = true) {
  return volume_of({12, 12, 8}, [speck](std::size_t i, std::size_t j, std::size_t k) {
    if (i == 0 || j == 0 || i == 11 || j == 11) return 0;
    if (i == 4 && j == 4) return 0;
    return speck && i == 8 && j == 8 && k == 3 ? 0 : 1;
  });
}

LevelReport report_of(const Volume& volume, double min_area) {
  return iso_contours(volume, {{0.5, "tooth"}}, {min_area}).levels.front();
}

TEST(SmallContours, AreCountedByKind) {
  const LevelReport report = report_of(block_with_canal(), 4);
  EXPECT_EQ(report.dropped, 9u);
  EXPECT_EQ(report.small.holes, 9u);
  EXPECT_EQ(report.small.islands, 0u);
  EXPECT_NEAR(report.small.largest_area, 0.5, 1e-6);  // a diamond through the middles of a pixel's sides
}

TEST(SmallContours, ThatGoOnFromSliceToSliceAreToldWithTheirLongestRun) {
  const LevelReport report = report_of(block_with_canal(), 4);
  EXPECT_EQ(report.small.going_on, 8u);
  EXPECT_EQ(report.small.longest_run, 8u);
  EXPECT_EQ(report.small.run_slice, 0u);
  EXPECT_NEAR(report.small.run_at.x, 4, 1e-9);
  EXPECT_NEAR(report.small.run_at.y, 4, 1e-9);
  EXPECT_EQ(report_of(block_with_canal(), 0).small.going_on, 0u);
}

TEST(SmallContours, OfOneSliceAloneGoNowhere) {
  Volume volume = block_with_canal();
  for (std::size_t k = 0; k < 8; ++k) volume.values[k * 144 + 4 * 12 + 4] = 1;  // the canal filled
  const LevelReport report = report_of(volume, 4);
  EXPECT_EQ(report.dropped, 1u);
  EXPECT_EQ(report.small.going_on, 0u);
}

TEST(SmallContours, ThatEndAWiderCanalGoOnInWhatIsKept) {
  Volume volume = block_with_canal(false);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 3; j < 7; ++j)
      for (std::size_t i = 3; i < 7; ++i) volume.values[k * 144 + j * 12 + i] = 0;
  const LevelReport report = report_of(volume, 4);
  EXPECT_EQ(report.dropped, 4u);
  EXPECT_EQ(report.small.going_on, 4u);
}

/// A canal of one voxel that moves aside by one, in both directions, with each slice.
Volume aslant(std::size_t aside) {
  return volume_of({16, 16, 12}, [aside](std::size_t i, std::size_t j, std::size_t k) {
    if (i == 0 || j == 0 || i == 15 || j == 15) return 0;
    return i == 2 + aside * k && j == 2 + aside * k ? 0 : 1;
  });
}

TEST(SmallContours, ThatMeetAtCornersOnlyAreToldOf) {
  EXPECT_EQ(report_of(aslant(1), 0).pieces, 12u);
  EXPECT_EQ(report_of(aslant(0), 0).pieces, 0u);
  EXPECT_EQ(report_of(block_with_canal(), 0).pieces, 0u);
  // The same as a label of its own.
  Volume canal = aslant(1);
  for (std::size_t k = 0; k < 12; ++k) canal.values[k * 256 + (2 + k) * 16 + 2 + k] = 2;
  EXPECT_EQ(label_contours(canal, {{2, "canal"}}).levels.front().pieces, 12u);
}

}  // namespace
}  // namespace odontoscope::test
