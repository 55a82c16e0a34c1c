#pragma once
// Volume images from files: NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI-1 (.nii, .nii.gz, .hdr + .img) and DICOM
// (a folder, or one file of a series in its folder), through ITK.
//
// Any integer or floating scalar type is read and kept as float: whole numbers beyond 2^24 are rounded.
//
// **Axes.** Coordinates are the patient's as ITK has them: x to the left, y to the back, z up (LPS), millimetres; files
// in another convention (NIfTI, "right-anterior-superior") are converted. The image's axes are reordered and reversed
// to run along x, y and z, so every voxel is put where the file says that it lies: a volume that is stored upside down
// or left-handed comes out as it is, never mirrored. Slices are those across z. A file without orientation is taken as
// it stands; without spacing (NRRD: nan) it is 1 mm. An oblique image (axes at right angles, but turned against the
// coordinate axes) is read in its own frame: the nearest axes are taken, the first voxel stays in place, and the turn
// that is dropped is told in Volume::tilt_degrees. That is a rotation, so shape and handedness are untouched. Axes that
// are not at right angles (gantry tilt) are refused.
//
// Not supported: several data files to one header, colour and vectors, time series, DICOM series with missing or
// unevenly spaced slices, shear in a NIfTI sform (refused;
// the little that is within ITK's tolerance is left out).

#include <array>
#include <optional>
#include <string>

#include "recon/core/progress.h"
#include "recon/volume/volume.h"

namespace odontoscope {

struct ReadVolumeOptions {
  /// Instead of the header's, along the file's own first, second and third axis (columns, rows, slices), mm. The origin
  /// stays.
  std::optional<std::array<double, 3>> spacing;
};

/// Reads a volume that passes validate_volume. Stage "read".
///
/// The header is checked before memory is asked for. Throws FileError (missing, not a file or folder, cannot be
/// opened); InputError with what validate_volume throws, or unknown-volume-format, unreadable-volume (header or pixels;
/// ITK's words follow), truncated-volume (the file is too short for its header's sizes), damaged-volume (compressed
/// pixels), many-data-files, not-scalar, not-3d, pixel-type (complex and the like), sheared-volume; DICOM:
/// no-dicom-images, several-series, mixed-series (sizes or orientations differ), uneven-slices.
///
/// While it runs, std::cerr and ITK's and GDCM's messages are switched off for the whole program, since the libraries
/// write there as they please: call it from one thread at a time, and do not write to std::cerr meanwhile.
Volume read_volume(const std::string& path, const ReadVolumeOptions& options = {}, const Progress& progress = {});

}  // namespace odontoscope
