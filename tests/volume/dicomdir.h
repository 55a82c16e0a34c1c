#pragma once
// A DICOMDIR, record by record, whole or lied about.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/volume/dicom_object.h"

namespace odontoscope::test {

struct DirectoryRecord {
  std::string type;                 // "PATIENT", "STUDY", "SERIES", "IMAGE"
  std::string file = {};            // parts with backslashes between
  std::string series = {};          // of a series: its UID
  std::size_t next = 0, lower = 0;  // other records, counted from 1; 0: none
  bool in_use = true;
  std::uint32_t astray = 0;  // instead of the next record: any place
};

struct DirectorySeries {
  std::string uid;
  std::vector<std::string> files;
};

/// A patient, a study, and the series in it. The patient's is the first record.
std::vector<DirectoryRecord> records_of(const std::vector<DirectorySeries>& series);

struct DicomDir {
  std::vector<DirectoryRecord> records;
  std::size_t first = 1;
  bool open_items = false;
  DicomCoding coding = DicomCoding::explicit_little;
  std::string bytes() const;
};

}  // namespace odontoscope::test
