// DICOM segmentations as label maps: each segment lies where its frames say, whatever their order, and whichever are
// left out.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "recon/core/error.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/volume_contours.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/segmentation_object.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

Volume read(const std::string& bytes, const ReadVolumeOptions& options = {}) {
  const TemporaryFolder folder;
  put(folder / "map.dcm", bytes);
  return read_volume((folder / "map.dcm").string(), options);
}

std::string cause_of(const std::string& bytes) {
  try {
    read(bytes);
    return "none";
  } catch (const InputError& error) {
    return error.cause();
  }
}

std::string place(double z) { return "10\\20\\" + std::to_string(z); }

/// Pixels of voxel (i, j) as SegmentFrame has them.
constexpr std::uint16_t row_of(int j, unsigned pixels) { return static_cast<std::uint16_t>(pixels << (4 * j)); }

/// Tooth in slices 30 to 36, pulp in two of them, disjoint.
SegmentationObject tooth_with_pulp() {
  SegmentationObject map;
  for (const double z : {30.0, 32.0, 34.0, 36.0})
    map.frames.push_back({1, place(z), static_cast<std::uint16_t>(row_of(0, 0xf) | row_of(1, 0x9))});
  map.frames.push_back({2, place(32), row_of(1, 0x6)});
  map.frames.push_back({2, place(34), row_of(1, 0x4)});
  return map;
}

bool has(const Volume& volume, std::int64_t label, std::size_t i, std::size_t j, std::size_t k) {
  return LabelValues(volume, label)(volume.slice(k)[j * volume.size[0] + i]);
}

void expect_tooth_with_pulp(const Volume& volume) {
  ASSERT_EQ(volume.size, (std::array<std::size_t, 3>{4, 3, 4}));
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{0.25, 0.5, 2}));
  EXPECT_EQ(volume.origin, (Point3{10, 20, 30}));
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        const bool pulp = j == 1 && ((k == 1 && (i == 1 || i == 2)) || (k == 2 && i == 2)),
                   tooth = j == 0 || (j == 1 && (i == 0 || i == 3));
        ASSERT_EQ(has(volume, 1, i, j, k), tooth) << i << " " << j << " " << k;
        ASSERT_EQ(has(volume, 2, i, j, k), pulp) << i << " " << j << " " << k;
      }
}

TEST(DicomSegmentations, LieWhereTheirFramesSayInAnyOrder) {
  SegmentationObject map = tooth_with_pulp();
  expect_tooth_with_pulp(read(map.bytes()));
  std::mt19937 random(1);
  for (int n = 0; n < 20; ++n) {
    std::shuffle(map.frames.begin(), map.frames.end(), random);
    expect_tooth_with_pulp(read(map.bytes()));
  }
}

TEST(DicomSegmentations, OfAnyCodingAndAlongAnyAxis) {
  SegmentationObject map = tooth_with_pulp();
  for (const DicomCoding coding :
       {DicomCoding::explicit_little, DicomCoding::implicit_little, DicomCoding::explicit_big, DicomCoding::deflated}) {
    map.coding = coding;
    for (const bool words : {false, true}) {  // of a big-endian file, words have their bytes the other way round
      map.words = words;
      expect_tooth_with_pulp(read(map.bytes()));
    }
  }
  SegmentationObject turned = tooth_with_pulp();
  turned.axes = "0\\1\\0\\1\\0\\0";  // rows along x, so that the normal runs down
  const Volume volume = read(turned.bytes());
  EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{3, 4, 4}));
  EXPECT_EQ(volume.origin, (Point3{10, 20, 30}));
  EXPECT_TRUE(has(volume, 2, 1, 1, 1) && has(volume, 2, 1, 2, 1) && has(volume, 2, 1, 2, 2) &&
              !has(volume, 2, 1, 1, 2));
}

TEST(DicomSegmentations, HaveTheNamesOfTheirSegments) {
  SegmentationObject map = tooth_with_pulp();
  map.character_set = "ISO_IR 100";
  map.segments = {{2, "H\xF6hle"}, {1, "Zahn"}};
  const Volume volume = read(map.bytes());
  ASSERT_EQ(volume.labels.size(), 2u);
  EXPECT_EQ(volume.labels[0].name, "Zahn");
  EXPECT_EQ(volume.labels[1].name, "H\xC3\xB6hle");
}

TEST(DicomSegmentations, ThatOverlapGiveEachSegmentAllOfItsVoxels) {
  SegmentationObject map = tooth_with_pulp();
  map.segments.emplace_back(7, "whole");
  for (const double z : {30.0, 32.0, 34.0, 36.0}) map.frames.push_back({7, place(z), 0xfff});
  map.frames[0].pixels = 0xfff;  // the tooth fills the lowest slice
  std::mt19937 random(2);
  std::vector<float> values;
  for (int n = 0; n < 6; ++n) {
    const Volume volume = read(map.bytes());
    ASSERT_EQ(volume.overlaps.size(), 2u);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 4; ++i) {
          ASSERT_TRUE(has(volume, 7, i, j, k));
          ASSERT_EQ(has(volume, 1, i, j, k), k == 0 || j == 0 || (j == 1 && (i == 0 || i == 3)));
          ASSERT_EQ(has(volume, 2, i, j, k), j == 1 && ((k == 1 && (i == 1 || i == 2)) || (k == 2 && i == 2)));
        }
    if (n > 0) {
      EXPECT_EQ(volume.values, values);
    }
    values = volume.values;
    std::shuffle(map.frames.begin(), map.frames.end(), random);
  }
}

TEST(DicomSegmentations, ThatOverlapAreContouredEachByItself) {
  SegmentationObject map;
  for (const double z : {30.0, 32.0}) {
    map.frames.push_back({1, place(z), 0xfff});
    map.frames.push_back({2, place(z), row_of(1, 0x6)});
  }
  const Volume volume = read(map.bytes());
  VolumeContourOptions options;
  options.labels = {{1, "tooth"}, {2, "pulp"}};
  const ContourStack stack = contours_of_volume(volume, options).stack;
  ASSERT_EQ(stack.slices.size(), 2u);
  for (const Slice& slice : stack.slices) {
    ASSERT_EQ(slice.contours.size(), 2u);  // one outline each: the tooth has no hole where the pulp is
    EXPECT_EQ(slice.contours[0].structure, "tooth");
    EXPECT_EQ(slice.contours[1].structure, "pulp");
  }
  options.smooth = SmoothLabelsOptions{0.1};
  EXPECT_THROW(contours_of_volume(volume, options), UsageError);
}

TEST(DicomSegmentations, LeaveOutEmptyFrames) {
  SegmentationObject map = tooth_with_pulp();
  std::erase_if(map.frames, [](const SegmentFrame& frame) { return frame.position == place(34); });
  const Volume volume = read(map.bytes());
  ASSERT_EQ(volume.size[2], 4u);
  EXPECT_EQ(volume.spacing[2], 2);
  EXPECT_TRUE(std::all_of(volume.slice(2), volume.slice(3), [](float value) { return value == 0; }));
  EXPECT_TRUE(has(volume, 1, 0, 0, 3));
  EXPECT_TRUE(std::any_of(volume.remarks.begin(), volume.remarks.end(), [](const std::string& r) {
    return r.find("1 slice between its frames has none") != r.npos || r.find("1 slice between") != r.npos;
  }));
}

TEST(DicomSegmentations, TakeTheDistanceThatTheirFramesHave) {
  SegmentationObject map = tooth_with_pulp();
  for (const char* told : {"2", "", "1", "0.5", "0.7"}) {  // "1": drawn in every second slice, not in thin plates
    map.slice_spacing = told;
    expect_tooth_with_pulp(read(map.bytes()));
  }
  map.frames[1].position = place(32.9);
  map.frames[4].position = place(32.9);
  EXPECT_EQ(cause_of(map.bytes()), "uneven-slices");
}

TEST(DicomSegmentations, OfPositionsThatAreRounded) {
  SegmentationObject map;
  map.slice_spacing = "0.333";
  for (const char* z : {"0", "0.3", "0.7", "1", "1.3", "1.7", "2"})
    map.frames.push_back({1, std::string("0\\0\\") + z, 0xfff});
  const Volume volume = read(map.bytes());
  EXPECT_EQ(volume.size[2], 7u);
  EXPECT_NEAR(volume.spacing[2], 1.0 / 3, 0.01);
}

TEST(DicomSegmentations, ThatAreFractionalAreTakenFromHalfOn) {
  SegmentationObject map;
  map.kind = "FRACTIONAL";
  map.fraction_of = 100;
  for (const double z : {30.0, 32.0}) map.frames.push_back({1, place(z), 0, {0, 49, 50, 100, 0, 0, 0, 0, 0, 0, 0, 51}});
  const Volume volume = read(map.bytes());
  EXPECT_EQ(std::vector<float>(volume.slice(0), volume.slice(1)),
            (std::vector<float>{0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_NE(volume.remarks.back().find("at least half"), std::string::npos);
}

TEST(DicomSegmentations, MayBeMapsOfNumbers) {
  SegmentationObject map;
  map.kind = "LABELMAP";
  map.coding = DicomCoding::explicit_big;
  map.words = true;  // bytes in words of a big-endian file
  for (const double z : {32.0, 30.0})
    map.frames.push_back(
        {0, place(z), 0, {0, 1, 2, 2, 0, 0, 0, 0, 0, 0, 0, static_cast<std::uint8_t>(z == 30 ? 1 : 2)}});
  const Volume volume = read(map.bytes());
  EXPECT_EQ(std::vector<float>(volume.slice(0), volume.slice(1)),
            (std::vector<float>{0, 1, 2, 2, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(volume.slice(1)[11], 2);
  ASSERT_EQ(volume.labels.size(), 2u);
  EXPECT_EQ(volume.labels[1].name, "pulp");
}

TEST(DicomSegmentations, OfOneSegmentMayTellItOnce) {
  SegmentationObject map = tooth_with_pulp();
  map.frames.resize(4);
  map.shared_segment = true;
  EXPECT_TRUE(has(read(map.bytes()), 1, 0, 0, 3));
}

TEST(DicomSegmentations, NameTheSeriesThatTheyWereMadeOn) {
  SegmentationObject map = tooth_with_pulp();
  map.refers = true;
  const Volume volume = read(map.bytes());
  ASSERT_TRUE(volume.patient.dicom);
  EXPECT_EQ(volume.patient.dicom->series, "1.2.3.4");
  ASSERT_EQ(volume.patient.dicom->instances.size(), 2u);
  EXPECT_EQ(volume.patient.dicom->instances[0].uid, "1.2.3.4.1");
}

TEST(DicomSegmentations, ThatSayTooLittleOrLieAreRefused) {
  SegmentationObject map = tooth_with_pulp();
  map.frames[2].segment = 0;
  EXPECT_EQ(cause_of(map.bytes()), "unreadable-volume");
  map = tooth_with_pulp();
  map.has_places = false;
  EXPECT_EQ(cause_of(map.bytes()), "no-positions");
  map = tooth_with_pulp();
  map.frames[1].position = place(30);  // twice in one place
  EXPECT_EQ(cause_of(map.bytes()), "time-series");
  map = tooth_with_pulp();
  map.frames[4].position = "11\\20\\32";  // a tile beside another
  EXPECT_EQ(cause_of(map.bytes()), "sheared-volume");
  map = tooth_with_pulp();
  map.frames.resize(1);
  EXPECT_EQ(cause_of(map.bytes()), "single-slice");
  map = tooth_with_pulp();
  map.segments = {{1, "tooth"}, {1, "pulp"}};
  EXPECT_EQ(cause_of(map.bytes()), "unreadable-volume");
  map = tooth_with_pulp();
  map.frames[3].position = place(900000);  // a gap that would fill memory
  EXPECT_EQ(cause_of(map.bytes()), "uneven-slices");
}

/// 13 segments in every combination of a slice's 12 pixels and more: more ways to overlap than are kept.
TEST(DicomSegmentations, ThatOverlapInTooManyWaysAreRefused) {
  SegmentationObject map;
  map.segments.clear();
  std::mt19937 random(3);
  for (int slice = 0; slice < 400; ++slice)
    for (std::uint16_t segment = 1; segment <= 14; ++segment)
      map.frames.push_back({segment, place(2.0 * slice), static_cast<std::uint16_t>(random() & 0xfff)});
  EXPECT_EQ(cause_of(map.bytes()), "too-many-structures");
}

TEST(DicomSegmentations, BesideOthersAreReadAlone) {
  const TemporaryFolder folder;
  SegmentationObject map = tooth_with_pulp(), other = tooth_with_pulp();
  other.instance = "1.2.3.9.2";
  other.frames = {{1, place(0), 0xfff}, {1, place(2), 0xfff}};
  put(folder / "a.dcm", map.bytes());
  put(folder / "b.dcm", other.bytes());
  expect_tooth_with_pulp(read_volume((folder / "a.dcm").string()));
  try {
    read_volume(folder.path().string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("segments tooth (1), pulp (2)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace odontoscope::test
