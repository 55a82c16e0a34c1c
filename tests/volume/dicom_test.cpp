// DICOM series: slices in the order of their places, and every way in which a series is none.

#include <gtest/gtest.h>

#include "recon/core/error.h"
#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/dicom_bytes.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

/// Slice n of a series along z, 2 mm apart, its pixels 100 n + (0 to 11).
DicomSlice slice_number(int n, int z) {
  DicomSlice slice;
  slice.position = "10\\20\\" + std::to_string(z);
  slice.instance = "1.2.3.4." + std::to_string(n + 1);
  for (std::size_t p = 0; p < slice.pixels.size(); ++p) slice.pixels[p] = static_cast<std::int16_t>(100 * n + int(p));
  return slice;
}

void put_slice(const TemporaryFolder& folder, const std::string& name, const DicomSlice& slice) {
  put(folder / name, slice.bytes());
}

void put_series(const TemporaryFolder& folder, const std::vector<int>& heights) {
  for (std::size_t n = 0; n < heights.size(); ++n) {
    put_slice(folder, "slice" + std::to_string(n) + ".dcm", slice_number(int(n), heights[n]));
  }
}

std::string cause_of(const std::string& path) {
  testing::internal::CaptureStderr();
  std::string cause = "none";
  try {
    read_volume(path);
  } catch (const InputError& error) {
    cause = error.cause();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  return cause;
}

TEST(Dicom, SlicesLieByTheirPlacesWhateverTheirNames) {
  const TemporaryFolder folder;
  put_series(folder, {4, 0, 6, 2});
  put(folder / "notes.txt", "not DICOM");
  put_slice(folder, "structures.dcm", {.has_image = false});
  for (const std::string& path : {folder.path().string(), (folder / "slice2.dcm").string()}) {
    const Volume volume = read_volume(path);
    EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{4, 3, 4}));
    EXPECT_EQ(volume.spacing, (std::array<double, 3>{0.25, 0.5, 2}));  // DICOM gives the rows' first
    EXPECT_EQ(volume.origin, (Point3{10, 20, 0}));
    EXPECT_EQ(volume.slice(0)[0], 100);
    EXPECT_EQ(volume.slice(1)[5], 305);
    EXPECT_EQ(volume.slice(2)[11], 11);
    EXPECT_EQ(volume.slice(3)[0], 200);
  }
}

TEST(Dicom, SagittalSlicesComeOutAcrossZ) {
  const TemporaryFolder folder;
  for (int n = 0; n < 2; ++n) {
    DicomSlice slice = slice_number(n, 0);
    slice.orientation = "0\\1\\0\\0\\0\\-1";  // columns to the back, rows downwards
    slice.position = std::to_string(-3 * n) + "\\0\\0";
    put_slice(folder, std::to_string(n), slice);
  }
  const Volume volume = read_volume(folder.path().string());
  EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{2, 4, 3}));
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{3, 0.25, 0.5}));
  EXPECT_EQ(volume.origin, (Point3{-3, 0, -1}));
  // Pixel (column 1, row 2) of slice 0 lies at x 0, y 0.25, z -1.
  EXPECT_EQ(volume.slice(0)[1 * 2 + 1], 9);
  EXPECT_EQ(volume.slice(2)[0], 100);
}

TEST(Dicom, ValuesAreRescaled) {
  const TemporaryFolder folder;
  for (int n = 0; n < 2; ++n) {
    DicomSlice slice = slice_number(n, 2 * n);
    slice.rescale_slope = "2";
    slice.rescale_intercept = "-1000";
    put_slice(folder, std::to_string(n), slice);
  }
  EXPECT_EQ(read_volume(folder.path().string()).slice(1)[3], 2 * 103 - 1000);
}

TEST(Dicom, TwoSeriesInAFolderNeedAFileToChooseOne) {
  const TemporaryFolder folder;
  put_series(folder, {0, 2, 4});
  DicomSlice other = slice_number(7, 0);
  other.series = "9.9";
  put_slice(folder, "other.dcm", other);
  EXPECT_EQ(cause_of(folder.path().string()), "several-series");
  EXPECT_EQ(read_volume((folder / "slice0.dcm").string()).size[2], 3u);
  EXPECT_EQ(cause_of((folder / "other.dcm").string()), "single-slice");
}

TEST(Dicom, SlicesThatAreNoSeriesAreRefused) {
  const auto cause_with = [](const std::vector<int>& heights, const std::function<void(DicomSlice&)>& change) {
    const TemporaryFolder folder;
    for (std::size_t n = 0; n < heights.size(); ++n) {
      DicomSlice slice = slice_number(int(n), heights[n]);
      if (n == 1) change(slice);
      put_slice(folder, std::to_string(n), slice);
    }
    return cause_of(folder.path().string());
  };
  const auto nothing = [](DicomSlice&) {};
  EXPECT_EQ(cause_with({}, nothing), "no-dicom-images");
  EXPECT_EQ(cause_with({0}, nothing), "single-slice");
  EXPECT_EQ(cause_with({0, 2, 4}, nothing), "none");
  EXPECT_EQ(cause_with({0, 2, 6, 8}, nothing), "uneven-slices");
  EXPECT_EQ(cause_with({0, 2, 2, 4}, nothing), "time-series");
  EXPECT_EQ(cause_with({2, 2}, nothing), "time-series");
  EXPECT_EQ(cause_with({0, 2, 4}, [](DicomSlice& s) { s.position = "10\\21\\2"; }), "sheared-volume");
  EXPECT_EQ(cause_with({0, 2, 4}, [](DicomSlice& s) { s.spacing = "0.5\\0.3"; }), "mixed-series");
  EXPECT_EQ(cause_with({0, 2, 4}, [](DicomSlice& s) { s.orientation = "0\\1\\0\\-1\\0\\0"; }), "mixed-series");
  EXPECT_EQ(cause_with({0, 2, 4}, [](DicomSlice& s) { s.rows = 2; }), "mixed-series");
}

TEST(Dicom, BrokenFilesAreRefused) {
  const auto cause_with = [](const std::function<std::string(DicomSlice)>& bytes) {
    const TemporaryFolder folder;
    put_series(folder, {0, 4});
    put(folder / "odd.dcm", bytes(slice_number(5, 2)));
    return cause_of(folder.path().string());
  };
  const auto with_more = [](const std::string& more) {
    return [more](DicomSlice slice) {
      slice.more = more;
      return slice.bytes();
    };
  };
  EXPECT_EQ(cause_with([](DicomSlice s) { return s.bytes(); }), "none");
  // Cut anywhere behind the mark, the slice is missed and not passed over.
  for (std::size_t length = 132; length < DicomSlice{}.bytes().size(); length += 7) {
    const std::string cause = cause_with([&](const DicomSlice& s) { return s.bytes().substr(0, length); });
    EXPECT_TRUE(cause == "truncated-volume" || cause == "unreadable-volume") << length << " " << cause;
  }
  EXPECT_EQ(cause_with([](const DicomSlice& s) { return s.bytes().substr(0, s.bytes().size() - 2); }),
            "truncated-volume");
  EXPECT_EQ(cause_with([](DicomSlice s) { return s.rows = 60000, s.columns = 60000, s.bytes(); }), "truncated-volume");
  // Of several frames it is a volume of its own.
  EXPECT_EQ(cause_with([](DicomSlice s) { return s.frames = "4000000000", s.bytes(); }), "several-series");
  // Little-endian bytes that call themselves big-endian, plain ones that call themselves deflated.
  EXPECT_EQ(cause_with([](DicomSlice s) { return s.syntax = "1.2.840.10008.1.2.2", s.bytes(); }), "truncated-volume");
  EXPECT_EQ(cause_with([](DicomSlice s) { return s.syntax = "1.2.840.10008.1.2.1.99", s.bytes(); }), "damaged-volume");
  EXPECT_EQ(cause_with(with_more(dicom_element(0x28, 2, "US", std::string("\3\0", 2)))), "not-scalar");
  EXPECT_EQ(cause_with(with_more(dicom_element(0x20, 0x32, "DS", "1\\2\\inf"))), "unreadable-volume");
  EXPECT_EQ(cause_with(with_more(dicom_element(0x40, 0x275, "SQ", "no items"))), "unreadable-volume");
  EXPECT_EQ(cause_with(with_more(dicom_element(0x40, 0x275, "Q!", "x"))), "unreadable-volume");
  std::string nested = dicom_element(0x40, 0x275, "SQ", "");
  for (int depth = 0; depth < 40; ++depth) {
    std::string item("\xfe\xff\x00\xe0", 4);
    for (int n = 0; n < 4; ++n) item += static_cast<char>(nested.size() >> (8 * n) & 0xff);
    nested = dicom_element(0x40, 0x275, "SQ", item + nested);
  }
  EXPECT_EQ(cause_with(with_more(nested)), "unreadable-volume");
}

TEST(Dicom, AnyChangedBytesEndInAnErrorOrAVolume) {
  const TemporaryFolder folder;
  put_series(folder, {0, 2, 4});
  const std::string good = slice_number(1, 2).bytes();
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomNumbers random(seed);
    std::string bytes = good;
    for (int change = random.whole(1, 3); change > 0; --change) {
      bytes[132 + std::size_t(random.below(int(bytes.size()) - 132))] = char(random.below(256));
    }
    put(folder / "slice1.dcm", bytes);
    try {
      validate_volume(read_volume(folder.path().string()));
    } catch (const InputError& error) {
      EXPECT_FALSE(error.cause().empty());
    }
  }
}

}  // namespace
}  // namespace odontoscope::test
