#pragma once
// Bytes of small DICOM files (explicit, little-endian), whole or lied about.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace odontoscope::test {

struct DicomSlice {
  std::uint16_t rows = 3, columns = 4;
  std::string position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0", spacing = "0.5\\0.25";
  std::string series = "1.2.3.4", instance = "1.2.3.4.1", syntax = "1.2.840.10008.1.2.1";
  std::string rescale_slope = {}, rescale_intercept = {}, frames = {};
  bool has_image = true;
  std::string more = {};  // elements before the pixels
  std::vector<std::int16_t> pixels = std::vector<std::int16_t>(12, 7);
  std::string bytes() const;
};

/// One element; the value is padded to even length.
std::string dicom_element(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value);

}  // namespace odontoscope::test
