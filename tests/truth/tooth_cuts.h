#pragma once
// A turned tooth cut into what the program reads: contours, or a label map and its contours.

#include <optional>

#include "recon/input/contour_stack.h"
#include "recon/volume/volume.h"
#include "turned_tooth.h"

namespace odontoscope::test {

/// Contours of all structures on planes `spacing` apart: marching squares with interpolation on a grid of `step`, then
/// simplified within 0.006 mm. Passes `validate`.
ContourStack contours_of(const TurnedTooth& tooth, double spacing, double step = 0.05);

/// Voxels of a label map, mm: dyadic ones are exact in binary, decimal ones (0.1, 0.15) are not.
struct VoxelSize {
  double in_plane = 0.1, along_z = 0.25;
};
/// Dyadic for even seeds, where `along_z` is the multiple of 1/16 mm nearest to the spacing; decimal for odd ones.
VoxelSize voxel_size(const RandomTooth& tooth, double spacing);

/// Each voxel is what its centre lies in: 1 enamel, 2 dentine, 3 pulp, 0 none; no gap between structures.
Volume label_map(const TurnedTooth& tooth, const VoxelSize& voxel);

/// Contours of that label map, as `odontoscope contours --label 1=enamel --label 2=dentine --label 3=pulp` has them, with
/// --smooth if it is given (mm): on the volume's lattice.
ContourStack label_map_contours(const TurnedTooth& tooth, double spacing, std::optional<double> smooth = {});

}  // namespace odontoscope::test
