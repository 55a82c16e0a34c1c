#include "recon/volume/oriented_image.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

/// File axis n runs along coordinate axis `along[n]`, downwards where `reversed[n]`.
struct AxisMap {
  std::array<std::size_t, 3> along{0, 1, 2};
  std::array<bool, 3> reversed{false, false, false};
  double tilt_degrees = 0;
  bool is_identity() const {
    return along == std::array<std::size_t, 3>{0, 1, 2} && reversed == std::array<bool, 3>{false, false, false};
  }
};

void check_square(const FileImage& image) {
  const auto& d = image.direction;
  bool square = true;
  for (std::size_t n = 0; n < 3; ++n) {
    for (std::size_t m = 0; m <= n; ++m) {
      square = square && std::abs(dot(d[n], d[m]) - (n == m ? 1 : 0)) <= limits::axes_out_of_square;
    }
  }
  if (square) return;
  Place place;
  place.file = image.source;
  throw InputError("sheared-volume", place,
                   fmt::format("the image's axes are not at right angles: ({}, {}, {}), ({}, {}, {}), ({}, {}, {})",
                               d[0][0], d[0][1], d[0][2], d[1][0], d[1][1], d[1][2], d[2][0], d[2][1], d[2][2]),
                   "resample it onto a rectangular grid, or correct the header");
}

/// Of all 48 maps the one that leaves the smallest turn over. It has the image's own handedness: some map of that kind
/// is within 63 degrees (a cube's largest misorientation, Mackenzie 1958), so its trace is above 1.9, and those of the
/// other kind have at most 1.
AxisMap nearest_axes(const std::array<Vector3, 3>& direction) {
  AxisMap best;
  double best_trace = -4;  // below the least possible, -3
  std::array<std::size_t, 3> along{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      std::array<Vector3, 3> axes{};
      AxisMap map{along, {(signs & 1) != 0, (signs & 2) != 0, (signs & 4) != 0}};
      for (std::size_t n = 0; n < 3; ++n) axes[n][along[n]] = map.reversed[n] ? -1 : 1;
      const double trace = dot(axes[0], direction[0]) + dot(axes[1], direction[1]) + dot(axes[2], direction[2]);
      if (trace > best_trace) {
        best_trace = trace;
        best = map;
      }
    }
  } while (std::next_permutation(along.begin(), along.end()));
  const double cosine = std::clamp((best_trace - 1) / 2, -1.0, 1.0);
  const double degrees = portable::acos(cosine) * 180 / std::numbers::pi;
  best.tilt_degrees = degrees > limits::tilt_unspoken ? degrees : 0;
  return best;
}

/// Part of a volume's axis across another that is none: over 200 mm it moves a point by 0.2 micrometres.
constexpr double turn_unseen = 1e-6;

/// Where the grid's axes really lie; the first voxel of the file stays. Turns that headers round away are none.
PatientFrame frame_of(const FileImage& image, const AxisMap& map) {
  PatientFrame frame;
  bool turned = false;
  for (std::size_t n = 0; n < 3; ++n) {
    for (std::size_t x = 0; x < 3; ++x) {
      const double along = map.reversed[n] ? -image.direction[n][x] : image.direction[n][x];
      turned = turned || std::abs(along - frame.axes[map.along[n]][x]) > turn_unseen;
    }
  }
  if (!turned) return frame;
  frame.fixed = image.origin;
  for (std::size_t n = 0; n < 3; ++n) {
    for (std::size_t x = 0; x < 3; ++x)
      frame.axes[map.along[n]][x] = map.reversed[n] ? -image.direction[n][x] : image.direction[n][x];
  }
  return frame;
}

Volume grid_along(const FileImage& image, const AxisMap& map) {
  Volume volume;
  volume.source = image.source;
  volume.tilt_degrees = map.tilt_degrees;
  Vector3 origin = image.origin;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t axis = map.along[n];
    volume.size[axis] = image.size[n];
    volume.spacing[axis] = image.spacing[n];
    volume.merged[axis] = image.merged[n];
    volume.size_before[axis] = image.size_before[n];
    if (map.reversed[n] && image.size[n] > 0) {
      origin[axis] -= static_cast<double>(image.size[n] - 1) * image.spacing[n];
    }
  }
  volume.origin = {origin[0], origin[1], origin[2]};
  volume.patient.frame = frame_of(image, map);
  validate_grid(volume);
  return volume;
}

std::vector<float> reordered(const FileImage& image, const Volume& grid, const AxisMap& map) {
  const std::array<std::size_t, 3> stride{1, image.size[0], image.size[0] * image.size[1]};
  std::array<std::ptrdiff_t, 3> step{};  // in the file, along x, y and z
  std::ptrdiff_t first = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const auto length = static_cast<std::ptrdiff_t>(stride[n]);
    step[map.along[n]] = map.reversed[n] ? -length : length;
    if (map.reversed[n]) first += length * static_cast<std::ptrdiff_t>(image.size[n] - 1);
  }
  std::vector<float> values(image.values.size());
  tbb::parallel_for(std::size_t{0}, grid.size[2], [&](std::size_t k) {
    float* to = values.data() + k * grid.pixels_per_slice();
    for (std::size_t j = 0; j < grid.size[1]; ++j) {
      std::ptrdiff_t from = first + static_cast<std::ptrdiff_t>(k) * step[2] + static_cast<std::ptrdiff_t>(j) * step[1];
      for (std::size_t i = 0; i < grid.size[0]; ++i, from += step[0])
        *to++ = image.values[static_cast<std::size_t>(from)];
    }
  });
  return values;
}

}  // namespace

std::array<IndexRange, 3> index_ranges(const FileImage& image, const VolumeBounds& bounds) {
  const AxisMap map = nearest_axes(image.direction);
  const Volume grid = grid_along(image, map);
  const std::array<double, 3> origin{grid.origin.x, grid.origin.y, grid.origin.z};
  std::array<IndexRange, 3> ranges;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t axis = map.along[n];
    const double last = static_cast<double>(image.size[n] - 1);
    const auto index = [&](double place) {
      return std::clamp((place - origin[axis]) / image.spacing[n], -1.0, last + 1);
    };
    const double low = std::clamp(std::floor(index(bounds.low[axis])) - 1, 0.0, last),
                 high = std::clamp(std::ceil(index(bounds.high[axis])) + 1, low, last);
    ranges[n] = {static_cast<std::size_t>(map.reversed[n] ? last - high : low),
                 static_cast<std::size_t>(high - low) + 1};
  }
  return ranges;
}

Volume oriented_grid(const FileImage& image) {
  check_square(image);
  return grid_along(image, nearest_axes(image.direction));
}

Volume oriented(FileImage&& image) {
  check_square(image);
  const AxisMap map = nearest_axes(image.direction);
  Volume volume = grid_along(image, map);
  volume.values = map.is_identity() ? std::move(image.values) : reordered(image, volume, map);
  return volume;
}

}  // namespace odontoscope
