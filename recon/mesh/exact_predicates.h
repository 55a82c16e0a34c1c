#pragma once
// Signs that must be right: exact for every finite double, at nearly the cost of plain arithmetic.

#include "recon/core/geometry.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

/// +1 if det(b-a, c-a, d-a) > 0 (a positive tetrahedron, see meshes.h), -1 if negative, 0 if flat.
int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// True if the three points lie on one line, or two of them at one place: the triangle has no area at all.
bool collinear(const Point3& a, const Point3& b, const Point3& c);

/// Sign of the volume that closed, oriented triangles enclose (a subset of those of `mesh`, by number).
int volume_sign(const SurfaceMesh& mesh, const std::vector<std::size_t>& triangles);

}  // namespace odontoscope
