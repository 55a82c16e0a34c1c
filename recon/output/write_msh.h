#pragma once
// Gmsh's format, version 4.1, text: the tetrahedra and their walls, for Gmsh, FEniCS, meshio and solvers.
//
// Millimetres, double precision without loss. Each structure is a volume, each of its walls ("NAME external", "NAME
// cavity") a surface, and each of them a physical group of that name. Structures do not share nodes; those of a
// partition do: its surfaces are then the borders of two materials and the outside of each (complex_groups.h), every
// face once. Comments hold unit and certificate.

#include <string>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

std::string msh_text(const Reconstruction& reconstruction);

}  // namespace odontoscope
