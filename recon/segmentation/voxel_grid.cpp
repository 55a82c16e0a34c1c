#include "recon/segmentation/voxel_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

void check_spacing(const std::array<double, 3>& spacing) {
  for (const double x : spacing) {
    if (std::isfinite(x) && x >= limits::smallest_spacing && x <= limits::largest_coordinate) continue;
    throw UsageError(fmt::format("voxels of {} x {} x {} mm make no sense", spacing[0], spacing[1], spacing[2]),
                     "Give three sizes in mm, as in 0.1,0.1,0.2");
  }
}

/// From whole number `first` to `last`, as a number of voxels; as many as a double can hold, to be refused later.
std::size_t count_of(double first, double last) {
  return static_cast<std::size_t>(std::clamp(last - first + 1, 1.0, 1e9));
}

}  // namespace

bool VoxelBits::any(std::size_t k) const {
  const auto first = bits_.begin() + static_cast<std::ptrdiff_t>(k * size_[1] * words_);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(size_[1] * words_),
                     [](std::uint64_t word) { return word != 0; });
}

std::size_t VoxelBits::count() const {
  std::size_t sum = 0;
  for (const std::uint64_t word : bits_) sum += static_cast<std::size_t>(std::popcount(word));
  return sum;
}

Box3 box_of(const ContourStack& stack) {
  constexpr double far = 2 * limits::largest_coordinate;
  Box3 box{{far, far, far}, {-far, -far, -far}};
  for (const Slice& slice : stack.slices) {
    box.low.z = std::min(box.low.z, slice.z);
    box.high.z = std::max(box.high.z, slice.z);
    for (const Contour& contour : slice.contours) {
      for (const Point2& p : contour.points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), box.low.z};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), box.high.z};
      }
    }
  }
  return box;
}

void check_grid(const VoxelGrid& grid) {
  const double voxels =
      static_cast<double>(grid.size[0]) * static_cast<double>(grid.size[1]) * static_cast<double>(grid.size[2]);
  if (voxels <= static_cast<double>(limits::voxels)) return;
  throw UsageError(fmt::format("{} x {} x {} voxels are more than the {} that are written", grid.size[0], grid.size[1],
                               grid.size[2], limits::voxels),
                   "Make voxels larger (--voxels X,Y,Z)");
}

VoxelGrid grid_around(const Box3& box, const std::array<double, 3>& spacing) {
  check_spacing(spacing);
  const std::array<double, 3> low{box.low.x, box.low.y, box.low.z}, high{box.high.x, box.high.y, box.high.z};
  std::array<double, 3> first{};
  VoxelGrid grid;
  grid.spacing = spacing;
  for (std::size_t n = 0; n < 3; ++n) {
    const double from = std::floor(low[n] / spacing[n]) - 1, to = std::ceil(high[n] / spacing[n]) + 1;
    first[n] = from * spacing[n];
    grid.size[n] = count_of(from, to);
  }
  grid.origin = {first[0], first[1], first[2]};
  check_grid(grid);
  return grid;
}

VoxelGrid grid_from(const Point3& origin, const Box3& box, const std::array<double, 3>& spacing) {
  check_spacing(spacing);
  const std::array<double, 3> first{origin.x, origin.y, origin.z}, low{box.low.x, box.low.y, box.low.z},
      high{box.high.x, box.high.y, box.high.z};
  VoxelGrid grid;
  grid.spacing = spacing;
  grid.origin = origin;
  for (std::size_t n = 0; n < 3; ++n) {
    if (!(std::abs(first[n]) <= limits::largest_coordinate))
      throw UsageError("--voxel-origin wants three numbers in mm");
    if (low[n] < first[n] - spacing[n] / 2) {
      throw UsageError(fmt::format("the structures begin at {} = {:.6g} mm, before the first voxel at {:.6g} mm",
                                   "xyz"[n], low[n], first[n]),
                       "Give a --voxel-origin that lies before them, or leave it out");
    }
    grid.size[n] = count_of(0, std::max(0.0, std::ceil((high[n] - first[n]) / spacing[n])));
  }
  check_grid(grid);
  return grid;
}

}  // namespace odontoscope
