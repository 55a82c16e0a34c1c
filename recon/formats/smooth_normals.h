#pragma once
// One normal for each corner, shared by the corners of a vertex that no crease parts.

#include <cstdint>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/mesh/vector.h"

namespace odontoscope {

struct ShadedVertices {
  std::vector<Direction> normals;   // of the vertices as drawn, unit length
  std::vector<PointIndex> point;    // of each the point of the surface that it stands at
  std::vector<Triangle> triangles;  // as those of the surface, by number of drawn vertex
};

/// Triangles that meet at an edge with more than `crease_angle_deg` between their normals are shaded apart, and so are
/// those at edges with one or more than two triangles. A normal is the mean of its triangles', weighted by their angle
/// at the vertex (G. Thuermer, C. Wuethrich, "Computing vertex normals from polygonal facets", 1998). Drawn vertices
/// come in order of first use.
ShadedVertices smooth_normals(const SurfaceMesh& surface, double crease_angle_deg);

}  // namespace odontoscope
