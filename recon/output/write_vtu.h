#pragma once
// VTK's XML format for unstructured grids: the tetrahedra, for ParaView, meshio and solvers.
//
// Millimetres, double precision, base64 arrays. All structures in one piece; cell data `structure` counts them from 1
// (field data "structure NAME" holds the number of NAME), `label` is the material label.

#include <string>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

std::string vtu_bytes(const Reconstruction& reconstruction);

}  // namespace odontoscope
