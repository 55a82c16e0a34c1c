#pragma once
// The blended fields of all shapes, put together on one grid at a height. Inner part of blend.h.
//
// Fields are negative inside and near the surface about the distance in mm. Group: material, and outside each of its
// voids (the larger of the two fields); slice: any of the groups (the least).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "recon/between/blend_units.h"
#include "recon/between/course.h"
#include "recon/between/motion.h"
#include "recon/between/plane_distance.h"

namespace odontoscope::between {

/// The grid of all slices of a slab, without end: points at anchor + step * (i, j).
struct Grid {
  Point2 anchor;
  double step = 1;
  /// Coordinates of contours are rounded to multiples of it; a power of two, and the step and anchor are multiples.
  double grain = 0;
};

/// Fine enough for the narrowest contour and wall, and for the slab's size; coarser where that took more than
/// `most_points`; then `finer` times as fine. Empty if doubles are too coarse there for it.
std::optional<Grid> grid_for(const SliceSet& slices, std::size_t most_points, std::size_t finer = 1);

/// Values at the grid points (first_i + column, first_j + row), row by row; beyond, all is outside.
struct Window {
  std::ptrdiff_t first_i = 0, first_j = 0, columns = 0, rows = 0;
  std::vector<double> values;

  bool holds(std::ptrdiff_t i, std::ptrdiff_t j) const {
    return i >= first_i && j >= first_j && i < first_i + columns && j < first_j + rows;
  }
  std::size_t at(std::ptrdiff_t i, std::ptrdiff_t j) const {
    return static_cast<std::size_t>((j - first_j) * columns + (i - first_i));
  }
};

/// A value that means "far outside".
inline constexpr double far_outside = std::numeric_limits<double>::max();

/// Far outside everywhere, and as large as all of these together. Precondition: there is one.
Window around(std::span<const Window* const> windows);

/// Writes rule(value, other's value) into a window where the other one lies on it.
template <class Rule>
void combine(Window& window, const Window& other, const Rule& rule) {
  const std::ptrdiff_t end_i = std::min(window.first_i + window.columns, other.first_i + other.columns);
  const std::ptrdiff_t end_j = std::min(window.first_j + window.rows, other.first_j + other.rows);
  for (std::ptrdiff_t j = std::max(window.first_j, other.first_j); j < end_j; ++j) {
    for (std::ptrdiff_t i = std::max(window.first_i, other.first_i); i < end_i; ++i) {
      double& value = window.values[window.at(i, j)];
      value = rule(value, other.values[other.at(i, j)]);
    }
  }
}

/// One unit in all its slices, ready to be blended at any height.
class UnitField {
 public:
  UnitField(const BlendUnit& unit, const SliceSet& slices, const Grid& grid, bool strips);

  Window at(double share) const;

 private:
  /// The unit shrinks from its inner radius beside one slice to nothing at a share of the way to the other.
  struct Ending {
    std::size_t beside = at_lower;
    double radius = 0, share = 1;
  };

  void measure(const BlendUnit& unit, const SliceSet& slices);
  void continue_beyond(const BlendUnit& unit, const SliceSet& slices, std::size_t beyond, std::size_t beside);
  void find_end(const BlendUnit& unit, const SliceSet& slices);
  std::vector<double> blended(double share) const;
  double curvature(std::size_t point, double share) const;
  void drop_overshoot(std::vector<double>& values, double share) const;
  Window moved(const std::vector<double>& values, const SliceWeights& weights) const;

  Grid grid_;
  Motion motion_;
  Lattice lattice_;                           // in the unit's frame
  std::ptrdiff_t first_i_ = 0, first_j_ = 0;  // of the lattice on the grid, unless it moves
  Heights heights_;
  std::array<std::vector<double>, slices_used> distances_;
  std::optional<Ending> end_;
  std::vector<StripPoint> strips_;
};

/// All units of a slab.
class Composition {
 public:
  Composition(const SliceSet& slices, const BlendPlan& plan, const Grid& grid, bool strips);

  /// Everything inside lies within the window's border.
  Window at(double share) const;

 private:
  std::vector<std::vector<std::size_t>> voids_of_;
  std::vector<UnitField> material_, voids_;
};

}  // namespace odontoscope::between
