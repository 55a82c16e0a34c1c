#include "recon/volume/regrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/parallel.h"
#include "recon/core/portable_math.h"
#include "recon/volume/pixel_file.h"

namespace odontoscope {
namespace {

using Vector3 = std::array<double, 3>;

Place in_volume(const Volume& volume) {
  Place place;
  place.file = volume.source;
  return place;
}

Vector3 as_array(const Point3& p) { return {p.x, p.y, p.z}; }

/// All but the grid and the values.
Volume like(const Volume& volume) {
  Volume other;
  other.source = volume.source;
  other.tilt_degrees = volume.tilt_degrees;
  other.patient = volume.patient;
  other.labels = volume.labels;
  other.overlaps = volume.overlaps;
  other.remarks = volume.remarks;
  return other;
}

/// Asks for no memory on a number's word: sizes are clamped to what validate_grid refuses.
std::size_t voxels_along(double length, double spacing) {
  const double count = std::round(length / spacing);
  return count < 1                                     ? 1
         : count > static_cast<double>(limits::voxels) ? limits::voxels + 1
                                                       : static_cast<std::size_t>(count);
}

void check_grid(const Volume& grid) {
  validate_grid(grid);
  check_memory(grid.source, grid.size[0] * grid.size[1] * grid.size[2]);
}

/// What one new voxel takes of the old ones along an axis.
struct Tap {
  std::size_t first = 0;
  std::vector<double> weights;
};

/// `count` new voxels of `step` old ones each, with the same middle as `old_count` old ones.
std::vector<Tap> taps(std::size_t old_count, std::size_t count, double step, Sampling sampling) {
  const auto last = static_cast<double>(old_count - 1);
  const double half_width = std::max(1.0, step);
  std::vector<Tap> all(count);
  for (std::size_t n = 0; n < count; ++n) {
    const double at = last / 2 + (static_cast<double>(n) - static_cast<double>(count - 1) / 2) * step;
    if (sampling == Sampling::nearest) {
      all[n] = {static_cast<std::size_t>(std::clamp(std::floor(at + 0.5), 0.0, last)), {1}};
      continue;
    }
    const double inside = std::clamp(at, 0.0, last);  // beyond the outermost voxel its value goes on
    const double first = std::max(0.0, std::ceil(inside - half_width)),
                 end = std::min(last, std::floor(inside + half_width));
    all[n].first = static_cast<std::size_t>(first);
    double sum = 0;
    for (double voxel = first; voxel <= end; ++voxel) {
      all[n].weights.push_back(std::max(0.0, 1 - std::abs(voxel - inside) / half_width));
      sum += all[n].weights.back();
    }
    for (double& weight : all[n].weights) weight /= sum;
  }
  return all;
}

/// Along one axis alone: `size` is that of `values` before, and after it.
void resample_axis(std::vector<float>& values, std::array<std::size_t, 3>& size, std::size_t axis,
                   const std::vector<Tap>& taps, Share share, const Progress& progress) {
  std::array<std::size_t, 3> wanted = size;
  wanted[axis] = taps.size();
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  std::vector<float> result(wanted[0] * wanted[1] * wanted[2]);
  for_each(wanted[2], "resample", share, progress, [&](std::size_t k) {
    float* to = result.data() + k * wanted[0] * wanted[1];
    for (std::size_t j = 0; j < wanted[1]; ++j) {
      for (std::size_t i = 0; i < wanted[0]; ++i) {
        std::array<std::size_t, 3> at{i, j, k};
        const Tap& tap = taps[at[axis]];
        at[axis] = tap.first;
        const float* from = values.data() + at[0] + at[1] * stride[1] + at[2] * stride[2];
        double sum = 0;
        for (const double weight : tap.weights) {
          sum += weight * static_cast<double>(*from);
          from += stride[axis];
        }
        *to++ = static_cast<float>(sum);
      }
    }
  });
  values = std::move(result);
  size = wanted;
}

/// Values of a volume anywhere, from the grid's outermost voxels' edges on `outside`.
class Sampler {
 public:
  Sampler(const Volume& volume, Sampling sampling, float outside)
      : volume_(volume), sampling_(sampling), outside_(outside), origin_(as_array(volume.origin)) {}

  float at(const Point3& place) const {
    std::array<std::size_t, 3> low{};
    Vector3 part{};
    const Vector3 p = as_array(place);
    for (std::size_t n = 0; n < 3; ++n) {
      const auto last = static_cast<double>(volume_.size[n] - 1);
      const double u = (p[n] - origin_[n]) / volume_.spacing[n];
      if (!(u >= -0.5 && u <= last + 0.5)) return outside_;
      const double inside = std::clamp(sampling_ == Sampling::nearest ? std::floor(u + 0.5) : u, 0.0, last);
      low[n] = static_cast<std::size_t>(inside);
      part[n] = inside - static_cast<double>(low[n]);
    }
    return sampling_ == Sampling::nearest ? volume_.slice(low[2])[low[0] + low[1] * volume_.size[0]]
                                          : between(low, part);
  }

 private:
  float between(const std::array<std::size_t, 3>& low, const Vector3& part) const {
    const std::size_t right = part[0] > 0 ? 1 : 0, back = part[1] > 0 ? volume_.size[0] : 0,
                      up = part[2] > 0 ? volume_.pixels_per_slice() : 0;
    const float* v = volume_.slice(low[2]) + low[0] + low[1] * volume_.size[0];
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    const auto line = [&](std::size_t at) { return mix(v[at], v[at + right], part[0]); };
    return static_cast<float>(mix(mix(line(0), line(back), part[1]), mix(line(up), line(up + back), part[1]), part[2]));
  }

  const Volume& volume_;
  Sampling sampling_;
  float outside_;
  Vector3 origin_;
};

/// `take(centre)` for each voxel that belongs, slice by slice.
template <class Take>
void for_voxels_of(const Volume& volume, const std::function<bool(float)>& belongs, const Progress& progress,
                   Take take) {
  for (std::size_t k = 0; k < volume.size[2]; ++k) {
    progress.check();
    const float* value = volume.slice(k);
    for (std::size_t j = 0; j < volume.size[1]; ++j) {
      for (std::size_t i = 0; i < volume.size[0]; ++i) {
        if (!belongs(*value++)) continue;
        take(Point3{volume.origin.x + static_cast<double>(i) * volume.spacing[0],
                    volume.origin.y + static_cast<double>(j) * volume.spacing[1],
                    volume.origin.z + static_cast<double>(k) * volume.spacing[2]});
      }
    }
  }
}

RigidMotion upright_motion(const Volume& volume, const std::function<bool(float)>& belongs, const Progress& progress) {
  Moments moments;
  for_voxels_of(volume, belongs, progress, [&](const Point3& at) { moments.add(at); });
  const std::string remedy = "crop the volume to the tooth (--crop), or leave --upright out";
  if (moments.count() == 0)
    throw InputError("no-long-axis", in_volume(volume), "no voxel belongs to what is to stand upright", remedy);
  const Moments::Axes axes = moments.axes();
  if (!(axes.variance[0] > limits::long_axis * axes.variance[1])) {
    throw InputError(
        "no-long-axis", in_volume(volume),
        fmt::format(
            "it is as wide as long (spread of {:.3g} and {:.3g} mm along its axes): which way is up cannot be told",
            std::sqrt(axes.variance[1]), std::sqrt(axes.variance[0])),
        remedy);
  }
  return turn_to_z(axes.direction[0], moments.centre());
}

}  // namespace

Volume cropped(Volume&& volume, const VolumeBox& box) {
  const Vector3 low = as_array(box.low), high = as_array(box.high), origin = as_array(volume.origin);
  std::array<std::size_t, 3> first{}, end{};
  for (std::size_t n = 0; n < 3; ++n) {
    const auto last = static_cast<double>(volume.size[n] - 1);
    const double from = std::max(0.0, std::ceil((low[n] - origin[n]) / volume.spacing[n])),
                 to = std::min(last, std::floor((high[n] - origin[n]) / volume.spacing[n]));
    if (!(from <= to)) {
      throw InputError(
          "crop-misses", in_volume(volume),
          fmt::format("no voxel lies from {:.6g} to {:.6g} mm along {}; the volume reaches from {:.6g} to {:.6g} mm",
                      low[n], high[n], "xyz"[n], origin[n], origin[n] + last * volume.spacing[n]),
          "give a box that holds a part of it: --crop X0,X1,Y0,Y1,Z0,Z1");
    }
    first[n] = static_cast<std::size_t>(from);
    end[n] = static_cast<std::size_t>(to) + 1;
  }
  Volume part = like(volume);
  part.spacing = volume.spacing;
  part.size = {end[0] - first[0], end[1] - first[1], end[2] - first[2]};
  part.origin = {origin[0] + static_cast<double>(first[0]) * volume.spacing[0],
                 origin[1] + static_cast<double>(first[1]) * volume.spacing[1],
                 origin[2] + static_cast<double>(first[2]) * volume.spacing[2]};
  validate_grid(part);
  part.values.reserve(part.size[0] * part.size[1] * part.size[2]);
  for (std::size_t k = first[2]; k < end[2]; ++k) {
    for (std::size_t j = first[1]; j < end[1]; ++j) {
      const float* row = volume.slice(k) + j * volume.size[0];
      part.values.insert(part.values.end(), row + first[0], row + end[0]);
    }
  }
  volume.values = {};
  return part;
}

Volume resampled(const Volume& volume, double spacing, Sampling sampling, const Progress& progress) {
  Volume grid = like(volume);
  const Vector3 origin = as_array(volume.origin);
  Vector3 corner{};
  for (std::size_t n = 0; n < 3; ++n) {
    const auto old = static_cast<double>(volume.size[n]);
    grid.size[n] = voxels_along(old * volume.spacing[n], spacing);
    grid.spacing[n] = spacing;
    corner[n] = origin[n] + ((old - 1) * volume.spacing[n] - static_cast<double>(grid.size[n] - 1) * spacing) / 2;
  }
  grid.origin = {corner[0], corner[1], corner[2]};
  check_grid(grid);
  std::array<std::size_t, 3> size = volume.size;
  // Coarser axes first: the least work and memory on the way.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return volume.spacing[a] < volume.spacing[b]; });
  grid.values = volume.values;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t axis = order[n];
    const Share share{static_cast<double>(n) / 3, static_cast<double>(n + 1) / 3};
    resample_axis(grid.values, size, axis,
                  taps(volume.size[axis], grid.size[axis], spacing / volume.spacing[axis], sampling), share, progress);
  }
  return grid;
}

UprightVolume upright(const Volume& volume, const std::function<bool(float)>& belongs, double spacing,
                      Sampling sampling, float outside, const Progress& progress) {
  progress.tell("upright", 0);
  const RigidMotion motion = upright_motion(volume, belongs, progress);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vector3 low{infinite, infinite, infinite}, high{-infinite, -infinite, -infinite};
  for_voxels_of(volume, belongs, progress, [&](const Point3& at) {
    const Vector3 p = as_array(motion(at));
    for (std::size_t n = 0; n < 3; ++n) {
      low[n] = std::min(low[n], p[n]);
      high[n] = std::max(high[n], p[n]);
    }
  });
  // A turned voxel reaches half its diagonal beyond its centre.
  const double around = 2 * spacing + portable::hypot(volume.spacing[0], volume.spacing[1], volume.spacing[2]) / 2;
  Volume grid = like(volume);
  for (std::size_t n = 0; n < 3; ++n) {
    grid.size[n] = voxels_along(high[n] - low[n] + 2 * around, spacing) + 1;
    grid.spacing[n] = spacing;
  }
  grid.origin = {low[0] - around, low[1] - around, low[2] - around};
  check_grid(grid);
  grid.values.resize(grid.size[0] * grid.size[1] * grid.size[2]);
  const RigidMotion back = motion.inverse();
  const Sampler sampler(volume, sampling, outside);
  for_each(grid.size[2], "upright", {}, progress, [&](std::size_t k) {
    float* to = grid.values.data() + k * grid.pixels_per_slice();
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        *to++ = sampler.at(
            back({grid.origin.x + static_cast<double>(i) * spacing, grid.origin.y + static_cast<double>(j) * spacing,
                  grid.origin.z + static_cast<double>(k) * spacing}));
  });
  return {std::move(grid), motion};
}

}  // namespace odontoscope
