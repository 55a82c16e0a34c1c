#include "tests/volume/dicom_bytes.h"

#include <set>

namespace odontoscope::test {
namespace {

template <class T>
std::string little(T value) {
  std::string bytes;
  for (std::size_t n = 0; n < sizeof(T); ++n) bytes += static_cast<char>(value >> (8 * n) & 0xff);
  return bytes;
}

}  // namespace

std::string dicom_element(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  const bool long_length = std::set<std::string>{"OB", "OW", "SQ", "UN"}.contains(vr);
  const std::string length = long_length ? std::string(2, '\0') + little(static_cast<std::uint32_t>(value.size()))
                                         : little(static_cast<std::uint16_t>(value.size()));
  return little(group) + little(element) + vr + length + value;
}

std::string DicomSlice::bytes() const {
  const auto number = [](std::uint16_t group, std::uint16_t element, std::uint16_t value) {
    return dicom_element(group, element, "US", little(value));
  };
  const std::string kind = has_image ? "1.2.840.10008.5.1.4.1.1.2" : "1.2.840.10008.5.1.4.1.1.481.3";
  std::string meta = dicom_element(2, 1, "OB", std::string("\0\1", 2)) + dicom_element(2, 2, "UI", kind) +
                     dicom_element(2, 3, "UI", instance) + dicom_element(2, 0x10, "UI", syntax) +
                     dicom_element(2, 0x12, "UI", "1.2.3");
  meta = dicom_element(2, 0, "UL", little(static_cast<std::uint32_t>(meta.size()))) + meta;
  std::string data = dicom_element(8, 0x16, "UI", kind) + dicom_element(8, 0x18, "UI", instance) +
                     dicom_element(8, 0x60, "CS", "CT") + dicom_element(0x18, 0x50, "DS", "2") +
                     dicom_element(0x20, 0xd, "UI", "1.2.3") + dicom_element(0x20, 0xe, "UI", series);
  if (has_image) {
    data += dicom_element(0x20, 0x32, "DS", position) + dicom_element(0x20, 0x37, "DS", orientation) +
            number(0x28, 2, 1) + dicom_element(0x28, 4, "CS", "MONOCHROME2");
    if (!frames.empty()) data += dicom_element(0x28, 8, "IS", frames);
    data += number(0x28, 0x10, rows) + number(0x28, 0x11, columns) + dicom_element(0x28, 0x30, "DS", spacing) +
            number(0x28, 0x100, 16) + number(0x28, 0x101, 16) + number(0x28, 0x102, 15) + number(0x28, 0x103, 1);
    if (!rescale_slope.empty()) {
      data += dicom_element(0x28, 0x1052, "DS", rescale_intercept) + dicom_element(0x28, 0x1053, "DS", rescale_slope);
    }
    data += more;
    std::string words;
    for (const std::int16_t pixel : pixels) words += little(static_cast<std::uint16_t>(pixel));
    data += dicom_element(0x7fe0, 0x10, "OW", words);
  } else {
    data += more;
  }
  return std::string(128, '\0') + "DICM" + meta + data;
}

}  // namespace odontoscope::test
