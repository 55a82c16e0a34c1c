#include "engine/scene/value_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odontoscope {

namespace {

using Counts = std::array<std::size_t, 3>;

/// Voxels from `first` on, `count` of them along each axis.
struct Crop {
  Counts first{}, count{};
};

Crop around(const Volume& volume, const Box& bounds_mm) {
  const glm::dvec3 origin(volume.origin.x, volume.origin.y, volume.origin.z);
  Crop crop;
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(axis);
    const double last = static_cast<double>(volume.size[n] - 1);
    const auto index = [&](double place_mm) { return (place_mm - origin[axis]) / volume.spacing[n]; };
    const double low = std::clamp(std::floor(index(bounds_mm.low[axis])) - 1, 0.0, last);
    const double high = std::clamp(std::ceil(index(bounds_mm.high[axis])) + 1, low, last);
    crop.first[n] = static_cast<std::size_t>(low);
    crop.count[n] = static_cast<std::size_t>(high - low) + 1;
  }
  return crop;
}

/// Divided, rounded up.
std::size_t blocks(std::size_t count, std::size_t merged) { return (count + merged - 1) / merged; }

Counts merged_within(const ValueGridLimits& limits, const Crop& crop, const Volume& volume) {
  Counts merged{1, 1, 1};
  for (std::size_t n = 0; n < 3; ++n) merged[n] = blocks(crop.count[n], limits.longest_side);
  const auto size = [&](std::size_t n) { return blocks(crop.count[n], merged[n]); };
  while (size(0) * size(1) * size(2) > limits.most_values) {
    std::size_t finest = 3;
    for (std::size_t n = 0; n < 3; ++n) {
      const bool finer = finest == 3 || volume.spacing[n] * static_cast<double>(merged[n]) <
                                            volume.spacing[finest] * static_cast<double>(merged[finest]);
      if (size(n) > 1 && finer) finest = n;
    }
    ++merged[finest];
  }
  return merged;
}

/// The mean of the block of voxels that begins at `from`.
float mean(const Volume& volume, const Counts& from, const Counts& merged) {
  const auto within = [&](std::size_t n, std::size_t index) { return std::min(index, volume.size[n] - 1); };
  double sum = 0;
  for (std::size_t k = 0; k < merged[2]; ++k)
    for (std::size_t j = 0; j < merged[1]; ++j) {
      const float* row = volume.slice(within(2, from[2] + k)) + within(1, from[1] + j) * volume.size[0];
      for (std::size_t i = 0; i < merged[0]; ++i) sum += static_cast<double>(row[within(0, from[0] + i)]);
    }
  return static_cast<float>(sum / static_cast<double>(merged[0] * merged[1] * merged[2]));
}

/// Never without width.
ValueWindow window(double low, double high) {
  return {low, high > low ? high : low + std::max(1.0, 1e-6 * std::abs(low))};
}

/// Of so many values, spread evenly, which takes no second copy of all.
ValueWindow usual_window(const std::vector<float>& values) {
  constexpr std::size_t most = 1u << 20;
  const std::size_t stride = blocks(values.size(), most);
  std::vector<float> sample;
  sample.reserve(values.size() / stride + 1);
  for (std::size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  const auto quantile = [&](double part) {
    const auto place = sample.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), place, sample.end());
    return static_cast<double>(*place);
  };
  const double low = quantile(usual_low);
  return window(low, quantile(usual_high));
}

}  // namespace

namespace {

/// Everything but the values.
ValueGrid grid_of(const Volume& volume, const Crop& crop, const ValueGridLimits& limits) {
  ValueGrid grid;
  grid.merged = merged_within(limits, crop, volume);
  const glm::dvec3 origin(volume.origin.x, volume.origin.y, volume.origin.z);
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(axis);
    const auto together = static_cast<double>(grid.merged[n]);
    grid.size[n] = blocks(crop.count[n], grid.merged[n]);
    grid.step_mm[axis] = together * volume.spacing[n];
    // The middle of the first block, whose voxels' centres lie (together - 1) spacings apart.
    grid.first_mm[axis] =
        origin[axis] + (static_cast<double>(crop.first[n]) + 0.5 * (together - 1)) * volume.spacing[n];
  }
  return grid;
}

/// Once it has its values.
void finish(const Volume& volume, ValueGrid& grid) {
  for (std::size_t n = 0; n < 3; ++n) grid.merged[n] *= volume.merged[n];
  const auto [lowest, highest] = std::minmax_element(grid.values.begin(), grid.values.end());
  grid.range = window(static_cast<double>(*lowest), static_cast<double>(*highest));
  grid.usual = usual_window(grid.values);
}

}  // namespace

ValueGrid value_grid(const Volume& volume, const Box& bounds_mm, const ValueGridLimits& limits) {
  const Crop crop = around(volume, bounds_mm);
  ValueGrid grid = grid_of(volume, crop, limits);
  grid.values.reserve(grid.size[0] * grid.size[1] * grid.size[2]);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        grid.values.push_back(mean(volume,
                                   {crop.first[0] + i * grid.merged[0], crop.first[1] + j * grid.merged[1],
                                    crop.first[2] + k * grid.merged[2]},
                                   grid.merged));
  finish(volume, grid);
  return grid;
}

ValueGrid value_grid(Volume&& volume, const Box& bounds_mm, const ValueGridLimits& limits) {
  const Crop crop = around(volume, bounds_mm);
  ValueGrid grid = grid_of(volume, crop, limits);
  if (grid.size != volume.size) return value_grid(static_cast<const Volume&>(volume), bounds_mm, limits);
  grid.values = std::move(volume.values);
  finish(volume, grid);
  return grid;
}

}  // namespace odontoscope
