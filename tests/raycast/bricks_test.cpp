// Bricks know all values that matter within them, and how far the next is.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/raycast/brick_grid.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

ValueGrid noise(std::array<std::size_t, 3> size) {
  RandomNumbers random(5);
  ValueGrid grid;
  grid.size = size;
  for (std::size_t i = 0; i < size[0] * size[1] * size[2]; ++i)
    grid.values.push_back(static_cast<float>(random.unit()));
  return grid;
}

TEST(Bricks, KnowTheValuesThatTheyInterpolate) {
  for (const std::array<std::size_t, 3> size :
       {std::array<std::size_t, 3>{20, 9, 17}, {8, 16, 1}, {1, 1, 2}, {25, 8, 33}}) {
    const ValueGrid grid = noise(size);
    const BrickGrid bricks = brick_grid(grid);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(bricks.size[n], (size[n] + 7) / 8);
    for (std::size_t z = 0; z < bricks.size[2]; ++z)
      for (std::size_t y = 0; y < bricks.size[1]; ++y)
        for (std::size_t x = 0; x < bricks.size[0]; ++x) {
          float low = 9, high = -9;
          for (std::size_t k = 8 * z; k <= std::min(8 * z + 8, size[2] - 1); ++k)
            for (std::size_t j = 8 * y; j <= std::min(8 * y + 8, size[1] - 1); ++j)
              for (std::size_t i = 8 * x; i <= std::min(8 * x + 8, size[0] - 1); ++i) {
                const float value = grid.values[(k * size[1] + j) * size[0] + i];
                low = std::min(low, value);
                high = std::max(high, value);
              }
          const std::size_t brick = (z * bricks.size[1] + y) * bricks.size[0] + x;
          EXPECT_EQ(bricks.lowest[brick], low);
          EXPECT_EQ(bricks.highest[brick], high);
        }
  }
}

TEST(Bricks, KnowHowFarTheNextIsThatShows) {
  RandomNumbers random(9);
  for (int trial = 0; trial < 20; ++trial) {
    BrickGrid bricks;
    bricks.size = {static_cast<std::size_t>(random.whole(1, 9)), static_cast<std::size_t>(random.whole(1, 9)),
                   static_cast<std::size_t>(random.whole(1, 9))};
    const std::size_t count = bricks.size[0] * bricks.size[1] * bricks.size[2];
    for (std::size_t i = 0; i < count; ++i) bricks.lowest.push_back(random.chance(0.02) ? 1.0f : 0.0f);
    bricks.highest = bricks.lowest;
    const std::vector<std::uint8_t> found = distances_to_shown(bricks, [](float low, float) { return low > 0; });
    const auto coordinates = [&](std::size_t i) {
      return std::array<int, 3>{static_cast<int>(i % bricks.size[0]),
                                static_cast<int>(i / bricks.size[0] % bricks.size[1]),
                                static_cast<int>(i / bricks.size[0] / bricks.size[1])};
    };
    for (std::size_t i = 0; i < count; ++i) {
      int nearest = 255;
      for (std::size_t j = 0; j < count; ++j) {
        const auto a = coordinates(i), b = coordinates(j);
        if (bricks.lowest[j] > 0)
          nearest = std::min(nearest, std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}));
      }
      EXPECT_EQ(found[i], nearest);
    }
  }
}

TEST(Bricks, OfALongEmptyRowStayWithinAByte) {
  BrickGrid bricks;
  bricks.size = {400, 1, 1};
  bricks.lowest.assign(400, 0);
  bricks.lowest[0] = 1;
  bricks.highest = bricks.lowest;
  const std::vector<std::uint8_t> found = distances_to_shown(bricks, [](float low, float) { return low > 0; });
  EXPECT_EQ(found[7], 7);
  EXPECT_EQ(found[399], 255);
}

}  // namespace
}  // namespace odontoscope::test
