#pragma once
// How ridged a surface is: the length of its edges, mm, at which the two triangles turn by more than `degrees`,
// whichever way they are wound. Triangles without area and edges with one triangle, or with more than two, do not
// count.

#include "recon/mesh/meshes.h"

namespace odontoscope {

double ridges_mm(const SurfaceMesh& mesh, double degrees = 30);

}  // namespace odontoscope
