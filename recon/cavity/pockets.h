#pragma once
// Canals that open to the outside: deep and narrow pockets of a solid, closed by flat caps.

#include <string>
#include <vector>

#include "recon/cavity/cavity.h"

namespace odontoscope::cavity {

/// A place belongs to a pocket if, in its plane of constant z, material lies all around it. Where a plane is the last
/// one in which that is so, a flat cap in that plane is its mouth: at the end slice of a tooth that is cut off, at the
/// rim of an access cavity. Pockets count if they are deep for their widest mouth (see limits::pocket_depth), so that
/// the dip between cusps does not, and if nothing of `others` lies in a mouth. Not found: what opens sideways all
/// along, and mouths with an island of material in them. Caps lie up to a hundredth of the surface's height (at its
/// very ends a thousandth) inside of the true rim. Precondition: indices in range. Surfaces that are no closed oriented
/// manifold have no pockets. Deterministic.
std::vector<Cavity> pockets_of(const StructureSurface& part, const SurfaceReport& report,
                               const std::vector<const SurfaceMesh*>& others);

}  // namespace odontoscope::cavity
