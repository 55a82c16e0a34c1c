#pragma once
// A volume in bricks, so that rays pass over those that have nothing to show.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/scene/value_grid.h"

namespace odontoscope {

/// Values along a brick's side.
inline constexpr std::size_t brick_side = 8;

struct BrickGrid {
  std::array<std::size_t, 3> size{};
  /// Of all values that interpolation within a brick makes use of, those at its far sides included; x runs fastest,
  /// then y, then z.
  std::vector<float> lowest, highest;
};

BrickGrid brick_grid(const ValueGrid& grid);

/// Of each brick, how many bricks away the nearest is that `shows` (given its lowest and highest value), the larger of
/// the three axes' counts: 0 of such a brick itself, 255 at most.
std::vector<std::uint8_t> distances_to_shown(const BrickGrid& bricks,
                                             const std::function<bool(float lowest, float highest)>& shows);

}  // namespace odontoscope
