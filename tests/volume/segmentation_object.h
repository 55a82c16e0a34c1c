#pragma once
// DICOM segmentations, binary, fractional or as a map of numbers, frame by frame.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/volume/dicom_object.h"

namespace odontoscope::test {

/// Four columns and three rows; pixel n of a binary one is set if bit n of `pixels` is, of a fractional one it is
/// values[n].
struct SegmentFrame {
  std::uint16_t segment = 1;  // 0: it does not say
  std::string position;       // "x\\y\\z"
  std::uint16_t pixels = 0;
  std::vector<std::uint8_t> values = {};
};

struct SegmentationObject {
  std::vector<std::pair<std::uint16_t, std::string>> segments{{1, "tooth"}, {2, "pulp"}};
  std::vector<SegmentFrame> frames;
  std::string kind = "BINARY", axes = "1\\0\\0\\0\\1\\0", slice_spacing = "2", character_set = {}, series = "1.2.3.9",
              instance = "1.2.3.9.1", study = "1.2.3";
  std::uint16_t fraction_of = 255;
  bool has_places = true, shared_segment = false, refers = false;
  DicomCoding coding = DicomCoding::explicit_little;
  bool words = false;  // pixels as words of 16 bits (OW) and not as bytes
  std::string bytes() const;
};

}  // namespace odontoscope::test
