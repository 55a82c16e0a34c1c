// Multi-frame DICOM: each frame lies where its own or the shared groups say, whatever their order and wherever the
// standard lets them stand.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "recon/core/error.h"
#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/dicom_object.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;
using Where = EnhancedCt::Where;

Volume read(const std::string& bytes, const ReadVolumeOptions& options = {}) {
  const TemporaryFolder folder;
  put(folder / "scan.dcm", bytes);
  return read_volume((folder / "scan.dcm").string(), options);
}

std::string message_of(const std::string& bytes, const ReadVolumeOptions& options = {}) {
  try {
    read(bytes, options);
    return "none";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string cause_of(const std::string& bytes, const ReadVolumeOptions& options = {}) {
  const std::string message = message_of(bytes, options);
  const std::size_t at = message.rfind('[');
  return at == message.npos ? message : message.substr(at + 1, message.size() - at - 2);
}

/// Frames at the given heights, each numbered by its rank from below.
std::vector<CtFrame> frames_at(const std::vector<double>& heights) {
  std::vector<CtFrame> frames;
  for (const double z : heights) {
    const auto rank = std::count_if(heights.begin(), heights.end(), [z](double other) { return other < z; });
    std::string text = std::to_string(z);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    frames.push_back({"10\\20\\" + text, 1, 0, static_cast<int>(rank)});
  }
  return frames;
}

void expect_whole(const Volume& volume) {
  EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{4, 3, 4}));
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{0.25, 0.5, 2}));
  EXPECT_EQ(volume.origin, (Point3{10, 20, 30}));
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t n = 0; n < 12; ++n) ASSERT_EQ(volume.slice(k)[n], float(100 * k + n)) << k << " " << n;
}

TEST(DicomFrames, LieWhereTheirGroupsSayInAnyOrder) {
  std::vector<double> heights{30, 32, 34, 36};
  do {
    expect_whole(read(EnhancedCt{.frames = frames_at(heights)}.bytes()));
  } while (std::next_permutation(heights.begin(), heights.end()));
}

TEST(DicomFrames, GroupsMayBeSharedOrEachFramesOwnOrAtTheTop) {
  for (const Where orientation : {Where::top, Where::shared, Where::frame})
    for (const Where measures : {Where::top, Where::shared, Where::frame})
      for (const Where transformation : {Where::top, Where::shared, Where::frame})
        for (const DicomCoding coding : {DicomCoding::explicit_little, DicomCoding::implicit_little,
                                         DicomCoding::explicit_big, DicomCoding::deflated})
          for (const bool open : {false, true})
            expect_whole(read(EnhancedCt{.frames = frames_at({36, 30, 34, 32}),
                                         .orientation = orientation,
                                         .measures = measures,
                                         .transformation = transformation,
                                         .open_items = open,
                                         .more = DicomObject(coding),
                                         .coding = coding}
                                  .bytes()));
}

TEST(DicomFrames, AreRescaledEachByItsOwnSlope) {
  std::vector<CtFrame> frames = frames_at({30, 32});
  frames[0].slope = 2;
  frames[0].intercept = -1000;
  frames[1].slope = 0.5;
  const Volume volume = read(EnhancedCt{.frames = frames, .transformation = Where::frame}.bytes());
  EXPECT_EQ(volume.slice(0)[3], 2 * 3 - 1000);
  EXPECT_EQ(volume.slice(1)[3], 0.5 * 103);
}

TEST(DicomFrames, AlongAnyAxisComeOutUnmirrored) {
  // Sagittal: columns to the back, rows down, frames from right to left, stored from left to right.
  std::vector<CtFrame> frames;
  for (int n = 0; n < 3; ++n) frames.push_back({std::to_string(6 - 3 * n) + "\\0\\0", 1, 0, n});
  const Volume volume = read(EnhancedCt{.frames = frames, .axes = "0\\1\\0\\0\\0\\-1"}.bytes());
  EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{3, 4, 3}));
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{3, 0.25, 0.5}));
  EXPECT_EQ(volume.origin, (Point3{0, 0, -1}));
  EXPECT_EQ(volume.slice(2)[0], 200);        // frame 2 at x 0; first pixel at z 0
  EXPECT_EQ(volume.slice(0)[1 * 3 + 2], 9);  // frame 0 at x 6; column 1, row 2
}

TEST(DicomFrames, WithAGapAreRefusedAndTheGapIsNamed) {
  const std::string message = message_of(EnhancedCt{.frames = frames_at({30, 32, 34, 40, 42})}.bytes());
  EXPECT_NE(message.find("2 slices are missing"), std::string::npos) << message;
  EXPECT_NE(message.find("frame 3"), std::string::npos) << message;
  EXPECT_NE(message.find("frame 4"), std::string::npos) << message;
  EXPECT_NE(message.find("6 mm"), std::string::npos) << message;
  // A spacing that is given hides no gap.
  EXPECT_EQ(cause_of(EnhancedCt{.frames = frames_at({30, 32, 34, 40, 42})}.bytes(),
                     {.spacing = std::array<double, 3>{1, 1, 2}}),
            "uneven-slices");
}

TEST(DicomFrames, ThatAreNoVolumeAreRefused) {
  EXPECT_EQ(cause_of(EnhancedCt{.frames = frames_at({30, 32, 32, 34})}.bytes()), "time-series");
  EXPECT_EQ(cause_of(EnhancedCt{.frames = frames_at({30})}.bytes()), "single-slice");
  std::vector<CtFrame> flat = frames_at({30, 32});
  flat[0].slope = 0;
  EXPECT_EQ(cause_of(EnhancedCt{.frames = flat, .transformation = Where::frame}.bytes()), "unreadable-volume");
  std::vector<CtFrame> odd = frames_at({30, 32});
  odd[1].position = "10\\20";
  EXPECT_EQ(cause_of(EnhancedCt{.frames = odd}.bytes()), "unreadable-volume");
  odd[1].position = "10\\20\\nan";
  EXPECT_EQ(cause_of(EnhancedCt{.frames = odd}.bytes()), "unreadable-volume");
  odd[1].position = "10\\25\\32";
  EXPECT_EQ(cause_of(EnhancedCt{.frames = odd}.bytes()), "sheared-volume");
}

/// An object of several frames without groups: a place for the first, and whatever else.
std::string plain_frames(const DicomObject& more, int count = 3) {
  DicomObject data;
  data.text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.7.3").text(0x20, 0xe, "UI", "1.2.3.4").all(more);
  data.shorts(0x28, 2, {1})
      .text(0x28, 4, "CS", "MONOCHROME2")
      .text(0x28, 8, "IS", std::to_string(count))
      .shorts(0x28, 0x10, {3})
      .shorts(0x28, 0x11, {4});
  data.text(0x28, 0x30, "DS", "0.5\\0.25")
      .shorts(0x28, 0x100, {16})
      .shorts(0x28, 0x101, {16})
      .shorts(0x28, 0x102, {15})
      .shorts(0x28, 0x103, {1});
  std::vector<std::uint16_t> pixels;
  for (int n = 0; n < count; ++n)
    for (const std::uint16_t pixel : ct_pixels(n)) pixels.push_back(pixel);
  return data.words(0x7fe0, 0x10, pixels).file();
}

DicomObject placed() {
  return DicomObject().text(0x20, 0x32, "DS", "10\\20\\30").text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0");
}

TEST(DicomFrames, WithoutPlacesFollowTheNormalAsFarApartAsTheFileSays) {
  const Volume between = read(plain_frames(placed().text(0x18, 0x88, "DS", "0.7")));
  EXPECT_NEAR(between.spacing[2], 0.7, 1e-12);
  ASSERT_EQ(between.remarks.size(), 1u);
  const Volume thick = read(plain_frames(placed().text(0x18, 0x50, "DS", "0.6")));
  EXPECT_NEAR(thick.spacing[2], 0.6, 1e-12);
  EXPECT_EQ(thick.slice(1)[0], 100);
  ASSERT_EQ(thick.remarks.size(), 1u);
  EXPECT_NE(thick.remarks[0].find("thickness of 0.6 mm"), std::string::npos);
  // Nothing says how far: asked for, and right once it is given.
  EXPECT_EQ(cause_of(plain_frames(placed())), "no-positions");
  const Volume given = read(plain_frames(placed()), {.spacing = std::array<double, 3>{0.25, 0.5, 3}});
  EXPECT_EQ(given.spacing[2], 3);
  EXPECT_EQ(given.slice(2)[0], 200);
}

TEST(DicomFrames, OfAFilmAreRefused) {
  EXPECT_EQ(
      cause_of(plain_frames(
          placed().text(0x18, 0x50, "DS", "1").text(0x18, 0x1063, "DS", "69.5").shorts(0x28, 9, {0x18, 0x1063}, "AT"))),
      "time-series");
  EXPECT_EQ(cause_of(plain_frames(placed().text(0x18, 0x50, "DS", "1").text(0x18, 0x1065, "DS", "0\\40\\40"))),
            "time-series");
  EXPECT_EQ(cause_of(plain_frames(placed().text(0x18, 0x50, "DS", "1").text(0x18, 0x1063, "DS", "69.5")),
                     {.spacing = std::array<double, 3>{1, 1, 1}}),
            "time-series");
}

TEST(DicomFrames, OfADoseGridLieAtItsOffsets) {
  const auto dose = [](const std::string& offsets) {
    return placed().shorts(0x28, 9, {0x3004, 0x000c}, "AT").text(0x3004, 0x0c, "DS", offsets);
  };
  EXPECT_EQ(read(plain_frames(dose("0\\2.5\\5"))).spacing[2], 2.5);
  EXPECT_EQ(read(plain_frames(dose("0\\-2.5\\-5"))).slice(0)[0], 200);
  EXPECT_EQ(cause_of(plain_frames(dose("0\\2.5"))), "unreadable-volume");
  EXPECT_EQ(cause_of(plain_frames(dose("0\\2.5\\7.5"))), "uneven-slices");
}

/// PS3.5, 6.2: between byte orders words of 16 bits are turned each by itself, so the lower half of a pixel of 32 bits
/// still comes first.
TEST(DicomFrames, OfPixelsOfTwoWordsInABigEndianFile) {
  DicomObject data(DicomCoding::explicit_big);
  data.text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.7.3").text(0x18, 0x88, "DS", "2").text(0x20, 0xe, "UI", "1.2.3.4");
  data.text(0x20, 0x32, "DS", "10\\20\\30")
      .text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")
      .shorts(0x28, 2, {1})
      .text(0x28, 4, "CS", "MONOCHROME2")
      .text(0x28, 8, "IS", "2");
  data.shorts(0x28, 0x10, {1})
      .shorts(0x28, 0x11, {2})
      .text(0x28, 0x30, "DS", "1\\1")
      .shorts(0x28, 0x100, {32})
      .shorts(0x28, 0x101, {32})
      .shorts(0x28, 0x102, {31})
      .shorts(0x28, 0x103, {0});
  const Volume volume = read(data.words(0x7fe0, 0x10, {1, 2, 3, 4, 5, 6, 7, 8}).file());
  EXPECT_EQ(volume.values, (std::vector<float>{1 + 2 * 65536, 3 + 4 * 65536, 5 + 6 * 65536, 7 + 8 * 65536}));
}

/// One frame's compressed bytes in each piece.
std::string compressed(const std::string& syntax, const std::vector<std::string>& pieces) {
  DicomObject data;
  data.text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.7.3")
      .text(0x20, 0xe, "UI", "1.2.3.4")
      .all(placed())
      .text(0x18, 0x88, "DS", "2");
  data.shorts(0x28, 2, {1})
      .text(0x28, 4, "CS", "MONOCHROME2")
      .text(0x28, 8, "IS", std::to_string(pieces.size()))
      .shorts(0x28, 0x10, {3})
      .shorts(0x28, 0x11, {4});
  data.text(0x28, 0x30, "DS", "0.5\\0.25")
      .shorts(0x28, 0x100, {16})
      .shorts(0x28, 0x101, {16})
      .shorts(0x28, 0x102, {15})
      .shorts(0x28, 0x103, {0});
  return data.pieces(pieces).file(syntax);
}

TEST(DicomFrames, PackedAreDecodedInAProcessOfTheirOwn) {
  const std::string rle = "1.2.840.10008.1.2.5";
  const Volume volume = read(compressed(rle, {rle_packed(ct_pixels(0)), rle_packed(ct_pixels(1))}));
  EXPECT_EQ(volume.slice(0)[7], 7);
  EXPECT_EQ(volume.slice(1)[11], 111);
}

TEST(DicomFrames, ThatNoDecoderTakesAreRefusedAndEndNothing) {
  for (const char* syntax : {"1.2.840.10008.1.2.5", "1.2.840.10008.1.2.4.50", "1.2.840.10008.1.2.4.57",
                             "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.90"}) {
    for (const std::string& bytes :
         {std::string(64, 'x'), std::string("\xff\xd8\xff\xc3\0\x0b\x10\xff\xff\xff\xff\1\1\x11\0", 15),
          std::string("\xff\x4f\xff\x51\0\x29", 6)}) {
      EXPECT_EQ(cause_of(compressed(syntax, {rle_packed(ct_pixels(0)), bytes})), "damaged-volume") << syntax;
    }
  }
  EXPECT_EQ(cause_of(compressed("1.2.840.10008.1.2.4.999", {"ab", "cd"})), "unreadable-volume");
}

}  // namespace
}  // namespace odontoscope::test
