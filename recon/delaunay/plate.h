#pragma once
// Isolated regions: linked to nothing above and nothing below, they would have no volume at all, and the solid would miss them on their own
// slice. Each becomes a thin plate into the slabs on both sides of its slice (at the ends of the stack: one side).

#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/delaunay/lift.h"

namespace odontoscope::delaunay {

/// The region of slice `home` thickened by `height` (positive: upwards) as prisms over its triangles. `lower` and `upper` are the
/// slab's slices; `home` is one of them. A slab beside a slice without contours has that slice as an empty one.
SlabSolid plate(const ConformedSlice& lower, const ConformedSlice& upper, bool home_is_lower, std::uint32_t region, double height);

/// Adds plates for the regions flagged in `lower_isolated` (upwards) and `upper_isolated` (downwards) to `pieces`, each as high
/// as limits::plate_height says, halved until it is clear of all other pieces. Throws InternalError if it never is.
void add_plates(const ConformedSlice& lower, const ConformedSlice& upper, const std::vector<bool>& lower_isolated,
                const std::vector<bool>& upper_isolated, std::vector<SlabSolid>& pieces);

}  // namespace odontoscope::delaunay
