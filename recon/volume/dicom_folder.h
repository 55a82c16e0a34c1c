#pragma once
// The DICOM image series of a folder. Inner part of read_volume_dicom.h.

#include <optional>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/volume/dicom_image.h"

namespace odontoscope {

/// Files that make a volume together: those of one SeriesInstanceUID; a file of several frames alone, or all of one concatenation.
struct DicomSeries {
  std::string uid;
  std::vector<DicomFile> files;  // by name
};

struct DicomFolder {
  /// By their first file's name.
  std::vector<DicomSeries> series;
  /// Files that are DICOM but damaged before they tell their series.
  std::vector<DicomFile> unknown;
};

enum class Depth { folder_only, below_too };

/// All that lies in `folder`. Throws FileError if it cannot be listed, InputError too-many-files beyond limits::dicom_files.
DicomFolder dicom_folder(const std::string& folder, Depth depth, const Progress& progress);

/// "2: CT \"CBCT 0.2\", 400 x 400 pixels of 0.2 x 0.2 mm, 300 slices 0.2 mm apart, in scan/IM0001 and 299 more".
std::string in_words(const DicomSeries& series, std::size_t number);

/// The number of the series that `wanted` names: its number in the list from 1 on, its UID, or its description. Throws InputError no-such-series.
std::size_t chosen_series(const DicomFolder& folder, const std::string& wanted, const std::string& path);

/// A list of all for a message, one a line.
std::string list_of(const DicomFolder& folder);

}  // namespace odontoscope
