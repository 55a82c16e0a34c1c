// Contours to DICOM structure sets, and back by our own reader.

#include <gtest/gtest.h>

#include <cmath>

#include "recon/exchange/read_rtstruct.h"
#include "recon/input/validate.h"
#include "recon/segmentation/write_rtstruct.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/volume_contours.h"
#include "tests/output/temporary_folder.h"
#include "tests/segmentation/made.h"

namespace odontoscope {
namespace {

using testing_support::TemporaryFolder;

/// Each contour from its least point on, in the order of those.
std::vector<Contour> normalised(const Slice& slice) {
  const auto less = [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::vector<Contour> contours = slice.contours;
  for (Contour& contour : contours) {
    if (made::signed_area(contour.points) < 0) std::reverse(contour.points.begin(), contour.points.end());
    std::rotate(contour.points.begin(), std::min_element(contour.points.begin(), contour.points.end(), less),
                contour.points.end());
  }
  std::sort(contours.begin(), contours.end(), [&](const Contour& a, const Contour& b) {
    return a.structure != b.structure ? a.structure < b.structure : less(a.points.front(), b.points.front());
  });
  return contours;
}

void expect_same(const ContourStack& read, const ContourStack& written, double tolerance) {
  ASSERT_EQ(read.slices.size(), written.slices.size());
  for (std::size_t s = 0; s < read.slices.size(); ++s) {
    EXPECT_NEAR(read.slices[s].z, written.slices[s].z, tolerance);
    const auto a = normalised(read.slices[s]), b = normalised(written.slices[s]);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t c = 0; c < a.size(); ++c) {
      EXPECT_EQ(a[c].structure, b[c].structure);
      ASSERT_EQ(a[c].points.size(), b[c].points.size());
      for (std::size_t p = 0; p < a[c].points.size(); ++p) {
        EXPECT_NEAR(a[c].points[p].x, b[c].points[p].x, tolerance);
        EXPECT_NEAR(a[c].points[p].y, b[c].points[p].y, tolerance);
      }
    }
  }
}

TEST(WrittenRtstruct, GivesTheSameContoursBack) {
  const ContourStack stack = made::tooth();
  const FileContours read = parse_rtstruct(rtstruct_bytes(stack, {}), "a.dcm");
  EXPECT_NO_THROW(validate(read.stack));  // keyholes were parted
  expect_same(read.stack, stack, 1e-12);
  EXPECT_EQ(structures_of(read.stack), structures_of(stack));
  for (std::size_t s = 0; s < 3; ++s)
    for (const std::string name : {"enamel", "dentine", "pulp"})
      EXPECT_NEAR(made::area(read.stack.slices[s], name), made::area(stack.slices[s], name), 1e-9);
}

TEST(WrittenRtstruct, HasTheSameBytesEachTime) {
  EXPECT_EQ(rtstruct_bytes(made::tooth(), {}), rtstruct_bytes(made::tooth(), {}));
  ContourStack other = made::tooth();
  other.slices[0].contours[0].points[0].x += 1e-6;
  EXPECT_NE(rtstruct_bytes(other, {}).substr(0, 600), rtstruct_bytes(made::tooth(), {}).substr(0, 600));  // identifiers
}

TEST(WrittenRtstruct, HoldsContoursOfAnyLength) {
  ContourStack stack = made::tooth();  // 16 bits of length end at some thousand points
  for (Slice& slice : stack.slices) slice.contours[0].points = made::polygon(20'000, 6);
  expect_same(parse_rtstruct(rtstruct_bytes(stack, {}), "a.dcm").stack, stack, 1e-12);
}

TEST(WrittenRtstruct, KeepsNamesInUtf8) {
  ContourStack stack = made::tooth();
  for (Slice& slice : stack.slices) slice.contours.back().structure = "Zahnhöhle 歯";
  const FileContours read = parse_rtstruct(rtstruct_bytes(stack, {}), "a.dcm");
  EXPECT_EQ(structures_of(read.stack).back(), "Zahnhöhle 歯");
  std::string longer;
  for (int n = 0; n < 66; ++n) longer += "é";  // 66 characters, two more than a name may have
  for (Slice& slice : stack.slices) slice.contours.back().structure = longer;
  EXPECT_EQ(structures_of(parse_rtstruct(rtstruct_bytes(stack, {}), "a.dcm").stack).back(), longer.substr(0, 128));
}

TEST(WrittenRtstruct, RefersToTheSeries) {
  const TemporaryFolder folder;
  made::Series{}.write(folder.path());
  const Volume volume = read_volume(folder.path().string());
  ASSERT_TRUE(volume.patient.dicom);
  EXPECT_EQ(volume.patient.dicom->instances.size(), 4u);
  VolumeContourOptions options;
  options.isos = {{50, "tooth"}};
  const ContourStack stack = contours_of_volume(volume, options).stack;
  const FileContours read = parse_rtstruct(rtstruct_bytes(stack, volume.patient), "a.dcm");
  expect_same(read.stack, stack, 1e-9);
  ASSERT_TRUE(read.patient.dicom);
  const DicomOrigin& origin = *read.patient.dicom;
  EXPECT_EQ(origin.identity.at(0x00100010), "Doe^Jane");
  EXPECT_EQ(origin.identity.at(0x00100020), "0815");
  EXPECT_EQ(origin.identity.at(0x00080050), "A1");
  EXPECT_EQ(origin.study, "1.2.3");
  EXPECT_EQ(origin.series, "1.2.3.4");
  EXPECT_EQ(origin.frame_of_reference, "1.2.3.99");
  ASSERT_EQ(origin.instances.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(origin.instances[k].uid, "1.2.3.4." + std::to_string(k + 1));
    EXPECT_EQ(origin.instances[k].class_uid, "1.2.840.10008.5.1.4.1.1.2");
    EXPECT_NEAR((*origin.instances[k].position)[2], 20.0 + static_cast<double>(k), 1e-9);
  }
  // And once more, of what was read: the same patient, study and images.
  const FileContours again = parse_rtstruct(rtstruct_bytes(read.stack, read.patient), "b.dcm");
  EXPECT_EQ(again.patient.dicom->identity, origin.identity);
  EXPECT_EQ(again.patient.dicom->series, origin.series);
  EXPECT_EQ(again.patient.dicom->instances.size(), 4u);
}

TEST(WrittenRtstruct, OfATiltedSeriesLiesWhereThePatientDoes) {
  const TemporaryFolder folder;
  made::Series series;
  series.orientation = "1\\0\\0\\0\\0.8\\0.6";  // rows turned by 36.87 degrees about x
  series.write(folder.path());
  const Volume volume = read_volume(folder.path().string());
  EXPECT_NEAR(volume.tilt_degrees, 36.87, 0.01);
  VolumeContourOptions options;
  options.isos = {{50, "tooth"}};
  const ContourStack stack = contours_of_volume(volume, options).stack;
  const FileContours read = parse_rtstruct(rtstruct_bytes(stack, volume.patient), "a.dcm");
  ASSERT_EQ(read.stack.slices.size(), stack.slices.size());
  EXPECT_NEAR(read.patient.frame.axes[2][1], -0.6, 1e-6);
  EXPECT_EQ(read.patient.dicom->instances.size(), 4u);
  // A corner of the block, by the header alone: column 3, row 2 of the first image, half a pixel before them.
  double nearest = 1e9;
  for (const Contour& contour : read.stack.slices[0].contours) {
    for (const Point2& p : contour.points) {
      const Point3 at = read.patient.frame.in_patient({p.x, p.y, read.stack.slices[0].z});
      nearest = std::min(
          nearest, std::hypot(at.x - (-3 + 2.5 * 0.5), at.y - (4 + 2 * 0.25 * 0.8), at.z - (20 + 2 * 0.25 * 0.6)));
    }
  }
  EXPECT_LT(nearest, 1e-6);
}

TEST(WrittenRtstruct, TextOfOthersIsTamed) {
  const TemporaryFolder folder;
  made::Series series;
  series.patient = "M\xfcller^\x01J\\\\x";
  series.character_set = "ISO_IR 100";
  series.write(folder.path());
  const Volume volume = read_volume(folder.path().string());
  const FileContours read = parse_rtstruct(rtstruct_bytes(made::tooth(), volume.patient), "a.dcm");
  EXPECT_EQ(read.patient.dicom->identity.at(0x00100010), "Müller^?J//x");
  EXPECT_EQ(read.patient.dicom->character_set, "ISO_IR 192");
}

}  // namespace
}  // namespace odontoscope
