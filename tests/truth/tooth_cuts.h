#pragma once
// A turned tooth cut into what the program reads: contours, or a label map and its contours.

#include <optional>

#include "recon/input/contour_stack.h"
#include "recon/volume/volume.h"
#include "turned_tooth.h"

namespace odontoscope::test {

struct Fineness {
  double step = 0.05;        // mm; of the grid on which contours are traced
  double deviation = 0.006;  // mm; by which they are simplified then
};

/// Contours of all structures on planes `spacing` apart, by marching squares with interpolation. Passes `validate`.
ContourStack contours_of(const TurnedTooth& tooth, double spacing, const Fineness& fineness = {});

/// Voxels of a label map, mm: dyadic ones are exact in binary, decimal ones (0.1, 0.15) are not.
struct VoxelSize {
  double in_plane = 0.1, along_z = 0.25;
};
/// Dyadic for even seeds, where `along_z` is the multiple of 1/16 mm nearest to the spacing; decimal for odd ones.
VoxelSize voxel_size(const RandomTooth& tooth, double spacing);

/// Each voxel is what its centre lies in: 1 enamel, 2 dentine, 3 pulp, 0 none; no gap between structures.
Volume label_map(const TurnedTooth& tooth, const VoxelSize& voxel);

/// Contours of that label map, as `odontoscope contours --label 1=enamel --label 2=dentine --label 3=pulp` has them,
/// with
/// --smooth and --simplify if they are given (mm): on the volume's lattice.
ContourStack label_map_contours(const TurnedTooth& tooth, double spacing, std::optional<double> smooth = {},
                                std::optional<double> simplify = {});

}  // namespace odontoscope::test
