#pragma once
// Marching cubes over a field: the surface where it passes zero, as the chosen table of cases has it.
//
// A grid point is inside if its value is below 0; 0 counts as outside. Each grid edge from inside to outside carries
// one point of the surface, placed by linear interpolation; triangles share points by grid edge, never by place, so
// that topology is what the table made it. Where a contour passes exactly through a grid point, the points of all its
// edges lie on that grid point: the triangles between them have no area, are kept, and count as degenerate. (Formats
// that join points by place, STL and GLB, then come out with another topology.) Nothing is flipped, dropped or painted.
//
// With CaseTable::consistent every edge has two triangles that run through it in opposite ways and every vertex one
// fan. With the other tables defects are what docs/distance.md says, and defects.h tells the reason of each.

#include <cstdint>
#include <vector>

#include "recon/core/progress.h"
#include "recon/distance/cases.h"
#include "recon/distance/field.h"
#include "recon/distance/grid.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

struct MarchedSurface {
  SurfaceMesh mesh;                         // points in mm, by layer, then row, then column of their grid edge
  std::vector<GridEdge> edge_of_point;      // ascending in that order, one for each point
  std::vector<GridPlace> cell_of_triangle;  // likewise
};

/// Preconditions: the field was sampled on `grid`; all values finite, those on the border of the grid not negative
/// (InternalError if a surface would leave the grid). Parallel over layers in the caller's TBB arena; the same bytes on
/// any number of threads. Stage: "marching cubes". Throws Cancelled, and UsageError beyond limits::triangles.
MarchedSurface march(const Grid& grid, const Field& field, CaseTable table, const Progress& progress = {});

/// Case of a cell. Precondition: no cell beyond the last column, row or layer but one.
CaseNumber case_at(const Grid& grid, const Field& field, const GridPlace& cell);

}  // namespace odontoscope
