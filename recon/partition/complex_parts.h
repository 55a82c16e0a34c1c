#pragma once
// Views of a labelled complex: its interfaces, and each material's solid and surface.

#include <vector>

#include "recon/mesh/labelled_complex.h"

namespace odontoscope::partition {

/// Every face between two labels, in the order of the tetrahedra. Throws InternalError if three tetrahedra share a face, or two lie on one side
/// of it.
std::vector<InterfaceTriangle> interfaces_of(const TetraMesh& mesh);

/// The closed surface of one material, or of all together (void_label), turned outwards; its points are a subset, in the same order.
SurfaceMesh surface_of(const LabelledComplex& complex, Label label);

/// The tetrahedra of one material; their points are a subset, in the same order.
TetraMesh tetrahedra_of(const LabelledComplex& complex, Label label);

/// Takes out points that no tetrahedron has.
void drop_unused(TetraMesh& mesh, std::vector<InterfaceTriangle>& interfaces);

}  // namespace odontoscope::partition
