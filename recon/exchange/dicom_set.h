#pragma once
// The data sets of a DICOM file in memory, nested ones too: only as much of DICOM PS3.5 as structure sets need. GDCM is
// not used for them, since some broken files trip its assertions, which end the program.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

/// A data set without preamble and mark, as old programs write it: its first element is of group 2 or 8.
bool begins_as_data_set(std::string_view bytes);

/// Borrowed bytes: they must outlive it. The preamble and the mark may be missing. Little-endian, explicit or implicit.
/// Whatever is asked for, each element on the way is checked to lie within what holds it: InputError truncated where
/// one does not, unreadable-structure-set for what is no data set, for other transfer syntaxes and for sequences nested
/// deeper than limits::dicom_nesting.
class DicomSet {
 public:
  DicomSet(std::string_view bytes, std::string file);

  /// Elements one after the other, somewhere in the file.
  struct DataSet {
    std::size_t first = 0, end = 0;
    bool explicit_vr = true;
  };
  DataSet top() const { return top_; }

  /// Without the blanks and zeros that DICOM pads with; empty if it is not there, or a sequence.
  std::string_view text(const DataSet& data, std::uint32_t tag) const;
  /// Of a sequence; empty if it is not there.
  std::vector<DataSet> items(const DataSet& data, std::uint32_t tag) const;

 private:
  struct Element {
    std::uint32_t tag = 0;
    std::string_view vr;             // empty where it is implied
    std::size_t first = 0, end = 0;  // of the value; of a sequence without length, without its delimiter
    std::size_t next = 0;            // first byte behind it
    bool undefined = false;          // it has no length but a delimiter
    bool explicit_items = true;
  };
  Element element(std::size_t at, std::size_t end, bool explicit_vr, int depth) const;
  Element header(std::size_t at, std::size_t end, bool explicit_vr) const;
  std::size_t skip_items(std::size_t at, std::size_t end, bool explicit_vr, int depth) const;
  std::size_t skip_item(std::size_t at, std::size_t end, bool explicit_vr, int depth) const;
  /// False if it is not there.
  bool find(const DataSet& data, std::uint32_t tag, Element& found) const;
  void read_meta_information(std::size_t at);
  std::uint32_t number(std::size_t at, std::size_t bytes, std::size_t end) const;
  [[noreturn]] void truncated(std::size_t at) const;
  [[noreturn]] void unreadable(std::size_t at, std::string_view wrong) const;

  std::string_view bytes_;
  std::string file_;
  DataSet top_;
};

}  // namespace odontoscope
