#pragma once
// Isolated regions: linked to nothing above and nothing below, they would have no volume at all, and the solid would
// miss them on their own slice. Each becomes a thin plate into the slabs on both sides of its slice (at the ends of the
// stack: one side).

#include <optional>
#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/delaunay/lift.h"

namespace odontoscope::delaunay {

/// Which of a slab's two slices a region lies in.
enum class Home { lower, upper };

/// The region of slice `home` thickened by `height` (positive: upwards) as prisms over its triangles. `lower` and
/// `upper` are the slab's slices; `home` is one of them. A slab beside a slice without contours has that slice as an
/// empty one.
SlabSolid plate(const ConformedSlice& lower, const ConformedSlice& upper, Home home, std::uint32_t region,
                double height);

/// Plates for the regions flagged in `lower_isolated` (upwards) and `upper_isolated` (downwards), each as high as
/// limits::plate_height says, halved until it is clear of `pieces` and of the other plates. Empty if one finds no room:
/// beside pieces that are raised (raise.h) each does, as long as numbers lie between the heights.
std::optional<std::vector<SlabSolid>> plates(const ConformedSlice& lower, const ConformedSlice& upper,
                                             const std::vector<bool>& lower_isolated,
                                             const std::vector<bool>& upper_isolated,
                                             const std::vector<SlabSolid>& pieces);

}  // namespace odontoscope::delaunay
