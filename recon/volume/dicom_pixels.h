#pragma once
// Pixels of DICOM images as floats, rescaled. Inner part of read_volume.h.
//
// Plain ones are read by code of our own. Compressed ones (JPEG, JPEG-LS, JPEG 2000, RLE) are decoded by GDCM in a
// child process (see decode_apart.h), which is given nothing of the user's file but the frame's own pieces and the
// sizes that were checked before.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/volume/dicom_image.h"

namespace odontoscope {

/// A frame of an image.
struct DicomPlane {
  const DicomImage* image = nullptr;
  std::size_t frame = 0;
};

/// All planes, which have one size, one after the other. Stage "read". Throws InputError truncated-volume,
/// damaged-volume (compressed pixels that cannot be decoded), too-well-packed, unreadable-volume (a compression that
/// GDCM does not know).
std::vector<float> read_planes(const std::vector<DicomPlane>& planes, const Progress& progress);

/// Pixels of a binary segmentation, one bit each, frames without a gap: 0 or 1. `bytes` is of the image's file. Throws
/// InputError truncated-volume.
void read_bits(const DicomImage& image, std::size_t frame, DicomBytes& bytes, std::vector<float>& to);

/// Throws InputError too-well-packed for compressed planes that are few bytes and would become more than a gigabyte.
void check_plausible(const std::vector<DicomPlane>& planes);

}  // namespace odontoscope
