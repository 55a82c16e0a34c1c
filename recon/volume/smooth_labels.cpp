#include "recon/volume/smooth_labels.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t not_in_band = std::numeric_limits<std::uint32_t>::max();

struct Voxel {
  std::ptrdiff_t at[3];
};

/// One label against all else: its band, and the plate that is bent over it.
class Plate {
 public:
  Plate(const Volume& volume, float label, std::vector<std::uint32_t>& number)
      : volume_(volume), label_(label), number_(number) {
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<std::ptrdiff_t>(volume.size[axis]);
    const double finest = *std::min_element(volume.spacing.begin(), volume.spacing.end());
    for (int axis = 0; axis < 3; ++axis) {
      length_[axis] = volume.spacing[axis] / finest;
      weight_[axis] = size_[axis] > 1 ? 1 / (length_[axis] * length_[axis]) : 0;
    }
    find_band();
    measure_distances();
  }
  /// The numbers are left as they were found.
  ~Plate() {
    for (const std::size_t v : voxels_) number_[v] = not_in_band;
  }

  void relax(const Progress& progress) {
    heights_ = distances_;
    std::vector<float> bend(voxels_.size()), next(voxels_.size());
    const double sum = weight_[0] + weight_[1] + weight_[2];
    if (!(sum > 0)) return;
    const double stiffest = 4 * sum * 4 * sum;  // bound of the squared Laplacian's eigenvalues
    const auto step = static_cast<float>(limits::plate_step / stiffest);
    for (int n = 0; n < limits::plate_steps; ++n) {
      progress.check();
      each([&](std::size_t i) { bend[i] = laplacian(i, heights_, 1); });
      each([&](std::size_t i) { next[i] = bounded(i, heights_[i] - step * laplacian(i, bend, 0)); });
      heights_.swap(next);
    }
  }

  std::vector<std::size_t> take_voxels() { return voxels_; }
  std::vector<float> take_heights() { return std::move(heights_); }

 private:
  template <class Each>
  void each(const Each& call) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, voxels_.size(), 4096), [&](const auto& part) {
      for (std::size_t i = part.begin(); i != part.end(); ++i) call(i);
    });
  }

  Voxel place(std::size_t v) const {
    const auto n = static_cast<std::ptrdiff_t>(v);
    return {{n % size_[0], n / size_[0] % size_[1], n / (size_[0] * size_[1])}};
  }
  bool inside(std::size_t v) const { return volume_.values[v] == label_; }
  std::ptrdiff_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? size_[0] : size_[0] * size_[1]; }

  /// Calls for each voxel within `reach` of the place along every axis, with its offset.
  template <class Call>
  void around(const Voxel& centre, const Call& call) const {
    constexpr std::ptrdiff_t reach = limits::plate_reach;
    std::ptrdiff_t low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::max<std::ptrdiff_t>(-reach, -centre.at[axis]);
      high[axis] = std::min<std::ptrdiff_t>(reach, size_[axis] - 1 - centre.at[axis]);
    }
    for (std::ptrdiff_t z = low[2]; z <= high[2]; ++z) {
      for (std::ptrdiff_t y = low[1]; y <= high[1]; ++y) {
        for (std::ptrdiff_t x = low[0]; x <= high[0]; ++x) {
          const std::ptrdiff_t v = ((centre.at[2] + z) * size_[1] + centre.at[1] + y) * size_[0] + centre.at[0] + x;
          call(static_cast<std::size_t>(v), Voxel{{x, y, z}});
        }
      }
    }
  }

  bool at_border(std::size_t v) const {
    const Voxel here = place(v);
    for (int axis = 0; axis < 3; ++axis) {
      const auto by = static_cast<std::size_t>(stride(axis));
      if (here.at[axis] > 0 && inside(v - by) != inside(v)) return true;
      if (here.at[axis] + 1 < size_[axis] && inside(v + by) != inside(v)) return true;
    }
    return false;
  }

  void find_band() {
    for (std::size_t v = 0; v < volume_.values.size(); ++v) {
      if (!at_border(v)) continue;
      around(place(v), [&](std::size_t near, const Voxel&) {
        if (number_[near] != not_in_band) return;
        number_[near] = 0;
        voxels_.push_back(near);
      });
    }
    std::sort(voxels_.begin(), voxels_.end());
    for (std::size_t i = 0; i < voxels_.size(); ++i) number_[voxels_[i]] = static_cast<std::uint32_t>(i);
  }

  /// To the nearest voxel of the other kind, as a box; no more than what the band's width can tell.
  void measure_distances() {
    distances_.resize(voxels_.size());
    each([&](std::size_t i) {
      const bool in = inside(voxels_[i]);
      double least = limits::plate_reach * limits::plate_reach;
      around(place(voxels_[i]), [&](std::size_t near, const Voxel& offset) {
        if (inside(near) == in) return;
        double squared = 0;
        for (int axis = 0; axis < 3; ++axis) {
          const double gap = std::max(std::abs(static_cast<double>(offset.at[axis])) - 0.5, 0.0) * length_[axis];
          squared += gap * gap;
        }
        least = std::min(least, squared);
      });
      distances_[i] = static_cast<float>(in ? std::sqrt(least) : -std::sqrt(least));
    });
  }

  /// Beyond the band heights are as far from zero as they get, `beyond` times; beyond the image they go on as they are.
  float laplacian(std::size_t i, const std::vector<float>& values, float beyond) const {
    const std::size_t v = voxels_[i];
    const Voxel here = place(v);
    double sum = 0;
    const auto add = [&](int axis, std::size_t near) {
      const std::uint32_t n = number_[near];
      const double far = (inside(near) ? 1 : -1) * limits::plate_reach * beyond;
      sum +=
          weight_[axis] * ((n == not_in_band ? far : static_cast<double>(values[n])) - static_cast<double>(values[i]));
    };
    for (int axis = 0; axis < 3; ++axis) {
      const auto by = static_cast<std::size_t>(stride(axis));
      if (here.at[axis] > 0) add(axis, v - by);
      if (here.at[axis] + 1 < size_[axis]) add(axis, v + by);
    }
    return static_cast<float>(sum);
  }

  float bounded(std::size_t i, float height) const {
    constexpr auto slack = static_cast<float>(limits::plate_slack), least = static_cast<float>(limits::plate_least);
    const float distance = distances_[i];
    if (distance > 0) return std::clamp(height, std::max(distance - slack, least), distance + slack);
    return std::clamp(height, distance - slack, std::min(distance + slack, -least));
  }

  const Volume& volume_;
  float label_;
  std::vector<std::uint32_t>& number_;  // in the band, of each voxel
  std::ptrdiff_t size_[3];
  double length_[3], weight_[3];  // of a voxel, over the shortest; of an axis in the Laplacian
  std::vector<std::size_t> voxels_;
  std::vector<float> distances_, heights_;
};

}  // namespace

SmoothLabels::SmoothLabels(const Volume& volume, const std::vector<float>& labels, const SmoothLabelsOptions& options,
                           const Progress& progress)
    : volume_(volume), distance_(options.distance) {
  if (!(distance_ >= 0)) {
    throw UsageError(fmt::format("{} is no distance of at least 0", distance_), "give millimetres (--smooth MM)");
  }
  std::vector<std::uint32_t> number(volume.values.size(), not_in_band);
  for (const float label : labels) {
    progress.check();
    progress.tell("smooth", static_cast<double>(bands_.size()) / static_cast<double>(labels.size()));
    Plate plate(volume, label, number);
    plate.relax(progress);
    bands_.push_back({label, plate.take_voxels(), plate.take_heights()});
  }
  std::stable_sort(bands_.begin(), bands_.end(), [](const Band& a, const Band& b) { return a.label < b.label; });
  largest_shift_ = find_largest_shift();
}

const SmoothLabels::Band* SmoothLabels::band_of(float value) const {
  const auto at = std::lower_bound(bands_.begin(), bands_.end(), value,
                                   [](const Band& band, float label) { return band.label < label; });
  return at != bands_.end() && at->label == value ? &*at : nullptr;
}

/// In one of the two cells beside the grid edge?
bool SmoothLabels::three_meet(std::size_t k, trace::Vertex low, int axis) const {
  const float* pixels = volume_.slice(k);
  const auto width = static_cast<std::ptrdiff_t>(volume_.size[0]),
             height = static_cast<std::ptrdiff_t>(volume_.size[1]);
  const trace::Step along = axis == 0 ? trace::Step{1, 0} : trace::Step{0, 1};
  const auto band_at = [&](trace::Vertex v) { return band_of(pixels[v.j * width + v.i]); };
  const Band *one = band_at(low), *other = band_at(low + along);
  for (const int side : {-1, 1}) {
    const trace::Step across = axis == 0 ? trace::Step{0, side} : trace::Step{side, 0};
    for (const trace::Vertex v : {low + across, low + along + across}) {
      if (v.i < 0 || v.j < 0 || v.i >= width || v.j >= height) continue;
      const Band* third = band_at(v);
      if (third != one && third != other) return true;
    }
  }
  return false;
}

double SmoothLabels::crossing(std::size_t k, trace::Vertex low, int axis) const {
  constexpr double middle = 0.5;
  if (three_meet(k, low, axis)) return middle;
  const std::size_t row = volume_.size[0];
  const std::size_t from =
      k * volume_.pixels_per_slice() + static_cast<std::size_t>(low.j) * row + static_cast<std::size_t>(low.i);
  const std::size_t to = from + (axis == 0 ? 1 : row);
  const Band *one = band_of(volume_.values[from]), *other = band_of(volume_.values[to]);
  const auto height = [](const Band* band, std::size_t voxel) {
    if (!band) return 0.0;
    const auto at = std::lower_bound(band->voxels.begin(), band->voxels.end(), voxel);
    return static_cast<double>(band->heights[static_cast<std::size_t>(at - band->voxels.begin())]);
  };
  const double before = height(one, from) - height(other, from), after = height(one, to) - height(other, to);
  const double most =
      std::min(distance_ / volume_.spacing[static_cast<std::size_t>(axis)], middle - limits::grid_vertex_margin);
  return std::clamp(before / (before - after), middle - most, middle + most);
}

double SmoothLabels::find_largest_shift() const {
  const auto columns = static_cast<std::ptrdiff_t>(volume_.size[0]),
             rows = static_cast<std::ptrdiff_t>(volume_.size[1]);
  const auto of_edge = [&](std::size_t k, trace::Vertex low, int axis) {
    const float* pixels = volume_.slice(k);
    const trace::Vertex high = axis == 0 ? trace::Vertex{low.i + 1, low.j} : trace::Vertex{low.i, low.j + 1};
    if (high.i == columns || high.j == rows) return 0.0;
    const float a = pixels[low.j * columns + low.i], b = pixels[high.j * columns + high.i];
    if (a == b || (!band_of(a) && !band_of(b))) return 0.0;
    return std::abs(crossing(k, low, axis) - 0.5) * volume_.spacing[static_cast<std::size_t>(axis)];
  };
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, volume_.size[2]), 0.0,
      [&](const tbb::blocked_range<std::size_t>& part, double largest) {
        for (std::size_t k = part.begin(); k != part.end(); ++k) {
          for (std::ptrdiff_t j = 0; j < rows; ++j) {
            for (std::ptrdiff_t i = 0; i < columns; ++i) {
              largest = std::max({largest, of_edge(k, {i, j}, 0), of_edge(k, {i, j}, 1)});
            }
          }
        }
        return largest;
      },
      [](double a, double b) { return std::max(a, b); });
}

}  // namespace odontoscope
