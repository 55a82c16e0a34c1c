#pragma once
// Folders of CT series, file by file, and what comes of reading them.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/dicom_object.h"

namespace odontoscope::test {

using testing_support::put;
using testing_support::TemporaryFolder;

/// What a slice of a CT series says.
struct Ct {
  std::string z = "30", series = "1.2.3.4", description = {}, image_type = {};
  std::string spacing_tag = "pixel";  // "pixel", "imager" or none
  std::string position = {};          // instead of x 10, y 20 and z
  int number = 0, instance = 1;
  bool has_position = true;
  std::string patient = {};  // name and number; with a study
  DicomCoding coding = DicomCoding::explicit_little;

  DicomObject object() const {
    DicomObject data(coding);
    if (!image_type.empty()) data.text(8, 8, "CS", image_type);
    data.text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2")
        .text(8, 0x18, "UI", "1.2.3.4." + std::to_string(instance))
        .text(8, 0x60, "CS", "CT");
    if (!description.empty()) data.text(8, 0x103e, "LO", description);
    if (!patient.empty()) data.text(0x10, 0x10, "PN", patient).text(0x10, 0x20, "LO", patient);
    data.text(0x18, 0x50, "DS", "0.5");
    if (spacing_tag == "imager") data.text(0x18, 0x1164, "DS", "0.5\\0.25");
    if (!patient.empty()) data.text(0x20, 0xd, "UI", "1.2.3");
    data.text(0x20, 0xe, "UI", series).text(0x20, 0x13, "IS", std::to_string(instance));
    if (has_position) data.text(0x20, 0x32, "DS", position.empty() ? "10\\20\\" + z : position);
    data.text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")
        .shorts(0x28, 2, {1})
        .text(0x28, 4, "CS", "MONOCHROME2")
        .shorts(0x28, 0x10, {3})
        .shorts(0x28, 0x11, {4});
    if (spacing_tag == "pixel") data.text(0x28, 0x30, "DS", "0.5\\0.25");
    data.shorts(0x28, 0x100, {16}).shorts(0x28, 0x101, {16}).shorts(0x28, 0x102, {15}).shorts(0x28, 0x103, {1});
    return data.words(0x7fe0, 0x10, ct_pixels(number));
  }
};

class CtFolder : public ::testing::Test {
 protected:
  /// One slice a height, each with its number, changed as is wished.
  void put_series(const std::vector<std::string>& heights, const std::function<void(Ct&)>& change = {},
                  const std::string& prefix = "IM") {
    for (std::size_t n = 0; n < heights.size(); ++n) {
      Ct ct;
      ct.z = heights[n];
      ct.number = static_cast<int>(n);
      ct.instance = static_cast<int>(n) + 1;
      if (change) change(ct);
      put(folder_ / (prefix + std::to_string(n)), ct.object().file());
    }
  }
  Volume read(const std::string& name = {}, const ReadVolumeOptions& options = {}) const {
    return read_volume(path(name), options);
  }
  std::string message(const std::string& name = {}, const ReadVolumeOptions& options = {}) const {
    try {
      read(name, options);
      return "none";
    } catch (const Error& error) {
      return error.what();
    }
  }
  std::string cause(const std::string& name = {}, const ReadVolumeOptions& options = {}) const {
    const std::string words = message(name, options);
    const std::size_t at = words.rfind('[');
    return at == words.npos ? words : words.substr(at + 1, words.size() - at - 2);
  }
  std::string path(const std::string& name) const {
    return name.empty() ? folder_.path().string() : (folder_ / name).string();
  }

  TemporaryFolder folder_;
  const std::vector<std::string> four_{"30", "32", "34", "36"};
};

/// All four slices of put_series().
inline void expect_whole(const Volume& volume) {
  EXPECT_EQ(volume.size, (std::array<std::size_t, 3>{4, 3, 4}));
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{0.25, 0.5, 2}));
  EXPECT_EQ(volume.origin, (Point3{10, 20, 30}));
  for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(volume.slice(k)[5], float(100 * k + 5));
}

}  // namespace odontoscope::test
