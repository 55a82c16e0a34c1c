#pragma once
// Voxels as a label map: NRRD with the keys of 3D Slicer's segmentations (.seg.nrrd), which names its segments; any
// program that reads NRRD takes it for a plain label map.
//
// A voxel's value is the number of its segment, from 1 on, 0 for none. Where segments overlap the later one has the
// voxel. Packed by gzip; space left-posterior-superior, axes and origin in the patient.

#include <cstddef>
#include <string>

#include "recon/input/patient_origin.h"
#include "recon/segmentation/voxel_grid.h"

namespace odontoscope {

/// Same input, same bytes.
std::string label_map_bytes(const Segmentation& segmentation, const PatientFrame& frame);

/// Voxels that more than one segment has, of which a label map keeps the last.
std::size_t overlapping_voxels(const Segmentation& segmentation);

}  // namespace odontoscope
