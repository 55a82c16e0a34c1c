#pragma once
// How wide could one be in this cross-section? Asked of every triangle, in another way than the room itself does.

#include <vector>

#include "recon/core/geometry.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::test {

/// Distance to the nearest triangle, by trying all.
double brute_distance(const SurfaceMesh& wall, const Point3& from);

/// The largest distance to the wall in the plane through `from` at right angles to `along`, among all places that can
/// be reached from `from` in that plane without crossing the wall; looked for on a grid of `step`, no farther than
/// `reach`.
double widest_in_section(const SurfaceMesh& wall, const Point3& from, const Point3& along, double step, double reach);

}  // namespace odontoscope::test
