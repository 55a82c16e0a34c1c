#pragma once
// Parts of a labelled complex: the solid and the surface of each material.

#include <string>

#include "recon/mesh/labelled_complex.h"

namespace odontoscope {

/// Precondition: there is a structure of that name.
Label label_of(const LabelledComplex& complex, const std::string& structure);

/// The closed surface of one material, or of all together (void_label), turned outwards; its points are a subset, in
/// the same order.
SurfaceMesh surface_of(const LabelledComplex& complex, Label label);

/// The tetrahedra of one material; their points are a subset, in the same order.
TetraMesh tetrahedra_of(const LabelledComplex& complex, Label label);

/// Takes out points that no tetrahedron and no interface has.
void drop_unused(LabelledComplex& complex);

}  // namespace odontoscope
