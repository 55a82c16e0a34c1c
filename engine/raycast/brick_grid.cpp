#include "engine/raycast/brick_grid.h"

#include <algorithm>
#include <limits>

namespace odontoscope {

BrickGrid brick_grid(const ValueGrid& grid) {
  BrickGrid bricks;
  for (std::size_t n = 0; n < 3; ++n) bricks.size[n] = (grid.size[n] + brick_side - 1) / brick_side;
  const std::size_t count = bricks.size[0] * bricks.size[1] * bricks.size[2];
  bricks.lowest.assign(count, std::numeric_limits<float>::max());
  bricks.highest.assign(count, std::numeric_limits<float>::lowest());
  // A value that begins a brick is the one before's last, too.
  const auto first = [](std::size_t index) {
    return index > 0 && index % brick_side == 0 ? index / brick_side - 1 : index / brick_side;
  };
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j) {
      const float* row = grid.values.data() + (k * grid.size[1] + j) * grid.size[0];
      for (std::size_t z = first(k); z <= k / brick_side; ++z)
        for (std::size_t y = first(j); y <= j / brick_side; ++y) {
          const std::size_t start = (z * bricks.size[1] + y) * bricks.size[0];
          for (std::size_t x = 0; x < bricks.size[0]; ++x) {
            const auto [low, high] =
                std::minmax_element(row + x * brick_side, row + std::min((x + 1) * brick_side + 1, grid.size[0]));
            bricks.lowest[start + x] = std::min(bricks.lowest[start + x], *low);
            bricks.highest[start + x] = std::max(bricks.highest[start + x], *high);
          }
        }
    }
  return bricks;
}

std::vector<std::uint8_t> distances_to_shown(const BrickGrid& bricks,
                                             const std::function<bool(float lowest, float highest)>& shows) {
  std::vector<std::uint8_t> distance(bricks.lowest.size(), 255);
  for (std::size_t i = 0; i < distance.size(); ++i)
    if (shows(bricks.lowest[i], bricks.highest[i])) distance[i] = 0;
  // Chessboard distance: sweeps forth and back over the 26 neighbours, each time those that were visited already
  // (Rosenfeld and Pfaltz, 1966).
  const std::size_t nx = bricks.size[0], ny = bricks.size[1], nz = bricks.size[2];
  const auto visit = [&](std::size_t x, std::size_t y, std::size_t z, int towards) {
    std::uint8_t& own = distance[(z * ny + y) * nx + x];
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if ((9 * dz + 3 * dy + dx) * towards <= 0) continue;
          const std::size_t i = x + static_cast<std::size_t>(dx), j = y + static_cast<std::size_t>(dy),
                            k = z + static_cast<std::size_t>(dz);  // below 0 wraps beyond the size
          if (i >= nx || j >= ny || k >= nz) continue;
          own = static_cast<std::uint8_t>(std::min<int>(own, std::min(distance[(k * ny + j) * nx + i] + 1, 255)));
        }
  };
  for (std::size_t z = 0; z < nz; ++z)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t x = 0; x < nx; ++x) visit(x, y, z, -1);
  for (std::size_t z = nz; z-- > 0;)
    for (std::size_t y = ny; y-- > 0;)
      for (std::size_t x = nx; x-- > 0;) visit(x, y, z, 1);
  return distance;
}

}  // namespace odontoscope
