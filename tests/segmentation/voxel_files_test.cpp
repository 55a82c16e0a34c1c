// Voxels to label maps and back by our own reader; segmentation images as far as our own reader of DICOM goes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "recon/core/error.h"
#include "recon/segmentation/rasterise.h"
#include "recon/segmentation/segment_look.h"
#include "recon/segmentation/structures_file.h"
#include "recon/segmentation/write_label_map.h"
#include "recon/segmentation/write_seg.h"
#include "recon/volume/dicom_file.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/volume_contours.h"
#include "tests/output/temporary_folder.h"
#include "tests/segmentation/made.h"

namespace odontoscope {
namespace {

using testing_support::TemporaryFolder;

Volume read_back(const TemporaryFolder& folder, const std::string& bytes) {
  const std::string file = (folder / "map.seg.nrrd").string();
  std::ofstream(file, std::ios::binary) << bytes;
  return read_volume(file);
}

VoxelGrid grid_of(const Volume& volume) { return {volume.size, volume.spacing, volume.origin}; }

std::string text_of(const ContourStack& stack) {
  std::ostringstream text;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) {
      text << contour.structure << ' ' << slice.z;
      for (const Point2& p : contour.points) text << ' ' << p.x << ',' << p.y;
    }
  return text.str();
}

TEST(WrittenLabelMap, ComesBackVoxelByVoxelWithItsNames) {
  const TemporaryFolder folder;
  const ContourStack stack = made::tooth();
  const Segmentation voxels = rasterised(stack, grid_of_slices(stack, 0.2, 0.25));
  EXPECT_EQ(overlapping_voxels(voxels), 0u);  // enamel and dentine share a border
  const Volume read = read_back(folder, label_map_bytes(voxels, {}));
  ASSERT_EQ(read.size, voxels.grid.size);
  EXPECT_EQ(read.origin, voxels.grid.origin);
  EXPECT_EQ(read.spacing, voxels.grid.spacing);
  ASSERT_EQ(read.labels.size(), 3u);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(read.labels[s].value, static_cast<std::int64_t>(s + 1));
    EXPECT_EQ(read.labels[s].name, voxels.segments[s].name);
  }
  std::size_t at = 0, differ = 0;
  for (std::size_t k = 0; k < read.size[2]; ++k)
    for (std::size_t j = 0; j < read.size[1]; ++j)
      for (std::size_t i = 0; i < read.size[0]; ++i, ++at)
        for (std::size_t s = 0; s < 3; ++s)
          differ += voxels.segments[s].voxels.at(i, j, k) != (read.values[at] == static_cast<float>(s + 1));
  EXPECT_EQ(differ, 0u);
}

TEST(WrittenLabelMap, OfALabelMapsContoursIsThatLabelMap) {
  const TemporaryFolder folder;
  const ContourStack stack = made::tooth();
  const Volume first = read_back(folder, label_map_bytes(rasterised(stack, grid_of_slices(stack, 0.21, 0.21)), {}));
  VolumeContourOptions options;
  options.labels = {{1, "enamel"}, {2, "dentine"}, {3, "pulp"}};
  const ContourStack contours = contours_of_volume(first, options).stack;
  const Volume second = read_back(folder, label_map_bytes(rasterised(contours, grid_of(first)), {}));
  EXPECT_EQ(second.values, first.values);
  EXPECT_EQ(text_of(contours_of_volume(second, options).stack), text_of(contours));
}

TEST(WrittenLabelMap, OfAnImageIsItsThreshold) {
  Volume image;
  image.size = {23, 19, 4};
  image.spacing = {0.3, 0.2, 0.7};
  image.origin = {-3.3, 7.1, 100.05};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 19; ++j)
      for (std::size_t i = 0; i < 23; ++i) {
        const bool border = i == 0 || j == 0 || i == 22 || j == 18;
        image.values.push_back(border ? 0.0f : static_cast<float>((i * 31 + j * 17 + k * 7 + i * j) % 40));
      }
  VolumeContourOptions options;
  options.isos = {{20, "tooth"}};
  const Segmentation voxels = rasterised(contours_of_volume(image, options).stack, grid_of(image));
  std::size_t at = 0, differ = 0;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 19; ++j)
      for (std::size_t i = 0; i < 23; ++i)
        differ += voxels.segments[0].voxels.at(i, j, k) != (image.values[at++] >= 20);
  EXPECT_EQ(differ, 0u);
}

TEST(WrittenLabelMap, LiesTurnedInThePatient) {
  const TemporaryFolder folder;
  made::Series series;
  series.orientation = "1\\0\\0\\0\\0.8\\0.6";
  series.write(folder / "series");
  const Volume image = read_volume((folder / "series").string());
  VolumeContourOptions options;
  options.isos = {{50, "tooth"}};
  const ContourStack stack = contours_of_volume(image, options).stack;
  const Volume map = read_back(folder, label_map_bytes(rasterised(stack, grid_of(image)), image.patient.frame));
  EXPECT_NEAR(map.tilt_degrees, image.tilt_degrees, 1e-6);
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t x = 0; x < 3; ++x) EXPECT_NEAR(map.patient.frame.axes[n][x], image.patient.frame.axes[n][x], 1e-9);
  const Point3 a = map.patient.frame.in_patient(map.origin), b = image.patient.frame.in_patient(image.origin);
  EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 0, 1e-9);
  ASSERT_EQ(map.values.size(), image.values.size());
  for (std::size_t n = 0; n < map.values.size(); ++n) ASSERT_EQ(map.values[n] == 1, image.values[n] >= 50) << n;
}

TEST(WrittenLabelMap, GivesOverlapsToTheLast) {
  ContourStack stack = made::tooth();
  for (Slice& slice : stack.slices) slice.contours.push_back({"filling", made::polygon(30, 2, {2, 0})});
  const Segmentation voxels = rasterised(stack, grid_of_slices(stack, 0.2, 0.2));
  EXPECT_GT(overlapping_voxels(voxels), 100u);
  const TemporaryFolder folder;
  const Volume read = read_back(folder, label_map_bytes(voxels, {}));
  EXPECT_EQ(static_cast<std::size_t>(std::count(read.values.begin(), read.values.end(), 4.0f)),
            voxels.segments[3].voxels.count());
}

TEST(WrittenLabelMap, OfManySegmentsIsWider) {
  Segmentation many{{{4, 4, 2}, {1, 1, 1}, {}}, {}};
  for (int s = 0; s < 300; ++s) many.segments.push_back({fmt::format("s{}", s), VoxelBits(many.grid.size)});
  many.segments[299].voxels.toggle(2, 1, 1);
  const TemporaryFolder folder;
  const Volume read = read_back(folder, label_map_bytes(many, {}));
  EXPECT_EQ(read.values[16 + 4 + 2], 300.0f);
  EXPECT_EQ(read.labels.size(), 300u);
}

DicomFile seg_of(const TemporaryFolder& folder, const std::string& bytes) {
  const std::string file = (folder / "a.seg.dcm").string();
  std::ofstream(file, std::ios::binary) << bytes;
  return read_dicom_file(file);
}

TEST(WrittenSeg, HoldsAFrameForEachSegmentAndSlice) {
  const TemporaryFolder folder;
  const ContourStack stack = made::tooth();
  const Segmentation voxels = rasterised(stack, grid_of_slices(stack, 0.2, 0.2));
  const std::string bytes = seg_bytes(voxels, {});
  const DicomFile file = seg_of(folder, bytes);
  EXPECT_FALSE(file.trouble.has_value());
  EXPECT_EQ(file.data.number(dicom::frames), 9.0);
  EXPECT_EQ(file.data.number(dicom::columns), static_cast<double>(voxels.grid.size[0]));
  EXPECT_EQ(file.pixels.length, (9 * voxels.grid.size[0] * voxels.grid.size[1] + 7) / 8 +
                                    ((9 * voxels.grid.size[0] * voxels.grid.size[1] + 7) / 8) % 2);
  EXPECT_EQ(file.data.find(dicom::frame_groups)->items.size(), 9u);
  // The bits themselves, frame by frame.
  std::size_t bit = 0, differ = 0;
  for (const Segment& segment : voxels.segments)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < voxels.grid.size[1]; ++j)
        for (std::size_t i = 0; i < voxels.grid.size[0]; ++i, ++bit) {
          differ += ((bytes[file.pixels.at + bit / 8] >> (bit % 8) & 1) != 0) != segment.voxels.at(i, j, k);
        }
  EXPECT_EQ(differ, 0u);
  EXPECT_EQ(seg_bytes(voxels, {}), bytes);
}

/// Voxels that a segmentation has and the volume does not give to the label of that name, or the reverse.
std::size_t differing(const Segmentation& voxels, const Volume& read) {
  std::size_t differ = 0;
  for (std::size_t s = 0; s < voxels.segments.size(); ++s) {
    const LabelValues is_label(read, static_cast<std::int64_t>(s + 1));
    std::size_t at = 0;
    for (std::size_t k = 0; k < read.size[2]; ++k)
      for (std::size_t j = 0; j < read.size[1]; ++j)
        for (std::size_t i = 0; i < read.size[0]; ++i, ++at)
          differ += voxels.segments[s].voxels.at(i, j, k) != is_label(read.values[at]);
  }
  return differ;
}

TEST(WrittenSeg, ComesBackVoxelByVoxelWithItsNames) {
  const TemporaryFolder folder;
  ContourStack stack = made::tooth();
  for (const bool overlaps : {false, true}) {
    if (overlaps) {
      for (Slice& slice : stack.slices) slice.contours.push_back({"filling", made::polygon(30, 2, {2, 0})});
    }
    const Segmentation voxels = rasterised(stack, grid_of_slices(stack, 0.2, 0.25));
    const std::string file = (folder / "a.seg.dcm").string();
    std::ofstream(file, std::ios::binary) << seg_bytes(voxels, {});
    const Volume read = read_volume(file);
    ASSERT_EQ(read.size, voxels.grid.size);
    EXPECT_EQ(read.spacing, voxels.grid.spacing);
    EXPECT_EQ(read.origin, voxels.grid.origin);
    ASSERT_EQ(read.labels.size(), voxels.segments.size());
    for (std::size_t s = 0; s < voxels.segments.size(); ++s) EXPECT_EQ(read.labels[s].name, voxels.segments[s].name);
    EXPECT_EQ(read.overlaps.empty(), !overlaps);
    EXPECT_EQ(differing(voxels, read), 0u);
  }
}

/// Slices without any voxel, at the ends and between, are no frames.
TEST(WrittenSeg, ComesBackTurnedAndWithoutItsEmptySlices) {
  const TemporaryFolder folder;
  Segmentation voxels{{{5, 4, 7}, {0.25, 0.5, 0.5}, {3, 4, 5}}, {}};
  for (const char* name : {"dentine", "pulp"}) voxels.segments.push_back({name, VoxelBits(voxels.grid.size)});
  for (const std::size_t k : {1, 2, 5}) voxels.segments[0].voxels.toggle(k - 1, 2, k);
  voxels.segments[1].voxels.toggle(4, 3, 2);
  PatientOrigin origin;
  origin.frame = {{{{1, 0, 0}, {0, 0.8, 0.6}, {0, -0.6, 0.8}}}, {1, 2, 3}};
  const std::string file = (folder / "a.seg.dcm").string();
  std::ofstream(file, std::ios::binary) << seg_bytes(voxels, origin);
  const Volume read = read_volume(file);
  EXPECT_EQ(read.size, (std::array<std::size_t, 3>{5, 4, 5}));
  std::size_t set = 0;
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 5; ++i) {
        const float value = read.slice(k)[j * 5 + i];
        if (value == 0) continue;
        ++set;
        EXPECT_TRUE(voxels.segments[static_cast<std::size_t>(value) - 1].voxels.at(i, j, k + 1))
            << i << " " << j << " " << k;
        const Point3 here{read.origin.x + double(i) * read.spacing[0], read.origin.y + double(j) * read.spacing[1],
                          read.origin.z + double(k) * read.spacing[2]};
        const Point3 a = read.patient.frame.in_patient(here),
                     b = origin.frame.in_patient({voxels.grid.x(i), voxels.grid.y(j), voxels.grid.z(k + 1)});
        EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 0, 1e-9);
      }
  EXPECT_EQ(set, 4u);
}

TEST(WrittenSeg, RefusesWhatHasNoVoxel) {
  const ContourStack stack = made::tooth();
  EXPECT_THROW(seg_bytes(rasterised(stack, {{3, 3, 3}, {1, 1, 0.5}, {50, 50, 0.5}}), {}), UsageError);
}

TEST(SegmentLooks, TellToothEnamelDentineAndPulp) {
  EXPECT_EQ(look_of("Tooth 36", 0).type.value, "38199008");
  EXPECT_EQ(look_of("dentine+pulp", 0).type.value, "DENTINE");
  EXPECT_EQ(look_of("Pulp of tooth", 0).type.value, "PULP");
  EXPECT_EQ(look_of("ENAMEL", 0).region->value, "38199008");
  EXPECT_EQ(look_of("label-3", 0).type.value, "123037004");
  EXPECT_NE(look_of("a", 0).colour, look_of("b", 1).colour);
}

TEST(SegmentLooks, HaveTheColoursOfDicom) {
  EXPECT_EQ(cie_lab({255, 255, 255})[0], 65535);
  EXPECT_NEAR(cie_lab({255, 255, 255})[1], 0x8080, 8);
  EXPECT_EQ(cie_lab({0, 0, 0})[0], 0);
  // Red of sRGB under D50: L 54.29, a 80.81, b 69.89 (B. Lindbloom's tables).
  const auto red = cie_lab({255, 0, 0});
  EXPECT_NEAR(red[0] / 655.35, 54.29, 0.02);
  EXPECT_NEAR(red[1] / 257.0 - 128, 80.81, 0.02);
  EXPECT_NEAR(red[2] / 257.0 - 128, 69.89, 0.02);
}

TEST(StructureFiles, AreToldByTheirEndings) {
  EXPECT_EQ(structures_format("a/b.SEG.DCM"), StructuresFormat::seg);
  EXPECT_EQ(structures_format("b.dcm"), StructuresFormat::rtstruct);
  EXPECT_EQ(structures_format("b.seg.nrrd"), StructuresFormat::label_map);
  EXPECT_EQ(structures_format("b.nrrd"), StructuresFormat::label_map);
  EXPECT_FALSE(structures_format("b.json"));
}

}  // namespace
}  // namespace odontoscope
