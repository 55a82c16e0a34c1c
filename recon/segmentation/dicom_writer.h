#pragma once
// Data sets of DICOM to be written (PS3.5): elements come out sorted by tag, padded, sequences with their lengths.
// Inner part of this room.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

enum class DicomCoding {
  implicit_little,  // lengths of 32 bits for everything: long contours need it
  explicit_little,
};

class DicomWriter {
 public:
  /// Of any text's representation. A value that is empty is written as such.
  DicomWriter& text(std::uint32_t tag, std::string_view vr, std::string value);
  DicomWriter& whole(std::uint32_t tag, std::uint16_t value) { return shorts(tag, {value}); }
  DicomWriter& shorts(std::uint32_t tag, const std::vector<std::uint16_t>& values);  // US
  DicomWriter& longs(std::uint32_t tag, const std::vector<std::uint32_t>& values);   // UL
  DicomWriter& pointer(std::uint32_t tag, std::uint32_t to);                         // AT
  DicomWriter& bytes(std::uint32_t tag, std::string value);                          // OB
  DicomWriter& sequence(std::uint32_t tag, std::vector<DicomWriter> items);

  std::string encoded(DicomCoding coding) const;
  /// With preamble and meta information; the class and the instance are those of the data set. InternalError if a value
  /// is too long for its length.
  std::string file(DicomCoding coding) const;

 private:
  struct Element {
    std::string vr, value;
    std::vector<DicomWriter> items;
  };
  std::map<std::uint32_t, Element> elements_;
};

/// At most 16 characters, as decimal strings have: the shortest that gives the same double again if there is room for
/// it, else as many digits as there is.
std::string decimal_string(double value);
/// Several, with backslashes between.
std::string decimal_strings(const std::vector<double>& values);

}  // namespace odontoscope
