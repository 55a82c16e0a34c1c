#pragma once
// Small reconstructions made by hand.

#include "recon/delaunay/reconstruct.h"

namespace odontoscope::models {

/// A solid of the given surface with a few tetrahedra that need not fill it, and the surface's report.
Solid solid(const std::string& structure, const SurfaceMesh& surface);

/// A tooth with a pulp cavity, and a separate enamel.
Reconstruction tooth_and_enamel();

}  // namespace odontoscope::models
