// DICOM structure sets: what is right is read, what is wrong is named, and nothing ends otherwise.

#include <gtest/gtest.h>

#include <cmath>

#include "recon/exchange/contour_file.h"
#include "recon/exchange/read_rtstruct.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/validate.h"
#include "tests/exchange/made_files.h"
#include "tests/exchange/refusals.h"

namespace odontoscope {
namespace {

made::RoiContour square(double z, double side = 4) {
  return {.data = made::square(0, 0, z, side), .count = "4", .type = "CLOSED_PLANAR"};
}

TEST(Rtstruct, PlanesComeInOrderAndTypesAreToldApart) {
  const std::string bytes =
      made::rtstruct({{"Heart", {square(6), square(0), square(3), {.data = "1\\1\\3", .count = "1", .type = "POINT"}}},
                      {"Lung", {square(3.0004, 2), square(9)}},
                      {"Lung", {square(0)}}});
  ASSERT_EQ(contour_file_kind(bytes), ContourFileKind::rtstruct);
  const FileContours read = parse_rtstruct(bytes, "file");
  ASSERT_EQ(read.stack.slices.size(), 4u);
  for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(read.stack.slices[s].z, 3.0 * static_cast<double>(s));
  EXPECT_EQ(read.stack.slices[1].contours.size(), 2u);  // 0.4 micrometres apart: one plane
  EXPECT_EQ(structures_of(read.stack), (std::vector<std::string>{"Heart", "Lung (2)", "Lung"}));
  ASSERT_EQ(read.remarks.size(), 2u);
  EXPECT_EQ(read.remarks[0], "Heart: 1 of type POINT left out");
  EXPECT_NE(read.remarks[1].find("Lung: nothing on 1 planes"), std::string::npos) << read.remarks[1];
  const FileContours lung = parse_rtstruct(bytes, "file", {"Lung"});
  EXPECT_EQ(lung.stack.slices.size(), 2u);  // only its own planes
  EXPECT_TRUE(lung.remarks.empty());
}

TEST(Rtstruct, PlanesAcrossAnotherAxis) {
  const std::string sagittal =
      made::rtstruct({{"Heart",
                       {{.data = "5\\0\\0\\5\\4\\0\\5\\4\\3", .count = "3", .type = "CLOSED_PLANAR"},
                        {.data = "7\\0\\0\\7\\4\\0\\7\\4\\3", .count = "3", .type = "CLOSED_PLANAR"}}}});
  const FileContours read = parse_rtstruct(sagittal, "file");
  EXPECT_EQ(read.stack.slices.at(1).z, 7);
  EXPECT_EQ(read.stack.slices[1].contours.at(0).points[2], (Point2{4, 3}));
}

TEST(Rtstruct, AKeyholeIsPartedAndSaid) {
  const std::string keyhole =
      "0\\0\\0\\8\\0\\0\\8\\8\\0\\0\\8\\0\\0\\4\\0\\2\\4\\0\\2\\6\\0\\6\\6\\0\\6\\2\\0\\2\\2\\0\\2\\4\\0\\0\\4\\0";
  const FileContours read =
      parse_rtstruct(made::rtstruct({{"Heart", {{keyhole, "12", "CLOSED_PLANAR"}, square(3, 8)}}}), "file");
  EXPECT_NO_THROW(validate(read.stack));
  ASSERT_EQ(read.stack.slices[0].contours.size(), 2u);
  EXPECT_EQ(read.stack.slices[0].contours[0].points.size(), 5u);  // the bridge began in a point of its own
  EXPECT_EQ(read.stack.slices[0].contours[1].points.size(), 5u);
  ASSERT_FALSE(read.remarks.empty());
  EXPECT_NE(read.remarks[0].find("1 contour that goes along a bridge"), std::string::npos) << read.remarks[0];
}

TEST(Rtstruct, WrongFilesAreNamed) {
  EXPECT_EQ(set_cause(made::rtstruct({})), "unreadable-structure-set");
  EXPECT_EQ(set_cause(std::string(200, 'x')), "unreadable-structure-set");
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {square(0)}}}), {"Spleen"}), "unknown-structure");
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {square(0)}}, {"Skin", {}}}), {"Skin"}), "unknown-structure");
  made::RoiContour wrong = square(0);
  wrong.count = "5";
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {wrong}}})), "wrong-count");
  wrong = square(0);
  wrong.data += "\\7";
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {wrong}}})), "wrong-count");
  wrong = square(0);
  wrong.data = replaced(wrong.data, "4", "x");
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {wrong}}})), "unparsable");
  wrong.data = "0\\0\\0\\4\\0\\0\\4\\4\\1\\0\\4\\inf";
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {wrong}}})), "not-finite");
  wrong.data = "0\\0\\0\\4\\0\\0\\4\\4\\1\\0\\4\\2";
  EXPECT_EQ(set_cause(made::rtstruct({{"Heart", {wrong}}})), "not-parallel");
  std::string other = made::rtstruct({{"Heart", {square(0)}}});
  for (int i = 0; i < 2; ++i) other = replaced(other, "481.3", "481.5");
  EXPECT_TRUE(contour_file_kind(other)) << "the modality still says it";
  EXPECT_FALSE(contour_file_kind(replaced(other, "RTSTRUCT", "RTPLAN  ")));
}

TEST(Rtstruct, TruncatedAnywhereItIsNamed) {
  const std::string bytes = made::rtstruct({{"Heart", {square(0), square(3)}}});
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const std::string cause = set_cause(bytes.substr(0, n));
    EXPECT_TRUE(cause == "truncated" || cause == "unreadable-structure-set" ||
                (cause == "accepted" && n > bytes.size() / 3))
        << n << cause;
  }
}

TEST(Rtstruct, AnyByteMayBeWrong) {
  const std::string bytes = made::rtstruct({{"Heart", {square(0), square(3)}}});
  for (std::size_t at = 132; at < bytes.size(); ++at) {
    for (const char wrong : {'\0', '\xff', '\x7f', '\xfe', 'A'}) {
      std::string changed = bytes;
      changed[at] = wrong;
      EXPECT_NO_THROW(cause_of([&] { parse_rtstruct(changed, "file"); })) << at;
    }
  }
}

TEST(Rtstruct, SequencesWithoutLengthAndImplicitCoding) {
  const auto tag = [](std::uint32_t group, std::uint32_t element) {
    std::string bytes;
    for (const std::uint32_t half : {group, element})
      bytes += {static_cast<char>(half & 0xff), static_cast<char>(half >> 8)};
    return bytes;
  };
  const std::string open("\xff\xff\xff\xff", 4), none(4, '\0');
  const std::string item = tag(0xfffe, 0xe000) + open, item_end = tag(0xfffe, 0xe00d) + none,
                    end = tag(0xfffe, 0xe0dd) + none;
  const auto plain = [&](std::uint32_t element, std::string value) {
    if (value.size() % 2 != 0) value += ' ';
    return tag(0x3006, element) + std::string{static_cast<char>(value.size()), '\0', '\0', '\0'} + value;
  };
  const std::string contour =
      item + plain(0x42, "CLOSED_PLANAR") + plain(0x46, "3") + plain(0x50, "0\\0\\1\\4\\0\\1\\4\\4\\1") + item_end;
  std::string bytes = made::rtstruct({});
  bytes.resize(bytes.find("RTSTRUCT") + 8);
  const std::size_t syntax = bytes.find("1.2.840.10008.1.2.1");
  bytes.replace(syntax, 20, std::string("1.2.840.10008.1.2\0\0\0", 20));
  bytes.resize(syntax + 20);  // the class again, implicit
  bytes += tag(8, 0x16) + std::string("\x1e\0\0\0", 4) + std::string("1.2.840.10008.5.1.4.1.1.481.3\0", 30);
  bytes += tag(0x3006, 0x20) + open + item + plain(0x22, "7") + plain(0x26, "Heart") + item_end + end;
  bytes +=
      tag(0x3006, 0x39) + open + item + tag(0x3006, 0x40) + open + contour + end + plain(0x84, "7") + item_end + end;
  ASSERT_EQ(contour_file_kind(bytes), ContourFileKind::rtstruct);
  const FileContours read = parse_rtstruct(bytes, "file");
  ASSERT_EQ(read.stack.slices.size(), 1u);
  EXPECT_EQ(read.stack.slices[0].contours.at(0).points[2], (Point2{4, 4}));
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_NE(set_cause(bytes.substr(0, n)), "accepted") << n;
}

TEST(Rtstruct, AContourThereTwiceIsKeptOnce) {
  const std::string data = made::square(0, 0, 1, 10), other_way = "0\\10\\1\\10\\10\\1\\10\\0\\1\\0\\0\\1";
  const FileContours read =
      parse_rtstruct(made::rtstruct({{"Heart", {{data}, {other_way}, {made::square(20, 0, 1, 10)}}}}), "file");
  ASSERT_EQ(read.stack.slices.size(), 1u);
  ASSERT_EQ(read.stack.slices[0].contours.size(), 2u);
  EXPECT_EQ(enclosed(read.stack.slices[0].contours[0]), 100);
  EXPECT_EQ(read.remarks.size(), 1u);
}

TEST(Rtstruct, PlanesAFewMicrometresApartAreOne) {
  std::vector<made::RoiContour> contours;
  for (const double z : {0.0, 1.0, 2.0}) {
    contours.push_back({made::square(0, 0, z, 2)});
    contours.push_back({made::square(5, 0, z + 0.004, 2)});
  }
  const FileContours read = parse_rtstruct(made::rtstruct({{"Heart", contours}}), "file");
  ASSERT_EQ(read.stack.slices.size(), 3u);
  for (const Slice& slice : read.stack.slices) EXPECT_EQ(slice.contours.size(), 2u);
  EXPECT_EQ(read.stack.slices[1].z, 1);
  ASSERT_EQ(read.remarks.size(), 1u);
  EXPECT_NE(read.remarks[0].find("0.004 mm apart"), std::string::npos) << read.remarks[0];
}

TEST(Rtstruct, TruePlanesOfAFineStackStayApart) {
  std::vector<made::RoiContour> contours;
  for (const double z : {0.0, 0.01, 0.02, 0.03, 0.04}) contours.push_back({made::square(0, 0, z, 2)});
  EXPECT_EQ(parse_rtstruct(made::rtstruct({{"Heart", contours}}), "file").stack.slices.size(), 5u);
}

TEST(Rtstruct, ObliquePlanesAreReadInTheirOwnFrame) {
  std::vector<made::RoiContour> contours;
  for (const double n : {0.0, 1.0, 2.0}) {
    // Across (0, -0.6, 0.8), in the directions (1, 0, 0) and (0, 0.8, 0.6).
    std::string data;
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}}) {
      data += (data.empty() ? "" : "\\") + std::to_string(u) + "\\" + std::to_string(0.8 * v - 0.6 * n) + "\\" +
              std::to_string(0.6 * v + 0.8 * n);
    }
    contours.push_back({data});
  }
  const FileContours read = parse_rtstruct(made::rtstruct({{"Heart", contours}}), "file");
  ASSERT_EQ(read.stack.slices.size(), 3u);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(read.stack.slices[s].z, static_cast<double>(s), 1e-9);
    EXPECT_NEAR(enclosed(read.stack.slices[s].contours.at(0)), 100, 1e-9);
  }
  EXPECT_EQ(read.remarks.size(), 1u);
}

TEST(Rtstruct, PreambleAndMarkMayBeMissing) {
  const std::string bytes = made::rtstruct({{"Heart", {{made::square(0, 0, 1, 10)}}}}).substr(132);
  EXPECT_EQ(contour_file_kind(bytes), ContourFileKind::rtstruct);
  EXPECT_EQ(parse_rtstruct(bytes, "file").stack.slices.size(), 1u);
}

}  // namespace
}  // namespace odontoscope
