#include "recon/distance/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/error.h"
#include "recon/distance/limits.h"

namespace odontoscope {
namespace {

struct Bounds {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// `points` grid points over the bounds and half a spacing beyond.
struct Axis {
  double origin, spacing;
};
Axis axis_over(const Bounds& bounds, std::size_t points) {
  const double spacing = (bounds.high - bounds.low) / static_cast<double>(points - 2);
  const Axis axis{bounds.low - spacing / 2, spacing};
  const double last = axis.origin + static_cast<double>(points - 1) * spacing;
  bool apart = spacing > 0 && axis.origin < bounds.low && last > bounds.high;
  // Rounding is coarsest at the end that is farthest from zero, and each end is one.
  for (const std::size_t i : {std::size_t{0}, points - 2}) {
    apart =
        apart && axis.origin + static_cast<double>(i) * spacing < axis.origin + static_cast<double>(i + 1) * spacing;
  }
  if (apart) return axis;
  throw UsageError(fmt::format("a grid of {} points is finer than numbers near {} can tell apart", points, bounds.low),
                   "Use a coarser grid, or move the contours nearer to the origin");
}

void check_counts(const GridOptions& options, std::size_t layers, std::size_t structures) {
  for (const std::size_t points : {options.columns, options.rows}) {
    if (points >= limits::least_grid_points && points <= limits::most_grid_points) continue;
    throw UsageError(fmt::format("a grid of {} points along an axis", points),
                     fmt::format("Use {} to {}", limits::least_grid_points, limits::most_grid_points));
  }
  const std::size_t most = limits::grid_values / std::max<std::size_t>(layers * structures, 1);
  if (options.columns * options.rows <= most) return;
  const auto square = static_cast<std::size_t>(std::sqrt(static_cast<double>(most)));
  throw UsageError(
      fmt::format("{} x {} grid points in {} layers for {} structure{} are more than {} values", options.columns,
                  options.rows, layers, structures, structures == 1 ? "" : "s", limits::grid_values),
      square >= limits::least_grid_points ? fmt::format("At most {} x {} fit here", square, square)
                                          : "Reconstruct fewer slices or structures at once");
}

void add_splits(std::vector<GridLayer>& layers, const std::vector<double>& splits) {
  const double first = layers.front().z, last = layers.back().z;
  for (const double z : splits) {
    if (!(z > first && z < last)) {
      throw UsageError(fmt::format("a split at z = {} is not between the slices", z),
                       fmt::format("Slices reach from z = {} to {}", first, last));
    }
    const auto above = std::lower_bound(layers.begin(), layers.end(), z,
                                        [](const GridLayer& layer, double height) { return layer.z < height; });
    if (above->z == z) {
      throw UsageError(
          fmt::format("a split at z = {}, where there is {} already", z, above->slice ? "a slice" : "a split"),
          "Give a height between two slices, each only once");
    }
    layers.insert(above, {z, std::nullopt});
  }
}

}  // namespace

Grid make_grid(const ContourStack& ordered_stack, const GridOptions& options, std::size_t structures) {
  const auto& slices = ordered_stack.slices;
  if (slices.size() < 2) throw UsageError("a grid needs two slices or more");
  check_counts(options, slices.size() + options.splits.size() + 2, structures);
  Bounds in_x, in_y;
  for (const Slice& slice : slices) {
    for (const Contour& contour : slice.contours) {
      for (const Point2& p : contour.points) {
        in_x.add(p.x);
        in_y.add(p.y);
      }
    }
  }
  const Axis along_x = axis_over(in_x, options.columns), along_y = axis_over(in_y, options.rows);
  Grid grid{along_x.origin, along_y.origin, along_x.spacing, along_y.spacing, options.columns, options.rows, {}};
  for (std::size_t k = 0; k < slices.size(); ++k) grid.layers.push_back({slices[k].z, k});
  add_splits(grid.layers, options.splits);
  const double first = slices[0].z, last = slices.back().z;
  const double below = 2 * first - slices[1].z, above = 2 * last - slices[slices.size() - 2].z;
  if (!(below < first) || !(above > last)) throw UsageError("slices too close together for their height");
  grid.layers.insert(grid.layers.begin(), {below, std::nullopt});
  grid.layers.push_back({above, std::nullopt});
  return grid;
}

}  // namespace odontoscope
