#pragma once
// DICOM images as one volume. Inner part of read_volume.h.
//
// `path` is a folder, a DICOMDIR, or a file of the wanted series in its folder; a file of several frames is a volume of
// its own. A folder without images of its own is searched below. Of a DICOMDIR (dicom_directory.h), and of a folder
// with one that names all that lies beside it, those files count that its records name; one of which none is there
// stands for its folder and what lies below. Whatever else lies there is passed over: files that are no DICOM, objects
// that are no images, images of other series; damaged ones, too, unless they are of the series that is read, or nothing
// tells the series they are of and the folder was given and not a file in it.
//
// Enhanced and other multi-frame objects: each frame's place, orientation, pixel spacing and rescaling is its own
// (dicom_image.h); frames may be stored in any order. Parts of a concatenation are put together. Segmentations (SEG)
// become label maps (dicom_segmentation.h).

#include <string>

#include "recon/core/progress.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

/// Throws what dicom_image.h, dicom_stack.h and dicom_pixels.h list; InputError no-dicom-images, several-series (with
/// the list of them to choose from by ReadVolumeOptions::series), no-such-series, missing-files (of the series that is
/// read, a DICOMDIR names some).
Volume read_dicom_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress);

}  // namespace odontoscope
