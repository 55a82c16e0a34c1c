#pragma once
// Tetrahedra between given interfaces: constrained, so that every triangle of the interfaces is a face of them, as it
// is; refined inside alone.
//
// By TetGen (H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", ACM TOMS 41(2), 2015), in a child
// process (work_apart.h), since it ends the program or runs for ever where it meets its limits. What comes back is
// proven by elements.h.

#include <optional>

#include "recon/core/progress.h"
#include "recon/mesh/labelled_complex.h"

namespace odontoscope::elements {

/// Was this library built with TetGen?
bool can_fill();

/// `bounds` has points and interfaces, no tetrahedra; the result has both, the points of `bounds` first, and fills the
/// convex hull: void has tetrahedra, too (label 0). `volume`: of the largest tetrahedron, mm^3. Nothing if TetGen finds
/// no way. The same input gives the same bytes. Throws Cancelled, FileError.
std::optional<LabelledComplex> fill(const LabelledComplex& bounds, double volume, const Progress& progress);

/// Takes out the tetrahedra of void, and the points that only they had.
void drop_void(LabelledComplex& complex);

}  // namespace odontoscope::elements
