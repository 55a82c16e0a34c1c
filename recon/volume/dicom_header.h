#pragma once
// Is a DICOM file whole, and is it an image? Walked through before GDCM sees it, which stops the program on some broken
// files and makes up the pixels that others lack. Inner part of read_volume.h.
//
// DICOM PS3.5, sections 7 (the data set) and A (transfer syntaxes).

#include <string>

namespace odontoscope {

struct DicomHeader {
  /// Has rows and pixels; others (structure sets, reports, DICOMDIR) have not.
  bool is_image = false;
  /// SeriesInstanceUID; may be empty.
  std::string series;
};

/// Walks all elements, nested ones too. Throws InputError truncated-volume where one reaches beyond its file or
/// sequence, or the pixels are missing or fewer than rows, columns, frames and bits make; not-scalar for colours;
/// unreadable-volume for what is no data set, for sequences nested deeper than limits::dicom_nesting, and for the
/// transfer syntaxes deflated and big-endian, which are not supported. Compressed pixels (JPEG ...) are only seen to be
/// there.
DicomHeader read_dicom_header(const std::string& file);

/// Has `path` the mark of a DICOM file ("DICM" after 128 bytes)?
bool is_dicom_file(const std::string& path);

}  // namespace odontoscope
