#pragma once
// The field of the DB engine: on each grid point the signed distance to a structure's contours, after section 3.1 of
// the paper.
//
// Sign: negative inside, positive outside, 0 exactly on a contour. (The paper contradicts itself; with this sign the
// winding of the surface follows.) Inside and on are decided by exact predicates on the numbers as they are; a point
// that is not on a contour is never 0. The distance is Euclidean, in the slice's plane, to the nearest point of the
// nearest contour edge: no approximation but rounding. An empty layer (an extra one, a split, a slice in which the
// structure has no contour) has no nearest contour and holds +1 throughout, as the paper's does; beside distances in
// millimetres that makes the shape of caps depend on the unit.
//
// signed_distance: the distance at every point.
// sign: -1, 0 or +1: surfaces in steps of half a cell.
// hybrid: the paper's: distances only at the points of voxels that the surface crosses, -1 and +1 elsewhere. A voxel is
// crossed unless its eight points are all inside or all outside; voxels at an empty layer never count as crossed.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/named.h"
#include "recon/core/progress.h"
#include "recon/distance/grid.h"
#include "recon/distance/limits.h"

namespace odontoscope {

enum class FieldKind { signed_distance, sign, hybrid };

struct FieldOptions {
  FieldKind kind = FieldKind::hybrid;
};

struct Field {
  std::string structure;
  std::vector<double> values;  // by Grid::index, mm
};

/// Precondition: `grid` was made for `ordered_stack`. The work is shared among layers in the caller's TBB arena; the
/// result does not depend on the number of threads. Stage: "distance field". Throws Cancelled.
Field sample_field(const ContourStack& ordered_stack, const std::string& structure, const Grid& grid,
                   const FieldOptions& options = {}, const Progress& progress = {});

inline constexpr NameTable<FieldKind, 3> field_kinds{
    {{"signed-distance", FieldKind::signed_distance}, {"sign", FieldKind::sign}, {"hybrid", FieldKind::hybrid}}};
inline const char* name(FieldKind kind) { return word_of(field_kinds, kind); }

}  // namespace odontoscope
