#pragma once
// Bounds of the last resort (block.h); those of the DT engine itself are in recon/core/limits.h.

namespace odontoscope::limits {

/// Height of the upright prisms beside a block, over the slab's height: the block takes an eighth.
inline constexpr double block_height = 7.0 / 16;
/// The least step from the block's middle towards a corner at which a place for its inner point is looked for.
inline constexpr double block_steps = 1.0 / 256;

}  // namespace odontoscope::limits
