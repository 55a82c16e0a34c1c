#pragma once
// Bounds of interpolated and of conformed slices and of the last resort (block.h); those of the DT engine itself are in
// recon/core/limits.h.

#include <cstddef>

namespace odontoscope::limits {

/// Points that conforming may add to an interpolated slice, as a multiple of those traced plus a free allowance.
inline constexpr std::size_t interpolated_added = 4, interpolated_added_free = 1000;
/// Contours of an interpolated slice, as a multiple of those of both given ones plus a free allowance.
inline constexpr std::size_t interpolated_contours = 8, interpolated_contours_free = 32;
/// Free allowance of points that conforming may add to a slice for Gabriel edges and for Delaunay ones. Along two
/// needles that cross, each edge below meets each above: ten thousand on either side make tens of millions of
/// tetrahedra.
inline constexpr std::size_t gabriel_free = 1000, delaunay_free = 2500;
/// Height of the upright prisms beside a block, over the slab's height: the block takes an eighth.
inline constexpr double block_height = 7.0 / 16;
/// The least step from the block's middle towards a corner at which a place for its inner point is looked for.
inline constexpr double block_steps = 1.0 / 256;

}  // namespace odontoscope::limits
