#pragma once
// Bounds of this room alone; those that others share are in recon/core/limits.h.

#include <cstddef>

namespace odontoscope::limits {

/// Frames of a DICOM segmentation, which has one for each segment and slice: two hundred segments in a thousand slices.
inline constexpr std::size_t segment_frames = 200'000;
/// Ways in which the segments of a segmentation overlap: each is a value of its own.
inline constexpr std::size_t label_overlaps = 4096;
/// Frames within this distance of each other lie in one plane, mm: well below any voxel, and above what positions of 16
/// characters round to.
inline constexpr double one_plane = 1e-4;

/// Characters and parts of a name in a DICOMDIR; the standard allows 8 parts of 8 characters.
inline constexpr std::size_t file_id_length = 1024, file_id_parts = 16;
/// Names of files that a message repeats.
inline constexpr std::size_t names_told = 3;

}  // namespace odontoscope::limits
