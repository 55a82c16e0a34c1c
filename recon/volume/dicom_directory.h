#pragma once
// The files that a DICOMDIR names: what a CD, a stick or a PACS hands out has one beside its folders. Inner part of
// read_volume_dicom.h.
//
// DICOM PS3.3, annex F (records of patients, studies, series and files, which name each other by their places in the
// file), PS3.10, 8.5 (names of files: parts, one below the other). Records are followed from the first one on. Those
// that are not in use, or to which none leads, were deleted. Where one names a place at which there is none, or they
// come round in a circle, all that are in use are taken in the order of the file, which is said.
//
// Names are looked for as they stand, then without regard to capitals and to ";1" and "." at their ends, as systems
// show the same disc differently.

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/volume/dicom_file.h"

namespace odontoscope {

struct DicomDirectory {
  /// Named, and not there, no plain file or no DICOM.
  struct Missing {
    std::string series;  // the UID of the series that it belongs to; empty if the records do not tell
    std::string name;
  };
  std::vector<std::string> files;  // that are there, by name, each once
  std::vector<Missing> missing;
  std::vector<std::string> remarks;
};

/// By its class, or its name.
bool is_dicom_directory(const DicomFile& file);

/// The DICOMDIR that lies in a folder, in capitals or not; empty if none does.
std::string dicom_directory_in(const std::string& folder);

/// Precondition: a file without trouble. Throws InputError outside-folder for names that lead out of its folder (links
/// followed), unless `allow_outside`; too-many-files beyond limits::dicom_files; Cancelled.
DicomDirectory dicom_directory(const DicomFile& file, bool allow_outside, const Progress& progress);

/// "DICOM/IM0003, DICOM/IM0004 and 8 more", fit for a message.
std::string names_of(const std::vector<DicomDirectory::Missing>& missing);

}  // namespace odontoscope
