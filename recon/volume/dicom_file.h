#pragma once
// The data set of a DICOM file of images, walked through from end to end (see dicom/dicom_walk.h). Inner part of
// read_volume.h.
//
// DICOM PS3.5, sections 7 (the data set) and A (transfer syntaxes); PS3.10, 7.1 (preamble and meta information).
//
// Little-endian, explicit or implicit; big-endian; deflated. With preamble, or without one (as older programs store,
// then implicit or explicit as its first element shows). Values are kept of those elements alone that say where an
// image lies and what its numbers mean (dicom_wanted.h).

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/error.h"
#include "recon/dicom/dicom_tags.h"

namespace odontoscope {

struct DicomElement;
class DicomSource;

/// Elements in the order of the file, wanted ones only.
struct DicomDataSet {
  std::vector<DicomElement> elements;
  /// Of an item: where it begins, as the records of a DICOMDIR name each other.
  std::uint64_t at = 0;

  /// Null if it is not there.
  const DicomElement* find(std::uint32_t tag) const;
  /// The first item of a sequence; null if there is none.
  const DicomDataSet* item(std::uint32_t sequence) const;
  /// Text without its padding; empty if it is not there.
  std::string text(std::uint32_t tag) const;
  /// Decimal strings or binary numbers, whichever it holds; empty if it is not there or none can be read. None of them
  /// is NaN or infinite.
  std::vector<double> numbers(std::uint32_t tag) const;
  /// Of one number.
  std::optional<double> number(std::uint32_t tag) const;
};

struct DicomElement {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};  // zeros where it is implied
  bool big_endian = false;
  std::string value;
  std::vector<DicomDataSet> items;  // of a sequence
};

/// Where pixels lie; offsets in the file, or in what it unpacks to.
struct DicomPixels {
  struct Fragment {
    std::uint64_t at = 0;
    std::uint32_t length = 0;
  };
  std::uint32_t tag = 0;  // 0: there are none
  std::uint64_t at = 0, length = 0;
  /// Of encapsulated pixels, without the table of offsets, which comes first.
  std::vector<Fragment> fragments;
  std::vector<std::uint32_t> offset_table;
  bool encapsulated = false;
  bool words = false;  // of 16 bits (VR OW)
};

struct DicomFile {
  std::string path;
  /// Transfer syntax and class of the object, by the meta information; empty without.
  std::string syntax, storage_class;
  bool implicit_vr = false, big_endian = false, deflated = false;
  bool has_preamble = true;
  DicomDataSet data;
  DicomPixels pixels;
  /// A value has an odd number of bytes, which DICOM does not allow, but which harms nothing.
  bool odd_lengths = false;
  /// What is wrong with it; what was read before that place is there. InputError truncated-volume, unreadable-volume or
  /// damaged-volume.
  std::optional<InputError> trouble;
};

/// Never throws for what is in the file: see `trouble`. Throws FileError if it cannot be opened. Sequences may lie
/// limits::dicom_nesting deep, and limits::dicom_elements wanted elements are kept at most.
DicomFile read_dicom_file(const std::string& path);

/// `count` bytes from `at` on, of the file as it lies or of what it unpacks to. Opened once for all pixels of a file.
class DicomBytes {
 public:
  explicit DicomBytes(const DicomFile& file);
  ~DicomBytes();
  DicomBytes(const DicomBytes&) = delete;
  DicomBytes& operator=(const DicomBytes&) = delete;
  /// Throws InputError truncated-volume if there are fewer.
  void read(std::uint64_t at, char* to, std::size_t count);

 private:
  std::unique_ptr<DicomSource> source_;
  std::string path_;
};

/// Is there the mark of a DICOM file ("DICM" after 128 bytes), or, without one, a first element as objects without
/// preamble have?
bool looks_like_dicom(const std::string& path);

}  // namespace odontoscope
