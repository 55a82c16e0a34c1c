#pragma once
// How long the edges of elements should be at each vertex of the interfaces: as asked for where materials are thick,
// shorter where they are thin, so that a canal stays round and a thin wall has elements through it.

#include <vector>

#include "recon/mesh/interface_web.h"

namespace odontoscope::elements {

/// mm, one a vertex. Thickness is measured from each face into the materials on its sides, to where a ray leaves
/// through a wall that is turned away from it; sizes change by no more than limits::size_gradient along an edge.
std::vector<double> size_field(const InterfaceWeb& web, double size);

}  // namespace odontoscope::elements
