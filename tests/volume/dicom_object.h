#pragma once
// DICOM objects of any coding, element by element, and Enhanced CT with its functional groups wherever the standard
// lets them lie.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace odontoscope::test {

enum class DicomCoding { explicit_little, implicit_little, explicit_big, deflated };

/// Elements in the order in which they are added.
class DicomObject {
 public:
  explicit DicomObject(DicomCoding coding = DicomCoding::explicit_little) : coding_(coding) {}

  DicomObject& text(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value);
  DicomObject& shorts(std::uint16_t group, std::uint16_t element, const std::vector<std::uint16_t>& values,
                      const std::string& vr = "US");
  DicomObject& words(std::uint16_t group, std::uint16_t element, const std::vector<std::uint16_t>& values) {
    return shorts(group, element, values, "OW");
  }
  /// Items without a length, with a delimiter, where `open`.
  DicomObject& sequence(std::uint16_t group, std::uint16_t element, const std::vector<DicomObject>& items,
                        bool open = false);
  /// Pixels in pieces, the first of which is the (empty) table of offsets.
  DicomObject& pieces(const std::vector<std::string>& fragments);
  /// All elements of another object of the same coding.
  DicomObject& all(const DicomObject& other);

  /// With preamble and meta information, or bare.
  std::string file(const std::string& syntax = {},
                   const std::string& storage_class = "1.2.840.10008.5.1.4.1.1.2") const;
  const std::string& bare() const { return bytes_; }

 private:
  std::string number(std::uint32_t value, std::size_t bytes) const;
  void head(std::uint16_t group, std::uint16_t element, const std::string& vr, std::uint32_t length);

  DicomCoding coding_;
  std::string bytes_;
};

/// A frame of 4 columns and 3 rows, whose stored numbers tell the frame and the pixel.
struct CtFrame {
  std::string position;  // "x\\y\\z"
  double slope = 1, intercept = 0;
  int number = 0;  // pixels are 100 number + (0 to 11)
};

struct EnhancedCt {
  enum class Where { top, shared, frame };
  std::vector<CtFrame> frames;
  Where orientation = Where::shared, measures = Where::shared, transformation = Where::shared;
  std::string axes = "1\\0\\0\\0\\1\\0", series = "1.2.3.4", instance = "1.2.3.4.1";
  bool has_places = true, open_items = false;
  DicomObject more = DicomObject();  // before the pixels
  DicomCoding coding = DicomCoding::explicit_little;
  std::string bytes() const;
};

/// The same numbers in RLE, as PS3.5, annex G, has it: 16 bits in two segments, nothing but literal runs.
std::string rle_packed(const std::vector<std::uint16_t>& pixels);
std::vector<std::uint16_t> ct_pixels(int number);

}  // namespace odontoscope::test
