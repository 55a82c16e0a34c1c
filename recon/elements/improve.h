#pragma once
// Elements of bad angles made better by moving their corners: inside a material freely, on an interface within it, on
// junction lines and rims not at all.

#include "recon/core/progress.h"
#include "recon/elements/interface_shape.h"
#include "recon/mesh/labelled_complex.h"

namespace odontoscope::elements {

/// Precondition: the tetrahedra, those of void (label 0) among them, fill a convex hull; all are positive. So they
/// stay, and since the hull's own points are not moved, nothing overlaps: the interfaces still cut and touch nothing.
/// Vertices of interfaces stay as near to the `exact` shape as they were meshed. One thread; deterministic. Throws
/// Cancelled.
void improve(LabelledComplex& complex, const InterfaceShape& exact, const Progress& progress);

}  // namespace odontoscope::elements
