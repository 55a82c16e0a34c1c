#pragma once
// VTK's XML format for unstructured grids: the tetrahedra, for ParaView, meshio and solvers.
//
// Millimetres, double precision, base64 arrays. All structures in one piece; cell data `structure` counts them from 1
// (field data "structure NAME" holds the number of NAME), `label` is the material label. Of a partition: its
// tetrahedra, and after them a triangle for each face between two labels, once, with the labels on its two sides in
// `inner` and `outer` (0 is void; of a tetrahedron both are its own).

#include <string>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

std::string vtu_bytes(const Reconstruction& reconstruction);

}  // namespace odontoscope
