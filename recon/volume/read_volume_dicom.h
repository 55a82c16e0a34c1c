#pragma once
// A DICOM series as one image. Inner part of read_volume.h, which states what is refused.

#include <string>

#include "recon/core/progress.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

/// `path` is a folder with one series, or a file of the wanted one in its folder; a file of several frames is a volume
/// of its own. Files that are no DICOM images are passed over.
Volume read_dicom_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress);

}  // namespace odontoscope
