#pragma once
// The DICOM image series of a folder. Inner part of read_volume_dicom.h.

#include <optional>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/volume/dicom_image.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

/// Files that make a volume together: those of one SeriesInstanceUID; a file of several frames alone, or all of one
/// concatenation.
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

/// Plain files of a folder that may be DICOM, by name. Throws as dicom_folder does.
std::vector<std::string> dicom_candidates(const std::string& folder, Depth depth, const Progress& progress);

/// What these files are; each is looked into.
DicomFolder dicom_series_of(const std::vector<std::string>& files, const Progress& progress);

/// All that lies in `folder`. Throws FileError if it cannot be listed, InputError too-many-files beyond
/// limits::dicom_files.
DicomFolder dicom_folder(const std::string& folder, Depth depth, const Progress& progress);

/// Each as a person chooses one.
std::vector<SeriesOffer> offers_of(const DicomFolder& folder);

/// "2: CT \"CBCT 0.2\", 400 x 400 pixels of 0.2 x 0.2 mm, 300 slices 0.2 mm apart, in scan/IM0001 and 299 more".
std::string in_words(const SeriesOffer& offer, std::size_t number);

/// Numbers of the series that `wanted` names: by its number in the list from 1 on, its UID, or its description.
std::vector<std::size_t> series_named(const DicomFolder& folder, const std::string& wanted);

/// Which one that is. Throws InputError no-such-series.
std::size_t chosen_series(const DicomFolder& folder, const std::string& wanted, const std::string& path);

/// A list for a message, one a line.
std::string list_of(const std::vector<SeriesOffer>& offers);

/// Text of a file as a message may hold it: printable, short.
std::string tamed(const std::string& text);

}  // namespace odontoscope
