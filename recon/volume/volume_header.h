#pragma once
// What a volume file's header claims, read and doubted before ITK sees it: its MetaImage and NIfTI readers trust a
// header so far as to crash on some, and to fill in zeros where pixels are missing or NaN. Inner part of read_volume.h.

#include <cstddef>
#include <optional>
#include <string>

#include "recon/volume/pixel_file.h"

namespace odontoscope {

/// What is known of the pixels from the header alone.
struct PixelClaim {
  PixelFile file;
  /// Their number and kind, where the reader below knows them; else they are ITK's to tell.
  std::optional<std::size_t> bytes;
  FloatPixels floats;
};

/// Throws InputError unreadable-volume (a field is missing, doubled, out of range or not finite), many-data-files,
/// not-scalar, not-3d, pixel-type, too-many-voxels, bad-spacing.
PixelClaim read_nrrd_header(const std::string& path);
PixelClaim read_meta_image_header(const std::string& path);
PixelClaim read_nifti_header(const std::string& path);

}  // namespace odontoscope
