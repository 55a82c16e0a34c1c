#pragma once
// Voxels as a DICOM segmentation image, binary (PS3.3, A.51 and C.8.20), in explicit little-endian coding.
//
// One frame for each segment and slice that has a voxel of it, segment by segment from the lowest slice on, each with
// its place (plane position), its segment, and, where it lies on an image of the series that was read, that image as
// its source. Orientation and spacing are shared by all. Pixels are packed eight to a byte, the first in the lowest
// bit, frames without a gap. Each segment has a code for what it is and the colour to show it in (segment_look.h).

#include <string>

#include "recon/segmentation/dicom_common.h"
#include "recon/segmentation/voxel_grid.h"

namespace odontoscope {

/// Same input, same bytes, identifiers too. UsageError if no voxel is set (none is larger than a structure is thin), or
/// if there are more than 4 GiB of pixels or 65535 rows or columns.
std::string seg_bytes(const Segmentation& segmentation, const PatientOrigin& origin, const WrittenBy& by = {});

}  // namespace odontoscope
