#pragma once
// A closed surface cut by a plane of constant z, as closed polygons.

#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope::cavity {

using Loop = std::vector<Point2>;

/// Precondition: a closed oriented manifold. A vertex in the plane counts as above it.
std::vector<Loop> loops_at(const SurfaceMesh& surface, double z);
bool is_inside(const Loop& loop, const Point2& place);

}  // namespace odontoscope::cavity
