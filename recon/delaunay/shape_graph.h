#pragma once
// Shapes of all slices and the links between them, as they grow.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "recon/core/limits.h"
#include "recon/delaunay/tracked_shape.h"

namespace odontoscope::delaunay {

class ShapeGraph {
 public:
  explicit ShapeGraph(const std::vector<ShapeSlice>& slices)
      : slices_(slices), up_(slices.size()), down_(slices.size()) {
    for (std::size_t k = 0; k < slices.size(); ++k) {
      up_[k].resize(slices[k].shapes.size());
      down_[k].resize(slices[k].shapes.size());
    }
  }

  const std::vector<ShapeSlice>& slices() const { return slices_; }
  std::size_t slabs() const { return slices_.empty() ? 0 : slices_.size() - 1; }
  const TrackedShape& shape(std::size_t k, std::uint32_t i) const { return slices_[k].shapes[i]; }
  double height(std::size_t slab) const { return slices_[slab + 1].z - slices_[slab].z; }

  void add(std::size_t slab, std::uint32_t lower, std::uint32_t upper) {
    up_[slab][lower].push_back(upper);
    down_[slab + 1][upper].push_back(lower);
  }

  void remove(std::size_t slab, std::uint32_t lower, std::uint32_t upper) {
    std::erase(up_[slab][lower], upper);
    std::erase(down_[slab + 1][upper], lower);
  }

  const std::vector<std::uint32_t>& above(std::size_t k, std::uint32_t i) const { return up_[k][i]; }
  const std::vector<std::uint32_t>& below(std::size_t k, std::uint32_t i) const { return down_[k][i]; }

  /// Does the shape hang free, though there is a slice on that side?
  bool free_above(std::size_t k, std::uint32_t i) const {
    return k + 1 < slices_.size() && !shape(k, i).unbounded && up_[k][i].empty();
  }
  bool free_below(std::size_t k, std::uint32_t i) const {
    return k > 0 && !shape(k, i).unbounded && down_[k][i].empty();
  }

  /// The shape of like size that the shape is linked with, if both are linked with nothing else there: the same
  /// thing, one slice on.
  std::optional<std::uint32_t> same_above(std::size_t k, std::uint32_t i) const {
    if (up_[k][i].size() != 1) return std::nullopt;
    const std::uint32_t other = up_[k][i].front();
    return down_[k + 1][other].size() == 1 && like(shape(k, i), shape(k + 1, other)) ? std::optional(other)
                                                                                     : std::nullopt;
  }
  std::optional<std::uint32_t> same_below(std::size_t k, std::uint32_t i) const {
    if (down_[k][i].size() != 1) return std::nullopt;
    const std::uint32_t other = down_[k][i].front();
    return up_[k - 1][other].size() == 1 && like(shape(k, i), shape(k - 1, other)) ? std::optional(other)
                                                                                   : std::nullopt;
  }

  static bool like(const TrackedShape& a, const TrackedShape& b) {
    return !a.unbounded && !b.unbounded &&
           std::max(a.radius, b.radius) <= limits::track_size_ratio * std::min(a.radius, b.radius);
  }

  /// How far apart sections of these radii may lie, this far apart in z.
  static double reach(const TrackedShape& a, const TrackedShape& b, double height) {
    return limits::track_reach_sizes * (a.radius + b.radius) + limits::track_reach_slope * height;
  }

 private:
  const std::vector<ShapeSlice>& slices_;
  std::vector<std::vector<std::vector<std::uint32_t>>> up_, down_;  // of slice, of shape
};

}  // namespace odontoscope::delaunay
