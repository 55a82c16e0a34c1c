#pragma once
// Planes of DICOM images, in whatever order, as one grid: sorted by their places along their normal. Inner part of
// read_volume.h.

#include <string>
#include <vector>

#include "recon/volume/dicom_image.h"
#include "recon/volume/dicom_pixels.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

struct DicomStack {
  FileImage image;  // without values
  std::vector<DicomPlane> planes;
  std::vector<std::string> remarks;
};

/// The images outlive the result. Slices must be evenly spaced, within limits::slice_unevenness of their spacing; where
/// that last digit that positions are written with explains more, within limits::slice_rounding. A spacing that is
/// given instead (options) leaves places out of account, but not gaps. Images without place are taken in the order of
/// their numbers, if the spacing is given. Throws InputError single-slice, mixed-series (sizes, orientations or pixel
/// spacings differ), time-series (several images in one place), uneven-slices (naming the gap), sheared-volume (a
/// tilted gantry), no-positions, bad-spacing (none is given), and what validate_grid throws.
DicomStack stack_planes(const std::vector<const DicomImage*>& images, const std::string& source,
                        const ReadVolumeOptions& options);

/// Distance of the slices of such a stack for a list: nothing where it would be refused.
std::optional<double> slice_spacing_of(const std::vector<const DicomImage*>& images);

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace odontoscope
