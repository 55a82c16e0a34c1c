#pragma once
// A DICOM segmentation image (SEG) as a label map. Inner part of read_volume.h.
//
// PS3.3, A.51 and C.8.20. Binary: a frame of one bit a pixel (or 8) for each segment and slice; fractional: a
// probability or occupancy for each; label map: one frame a slice, whose pixels are segments' numbers. Frames come in
// any order, each with its place and its segment, and those in which a segment has nothing are left out. A voxel's
// value is its segment's number, 0 if it is of none; where segments overlap, each way of overlapping has a value of its
// own (Volume::overlaps). Of a fractional one those voxels are taken that are at least half a segment's, which is told.
//
// Slices are the planes in which any segment has a frame, and those at even distances between them. Their distance is
// the spacing between slices where the frames fit it, else the least distance of two frames; where all frames are
// several spacings apart, that wider distance, which is told.
//
// Not supported: frames without places, tiles of slides, binary ones that are compressed.

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/volume/dicom_image.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

/// `image` is_dicom_segmentation. Throws InputError single-slice, uneven-slices (frames that fit no even distance),
/// mixed-series (frames whose orientations or pixel spacings differ), sheared-volume (frames pushed sideways),
/// time-series (two frames of a segment in one place), unreadable-volume (a frame that does not tell its segment,
/// segments that share a number), too-many-structures (segments, or ways in which they overlap), and what stack_planes,
/// read_planes and validate_grid throw. Stage "read".
Volume dicom_segmentation(const DicomImage& image, const std::string& source, const ReadVolumeOptions& options,
                          const Progress& progress);

/// "pulp (2)", in the order of the file, in UTF-8.
std::vector<std::string> segment_names(const DicomImage& image);

}  // namespace odontoscope
