#pragma once
// Does a surface cut through itself? The one question that its topology does not answer.

#include <cstddef>
#include <utility>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

/// Pairs of triangles (by number, the smaller first, sorted) that meet in more than the vertices and edges that they
/// share by index. Exact. Two shells that touch in a point count as meeting. Precondition: no non-manifold edges,
/// consistently oriented (`inspect` tells); InternalError otherwise. About 5 microseconds a triangle.
std::vector<std::pair<std::size_t, std::size_t>> self_intersections(const SurfaceMesh& mesh);

}  // namespace odontoscope
