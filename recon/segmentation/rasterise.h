#pragma once
// Contours and solids as voxels: a voxel belongs to a structure if its centre lies in it.
//
// Decided by exact predicates on the doubles of centre, points and triangles. A centre on a border counts as if it lay
// further along x by less than any number, further along y by much less, and along z by less still (simulation of
// simplicity: H. Edelsbrunner and E. P. Muecke, ACM Transactions on Graphics 9(1), 1990): it belongs to what lies
// beyond it along x, and on a border along x to what lies beyond along y. So of two regions that share a border each
// centre on it belongs to exactly one.

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"
#include "recon/segmentation/voxel_grid.h"

namespace odontoscope {

/// The planes of a stack's slices as slices of voxels, `spacing` wide along x and y, around all contours as grid_around
/// has it. Slices must lie evenly, within limits::slice_unevenness of their distance: InputError uneven-slices;
/// single-slice. `origin` for x and y, if given, as for grid_from.
VoxelGrid grid_of_slices(const ContourStack& stack, double spacing_x, double spacing_y, const Point2* origin = nullptr);

/// Each structure of the stack as a segment, in order of first appearance. Each slice goes to the voxels whose height
/// is nearest; those of the grid that have none are empty, and contours beyond the grid are cut off. Preconditions:
/// `validate` passed; no two slices are nearest to one height. Stage "voxels".
Segmentation rasterised(const ContourStack& stack, const VoxelGrid& grid, const Progress& progress = {});

/// A closed, oriented surface that does not cross itself, such as a solid's.
struct FilledSurface {
  std::string name;
  const SurfaceMesh* surface = nullptr;
};

/// Voxels whose centres lie within the surfaces, between slices too. Stage "voxels".
Segmentation rasterised(const std::vector<FilledSurface>& solids, const VoxelGrid& grid, const Progress& progress = {});

}  // namespace odontoscope
