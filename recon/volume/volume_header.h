#pragma once
// What a volume file's header says: the grid in the patient's axes, and where and how the pixels lie. Nothing of it is
// believed that could cost memory or time before it is checked. Inner part of read_volume.h, which states the rules.
//
//   NRRD       teem.sourceforge.net/nrrd/format.html (Kindlmann)
//   MetaImage  MetaIO's documentation (Kitware)
//   NIfTI      nifti1.h and nifti2.h of the NIfTI Data Format Working Group (2003, 2011)

#include <optional>
#include <string>
#include <vector>

#include "recon/volume/oriented_image.h"
#include "recon/volume/pixel_file.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

struct VolumeHeader {
  /// Without values; spacing and origin in mm, axes in LPS.
  FileImage image;
  PixelFiles pixels;
  std::vector<VolumeLabel> labels;
  /// What the file does not say and was assumed, one line each.
  std::vector<std::string> remarks;
};

enum class VolumeFormat { nrrd, meta_image, nifti };

/// By content, unpacked where the file is gzip; by name where the content tells nothing (an empty MetaImage header is a
/// damaged one).
std::optional<VolumeFormat> volume_format(const std::string& path);

/// The options' spacing has its say where the file's is missing or its unit unknown. Throws InputError
/// unreadable-volume (a field is missing, doubled, out of range or not finite; the remedy says what to write),
/// outside-folder, not-scalar, not-3d, pixel-type, empty-volume, too-many-voxels, bad-spacing, unknown-unit,
/// left-handed-space.
VolumeHeader read_nrrd_header(const std::string& path, const ReadVolumeOptions& options);
VolumeHeader read_meta_image_header(const std::string& path, const ReadVolumeOptions& options);
VolumeHeader read_nifti_header(const std::string& path, const ReadVolumeOptions& options);

/// Millimetres in one `unit` ("um", "micron", "mm", ...): nothing if it is none that is known.
std::optional<double> millimetres_in(const std::string& unit);

/// Number of voxels; throws empty-volume and too-many-voxels for what no volume has.
std::size_t voxels_of(const std::string& path, const std::vector<double>& sizes);

/// Numbers of the axes that make the volume: all up to three, of more those longer than one voxel. Throws not-3d if
/// these are too many.
std::vector<std::size_t> three_axes(const std::string& path, const std::vector<double>& sizes);

}  // namespace odontoscope
