#pragma once
// Volume images from files: NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI-1 and -2 (.nii, .nii.gz, .hdr + .img)
// and DICOM (a folder, a DICOMDIR, or one file of a series in its folder; read_volume_dicom.h). What a file is, is told
// by its content; gzip is unpacked whatever the name.
//
// Any integer or floating scalar type is read and kept as float: whole numbers beyond 2^24 are rounded.
//
// **Axes.** Coordinates are the patient's: x to the left, y to the back, z up (LPS), millimetres; files in another
// convention (NIfTI, the spaces of NRRD) and in other units are converted. The image's axes are reordered and reversed
// to run along x, y and z, so every voxel is put where the file says that it lies: a volume that is stored upside down
// or left-handed comes out as it is, never mirrored. Slices are those across z. An oblique image (axes at right angles,
// but turned against the coordinate axes) is read in its own frame: the nearest axes are taken, the first voxel stays
// in place, and the turn that is dropped is told in Volume::tilt_degrees. That is a rotation, so shape and handedness
// are untouched. Axes that are not at right angles (gantry tilt) are refused.
//
// **What a file does not say.** A file without orientation is taken as it stands, one without spacing with 1 mm, one
// without unit in millimetres; each such assumption is a line of Volume::remarks. Units that are not known, and NRRD's
// left-handed space, are refused.
//
// Not supported: colour and vectors, time series, DICOM series with missing or unevenly spaced slices, shear in a NIfTI
// sform, NRRD packed by bzip2.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/progress.h"
#include "recon/volume/volume.h"

namespace odontoscope {

/// Bounds along x, y and z of a volume, mm.
struct VolumeBounds {
  std::array<double, 3> low{}, high{};
};

/// No more of a file than is wanted, so that memory stays bounded however large it is. NRRD, MetaImage and NIfTI only:
/// DICOM is read whole.
struct VolumePart {
  std::size_t whole_up_to = 0;              // files of no more voxels are read whole, whatever follows
  std::size_t most_voxels = 1u << 27;       // of more, blocks become one, finest axis first
  bool sampled = false;                     // blocks become their first voxel; else their mean
  std::optional<VolumeBounds> within = {};  // and only what lies in these
};

struct ReadVolumeOptions {
  /// Instead of the header's, along the file's own first, second and third axis (columns, rows, slices), mm. The origin
  /// stays, unless its unit is unknown: then it is scaled with the first.
  std::optional<std::array<double, 3>> spacing = {};
  /// Of several DICOM series the one to read: its number in the list that several-series tells, its UID or its
  /// description.
  std::string series = {};
  std::optional<VolumePart> part = {};
  /// Read pixels from a file outside the folder of the NRRD or MetaImage header or the DICOMDIR that names it.
  bool allow_outside = false;
};

/// A DICOM series to choose.
struct SeriesOffer {
  std::string modality, description;              // printable and short; may be empty
  std::size_t columns = 0, rows = 0, slices = 0;  // 0: it is none that could be read
  std::optional<std::array<double, 2>> pixel_mm;
  std::optional<double> apart_mm;  // its slices, if evenly
  std::string trouble;             // the cause for which it cannot be read; empty if nothing is known against it
  std::string first_file;
  std::size_t files = 0;
  std::vector<std::string> segments;  // of a segmentation: their names
};

/// InputError several-series, with what there is to choose from by its number, from 1 on.
class SeveralSeries : public InputError {
 public:
  SeveralSeries(Place place, std::string_view wrong, std::vector<SeriesOffer> series)
      : InputError("several-series", std::move(place), wrong,
                   "Choose one by its number (--series N), or give a file of it"),
        series_(std::move(series)) {}
  const std::vector<SeriesOffer>& series() const { return series_; }

 private:
  std::vector<SeriesOffer> series_;
};

/// Reads a volume that passes validate_volume. Stage "read". May be called from several threads at once.
///
/// The header is checked before memory is asked for, and memory is taken only as pixels come. Throws FileError
/// (missing, not a file or folder, cannot be opened; more memory than there is); InputError with what validate_volume
/// throws, or unknown-volume-format, unreadable-volume (header or pixels), truncated-volume (the file is too short for
/// its header's sizes), damaged-volume (packed pixels), too-well-packed (few bytes that would become more than a
/// gigabyte), outside-folder, not-scalar, not-3d, pixel-type (complex and the like), unknown-unit, left-handed-space,
/// sheared-volume; for DICOM also what read_volume_dicom.h lists.
Volume read_volume(const std::string& path, const ReadVolumeOptions& options = {}, const Progress& progress = {});

}  // namespace odontoscope
