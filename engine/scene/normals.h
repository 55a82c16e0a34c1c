#pragma once
// Normals for lighting. Front and back are never decided by them but by winding alone.

#include <glm/vec3.hpp>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

/// A normal for each corner of each triangle (3 * triangles): the mean of the normals of those triangles around the
/// vertex that meet this one at less than `crease_deg`, weighted by their angle there (Thuermer and Wuethrich, Journal
/// of Graphics Tools 3(1), 1998). An edge sharper than that stays sharp. Corners of a vertex that share their
/// neighbours get bit-equal normals. A triangle without area gets +z.
std::vector<glm::vec3> corner_normals(const SurfaceMesh& mesh, double crease_deg);

}  // namespace odontoscope
