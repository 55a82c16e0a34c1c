#pragma once
// The data sets of a DICOM file in memory, nested ones too, asked for what structure sets hold.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/dicom/dicom_walk.h"

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
    std::uint64_t first = 0, end = 0;
    bool implicit_vr = false;
  };
  DataSet top() const { return top_; }

  /// Without the blanks and zeros that DICOM pads with; empty if it is not there, or a sequence.
  std::string_view text(const DataSet& data, std::uint32_t tag) const;
  /// Of a sequence; empty if it is not there.
  std::vector<DataSet> items(const DataSet& data, std::uint32_t tag) const;

 private:
  /// Where the value begins; empty if it is not there.
  std::optional<DicomHead> find(const DataSet& data, std::uint32_t tag) const;
  void read_meta_information(std::uint64_t at);

  std::string_view bytes_;
  std::string file_;
  mutable DicomSource source_;
  mutable DicomWalk walk_;
  DataSet top_;
};

}  // namespace odontoscope
