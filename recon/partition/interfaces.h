#pragma once
// Where the materials of a complex meet each other, and the void.

#include <vector>

#include "recon/mesh/labelled_complex.h"

namespace odontoscope::partition {

/// Every face between two labels, in the order of the tetrahedra. Throws InternalError if three tetrahedra share a
/// face, or two lie on one side of it.
std::vector<InterfaceTriangle> interfaces_of(const TetraMesh& mesh);

}  // namespace odontoscope::partition
