// Folders as people have them: strangers beside the wanted series, several series, series below, damaged files, codings
// of all kinds.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/volume/ct_folder.h"

namespace odontoscope::test {
namespace {

namespace fs = std::filesystem;

using DicomFolder = CtFolder;

TEST_F(DicomFolder, IsReadInEveryCoding) {
  for (const DicomCoding coding :
       {DicomCoding::explicit_little, DicomCoding::implicit_little, DicomCoding::explicit_big, DicomCoding::deflated}) {
    put_series(four_, [coding](Ct& ct) { ct.coding = coding; });
    expect_whole(read());
    expect_whole(read("IM2"));
  }
}

TEST_F(DicomFolder, OfFilesWithoutPreambleIsRead) {
  for (const DicomCoding coding : {DicomCoding::explicit_little, DicomCoding::implicit_little}) {
    for (int n = 0; n < 4; ++n) {
      put(folder_ / ("IM" + std::to_string(n)),
          Ct{.z = four_[std::size_t(n)], .number = n, .instance = n + 1, .coding = coding}.object().bare());
    }
    expect_whole(read());
    expect_whole(read("IM0"));
  }
}

TEST_F(DicomFolder, WithStrangersGivesTheNamedSeries) {
  put_series(four_);
  DicomObject colour = DicomObject()
                           .text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.7")
                           .text(0x20, 0xe, "UI", "9.9")
                           .shorts(0x28, 2, {3})
                           .shorts(0x28, 0x10, {3})
                           .shorts(0x28, 0x11, {4});
  put(folder_ / "SC", colour.shorts(0x28, 0x100, {8}).text(0x7fe0, 0x10, "OB", std::string(36, 'c')).file());
  const std::string other = Ct{.series = "8.8"}.object().file();
  put(folder_ / "cut", other.substr(0, other.size() - 5));
  put(folder_ / "notes.txt", "not DICOM");
  put(folder_ / "empty", "");
  put(folder_ / "zip", std::string("PK\3\4") + std::string(400, 'z'));
  expect_whole(read("IM3"));
  EXPECT_EQ(cause(), "several-series");
  EXPECT_EQ(cause("SC"), "not-scalar");
  EXPECT_EQ(cause("cut"), "truncated-volume");
}

TEST_F(DicomFolder, WithADamagedFileOfNoKnownSeriesAsksForAFileAndSaysWhatItPassesOver) {
  put_series(four_);
  put(folder_ / "odd", Ct{}.object().file().substr(0, 300));
  EXPECT_EQ(cause(), "truncated-volume");
  EXPECT_NE(message().find("--series 1"), std::string::npos);
  for (const Volume& volume : {read("IM1"), read({}, {.series = "1"})}) {
    expect_whole(volume);
    ASSERT_EQ(volume.remarks.size(), 1u);
    EXPECT_NE(volume.remarks[0].find("odd is damaged"), std::string::npos);
  }
  // Of its own series a damaged file is never passed over.
  put(folder_ / "odd", Ct{.z = "38", .instance = 9}.object().file().substr(0, Ct{}.object().file().size() - 4));
  EXPECT_EQ(cause("IM1"), "truncated-volume");
}

TEST_F(DicomFolder, OfSeveralSeriesListsThemToChooseFrom) {
  put_series(four_, [](Ct& ct) { ct.description = "Bone 0.5"; });
  put_series(
      {"0", "1", "2"},
      [](Ct& ct) {
        ct.series = "7.7";
        ct.description = "Soft";
      },
      "S");
  const std::string words = message();
  EXPECT_NE(words.find("1: CT \"Bone 0.5\", 4 x 3 pixels of 0.25 x 0.5 mm, 4 slices 2 mm apart"), std::string::npos)
      << words;
  EXPECT_NE(words.find("2: CT \"Soft\", 4 x 3 pixels of 0.25 x 0.5 mm, 3 slices 1 mm apart"), std::string::npos)
      << words;
  for (const char* chosen : {"1", "1.2.3.4", "Bone 0.5", "bone 0.5"}) expect_whole(read({}, {.series = chosen}));
  EXPECT_EQ(read({}, {.series = "2"}).size[2], 3u);
  EXPECT_EQ(read({}, {.series = "7.7"}).size[2], 3u);
  for (const char* wrong : {"0", "3", "7", "nothing"})
    EXPECT_EQ(cause({}, {.series = wrong}), "no-such-series") << wrong;
}

TEST_F(DicomFolder, TakesANumberFromTheListThatItTold) {
  fs::create_directories(folder_ / "A");
  put_series(
      {"0", "1", "2"}, [](Ct& ct) { ct.series = "5.5"; }, "A/IM");
  put_series(four_);
  put_series(
      {"0", "1"}, [](Ct& ct) { ct.series = "7.7"; }, "S");
  const std::string words = message();
  EXPECT_NE(words.find("1: CT, 4 x 3 pixels of 0.25 x 0.5 mm, 4 slices"), std::string::npos) << words;
  expect_whole(read({}, {.series = "1"}));
  EXPECT_EQ(read({}, {.series = "2"}).size[2], 2u);
  EXPECT_EQ(cause({}, {.series = "3"}), "no-such-series");
  EXPECT_EQ(read({}, {.series = "5.5"}).size[2], 3u) << "by its name one below is found, too";
}

TEST_F(DicomFolder, WithItsSeriesBelowFindsItAndSaysWhere) {
  fs::create_directories(folder_ / "DICOM/PAT0/SE0");
  put_series(four_, {}, "DICOM/PAT0/SE0/IM");
  const Volume volume = read();
  expect_whole(volume);
  ASSERT_EQ(volume.remarks.size(), 1u);
  EXPECT_NE(volume.remarks[0].find("SE0"), std::string::npos);
  // A DICOMDIR that names nothing stands for its folder.
  DicomObject directory = DicomObject().text(8, 0x16, "UI", "1.2.840.10008.1.3.10");
  put(folder_ / "DICOMDIR", directory.file());
  expect_whole(read("DICOMDIR"));
  expect_whole(read());
}

TEST_F(DicomFolder, WithASliceMissingNamesTheGap) {
  put_series({"30", "30.5", "31", "32", "32.5", "33"});
  const std::string words = message();
  EXPECT_NE(words.find("1 slice is missing between"), std::string::npos) << words;
  EXPECT_LT(words.find("IM2"), words.find("IM3")) << words;
  EXPECT_NE(words.find("there are 1 mm between them, and 0.5 mm between others"), std::string::npos) << words;
  EXPECT_EQ(cause({}, {.spacing = std::array<double, 3>{1, 1, 1}}), "uneven-slices");
}

TEST_F(DicomFolder, WithRoundedPlacesIsTakenEvenlyAndSaysSo) {
  std::vector<std::string> heights;
  for (int n = 0; n < 24; ++n) {
    const int tenths = static_cast<int>(n / 3.0 * 10 + 0.5);
    heights.push_back(std::to_string(30 + tenths / 10) + "." + std::to_string(tenths % 10));
  }
  put_series(heights);
  const Volume volume = read();
  EXPECT_NEAR(volume.spacing[2], 1.0 / 3, 1e-3);
  ASSERT_EQ(volume.remarks.size(), 1u);
  EXPECT_NE(volume.remarks[0].find("rounding"), std::string::npos);
  EXPECT_EQ(read({}, {.spacing = std::array<double, 3>{0.25, 0.5, 0.3333}}).spacing[2], 0.3333);
  // The same with a slice missing is refused all the same.
  fs::remove(folder_ / "IM9");
  EXPECT_EQ(cause(), "uneven-slices");
  EXPECT_EQ(cause({}, {.spacing = std::array<double, 3>{0.25, 0.5, 0.3333}}), "uneven-slices");
}

TEST_F(DicomFolder, WithWholeMillimetresHidesNoMissingSlice) {
  for (const std::vector<std::string>& heights : std::vector<std::vector<std::string>>{
           {"0", "1", "3"}, {"0", "2", "6", "8"}, {"0", "1", "3", "4"}, {"0", "2", "3", "4", "5"}}) {
    const TemporaryFolder own;
    for (std::size_t n = 0; n < heights.size(); ++n)
      put(own / std::to_string(n), Ct{.z = heights[n], .instance = int(n) + 1}.object().file());
    EXPECT_THROW(read_volume(own.path().string()), InputError) << heights.back();
  }
}

TEST_F(DicomFolder, WithTheDetectorsSpacingAloneTakesItAndSaysSo) {
  put_series(four_, [](Ct& ct) { ct.spacing_tag = "imager"; });
  const Volume volume = read();
  expect_whole(volume);
  ASSERT_EQ(volume.remarks.size(), 1u);
  EXPECT_NE(volume.remarks[0].find("detector"), std::string::npos);
  put_series(four_, [](Ct& ct) { ct.spacing_tag = "none"; });
  EXPECT_EQ(cause(), "bad-spacing");
  expect_whole(read({}, {.spacing = std::array<double, 3>{0.25, 0.5, 2}}));
}

TEST_F(DicomFolder, WithoutPlacesNeedsASpacingAndThenSaysWhatItAssumes) {
  put_series(four_, [](Ct& ct) { ct.has_position = false; });
  EXPECT_EQ(cause(), "no-positions");
  const Volume volume = read({}, {.spacing = std::array<double, 3>{0.25, 0.5, 2}});
  EXPECT_EQ(volume.slice(3)[0], 300);
  ASSERT_EQ(volume.remarks.size(), 1u);
  EXPECT_NE(volume.remarks[0].find("mirrored"), std::string::npos);
}

TEST_F(DicomFolder, LeavesOutLocalizersAndDoubles) {
  put_series(four_);
  put(folder_ / "scout",
      Ct{.image_type = "ORIGINAL\\PRIMARY\\LOCALIZER", .position = "0\\0\\99", .instance = 50}.object().file());
  put(folder_ / "copy", Ct{.z = "34", .number = 2, .instance = 3}.object().file());
  const Volume volume = read();
  expect_whole(volume);
  EXPECT_EQ(volume.remarks.size(), 2u);
}

TEST_F(DicomFolder, WithOneIdentityForAllSlicesIsStillASeries) {
  put_series(four_, [](Ct& ct) { ct.instance = 1; });
  expect_whole(read());
}

TEST_F(DicomFolder, OfOneMomentAfterTheOtherIsRefused) {
  put_series({"30", "32", "34", "30", "32", "34"});
  EXPECT_EQ(cause(), "time-series");
}

TEST_F(DicomFolder, WithoutImagesSaysSo) {
  put(folder_ / "a.txt", "text");
  EXPECT_EQ(cause(), "no-dicom-images");
  put(folder_ / "report",
      DicomObject().text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.88.11").text(0x20, 0xe, "UI", "1.2").file());
  EXPECT_EQ(cause("report"), "no-dicom-images");
}

/// Bits that are allocated but not stored may hold anything (overlays of old).
TEST_F(DicomFolder, TakesTheStoredBitsAlone) {
  for (int n = 0; n < 2; ++n) {
    DicomObject data = DicomObject()
                           .text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2")
                           .text(0x20, 0xe, "UI", "1.2.3.4")
                           .text(0x20, 0x32, "DS", "0\\0\\" + std::to_string(n));
    data.text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")
        .shorts(0x28, 2, {1})
        .text(0x28, 4, "CS", "MONOCHROME2")
        .shorts(0x28, 0x10, {1 + 1})
        .shorts(0x28, 0x11, {2});
    data.text(0x28, 0x30, "DS", "1\\1")
        .shorts(0x28, 0x100, {16})
        .shorts(0x28, 0x101, {12})
        .shorts(0x28, 0x102, {11})
        .shorts(0x28, 0x103, {1});
    put(folder_ / std::to_string(n), data.words(0x7fe0, 0x10, {0xf001, 0x0fff, 0x17ff, 0x0800}).file());
  }
  const Volume volume = read();
  EXPECT_EQ(volume.values, (std::vector<float>{1, -1, 2047, -2048, 1, -1, 2047, -2048}));
}

}  // namespace
}  // namespace odontoscope::test
