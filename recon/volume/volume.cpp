#include "recon/volume/volume.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

Place place_of(const Volume& volume) {
  Place place;
  place.file = volume.source;
  return place;
}

void validate_size(const Volume& volume) {
  const auto [nx, ny, nz] = volume.size;
  if (nx == 0 || ny == 0 || nz == 0) {
    throw InputError("empty-volume", place_of(volume), fmt::format("the volume has {} x {} x {} voxels", nx, ny, nz),
                     "give a volume with voxels along all three axes");
  }
  if (nz < 2) {
    throw InputError("single-slice", place_of(volume), "the volume has one slice only",
                     "give at least two slices; a solid lies between them");
  }
  const bool too_many =
      nx > limits::voxels || ny > limits::voxels / nx || nz > limits::voxels / (nx * ny) || nz > limits::slices;
  if (too_many) {
    throw InputError("too-many-voxels", place_of(volume),
                     fmt::format("the volume has {} x {} x {} voxels; the limits are {} voxels and {} slices", nx, ny,
                                 nz, limits::voxels, limits::slices),
                     "crop it to the tooth or resample it more coarsely");
  }
}

void validate_spacing(const Volume& volume) {
  for (const double spacing : volume.spacing) {
    if (!(spacing >= limits::smallest_spacing) || !(spacing <= limits::largest_coordinate)) {
      throw InputError(
          "bad-spacing", place_of(volume),
          fmt::format("the spacing {} x {} x {} mm is not usable: each must lie between {} and {}", volume.spacing[0],
                      volume.spacing[1], volume.spacing[2], limits::smallest_spacing, limits::largest_coordinate),
          "correct the header or give the true spacing (--spacing X,Y,Z)");
    }
  }
}

void validate_corners(const Volume& volume) {
  const std::array<double, 3> origin{volume.origin.x, volume.origin.y, volume.origin.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // One virtual voxel more at either end: contours of a region that touches the border run out there.
    const double low = origin[axis] - volume.spacing[axis];
    const double high = origin[axis] + static_cast<double>(volume.size[axis]) * volume.spacing[axis];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      throw InputError("not-finite", place_of(volume), "the volume's origin is not a finite number",
                       "correct the header");
    }
    if (low < -limits::largest_coordinate || high > limits::largest_coordinate) {
      throw InputError("too-large", place_of(volume),
                       fmt::format("the volume reaches from {} to {} mm along axis {}; the limit is {} mm", low, high,
                                   "xyz"[axis], limits::largest_coordinate),
                       "correct the header's origin and spacing; their unit is the millimetre");
    }
  }
}

struct Scan {
  ValueRange range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  std::size_t first_bad = nowhere;
};

Scan scan_values(const std::vector<float>& values) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, values.size()), Scan{},
      [&values](const tbb::blocked_range<std::size_t>& part, Scan scan) {
        for (std::size_t n = part.begin(); n != part.end(); ++n) {
          const float value = values[n];
          if (!std::isfinite(value)) {
            scan.first_bad = std::min(scan.first_bad, n);
          } else {
            scan.range.lowest = std::min(scan.range.lowest, value);
            scan.range.highest = std::max(scan.range.highest, value);
          }
        }
        return scan;
      },
      [](const Scan& a, const Scan& b) {
        return Scan{{std::min(a.range.lowest, b.range.lowest), std::max(a.range.highest, b.range.highest)},
                    std::min(a.first_bad, b.first_bad)};
      });
}

}  // namespace

void validate_grid(const Volume& volume) {
  validate_size(volume);
  validate_spacing(volume);
  validate_corners(volume);
}

ValueRange validate_volume(const Volume& volume) {
  validate_grid(volume);
  const auto [nx, ny, nz] = volume.size;
  if (volume.values.size() != nx * ny * nz) {
    throw InputError("wrong-voxel-count", place_of(volume),
                     fmt::format("{} values for {} x {} x {} voxels", volume.values.size(), nx, ny, nz),
                     "give one value a voxel");
  }
  const Scan scan = scan_values(volume.values);
  if (scan.first_bad != nowhere) {
    const std::size_t n = scan.first_bad;
    Place place = place_of(volume);
    place.slice = n / (nx * ny);
    place.z = volume.origin.z + static_cast<double>(*place.slice) * volume.spacing[2];
    throw InputError("not-finite", place,
                     fmt::format("voxel ({}, {}, {}) is not a finite number", n % nx, n / nx % ny, n / (nx * ny)),
                     "replace undefined voxels by the value of their surroundings before contouring");
  }
  return scan.range;
}

bool is_overlap(const Volume& volume, float value) {
  return std::any_of(volume.overlaps.begin(), volume.overlaps.end(),
                     [value](const LabelOverlap& overlap) { return value == static_cast<float>(overlap.value); });
}

LabelValues::LabelValues(const Volume& volume, std::int64_t label) : label_(static_cast<float>(label)) {
  for (const LabelOverlap& overlap : volume.overlaps) {
    if (std::binary_search(overlap.labels.begin(), overlap.labels.end(), label))
      shared_.push_back(static_cast<float>(overlap.value));
  }
}

}  // namespace odontoscope
