#pragma once
// Regions of material and of void in a stack of slices on one grid, of which the first and the last are given and those
// in between interpolated, and which of the given ones each grid point belongs to. Inner part of kept_links.h.

#include <cstdint>
#include <vector>

#include "recon/between/blend_units.h"
#include "recon/between/composed.h"

namespace odontoscope::between {

inline constexpr std::uint32_t no_class = 0xffffffff;

/// Given regions that links join, of material or of void, are one class.
struct RegionClasses {
  std::vector<std::uint32_t> lower,
      upper;                  // of each contour's region: what it bounds from outside (a hole: the void in it)
  std::uint32_t outside = 0;  // of the unbounded void
  std::vector<bool> loop;     // of each class: do links join its regions in a loop?
};

RegionClasses classes_of(const SliceSet& given, const Surroundings& links);

/// One slice on the stack's grid. Grid points are numbered row by row.
struct Level {
  std::vector<double> values;         // of an interpolated slice; empty for a given one
  std::vector<std::uint8_t> solid;    // of each grid point: is it material?
  std::vector<std::uint32_t> region;  // of each grid point: number of its region in this slice
  std::uint32_t regions = 0;
};

/// The stack: `given.front()`, the interpolated slices, `given.back()`.
class LevelStack {
 public:
  LevelStack(std::vector<Window>& slices, const Grid& grid, const SliceSet& given, const RegionClasses& classes);

  std::size_t levels() const { return levels_.size(); }
  bool interpolated(std::size_t level) const { return level > 0 && level + 1 < levels_.size(); }
  const Level& level(std::size_t number) const { return levels_[number]; }
  std::size_t points() const { return static_cast<std::size_t>(columns_ * rows_); }
  std::ptrdiff_t columns() const { return columns_; }

  /// On the grid's border, which is never changed.
  bool on_border(std::size_t point) const;
  /// Makes material of void, or void of material. Preconditions: an interpolated slice, not on the border.
  void flip(std::size_t level, std::size_t point);

  /// Numbers the regions of all interpolated slices anew, as their contours will part them.
  void find_regions();
  /// Of each grid point of each slice the class of the given region of its kind that is nearest within what it is
  /// joined with; steps between slices count nothing. no_class where there is none.
  std::vector<std::vector<std::uint32_t>> spread_classes() const;

  /// Calls take(neighbour) for the grid points of the slice beside this one, of its kind, that its region goes on to.
  template <class Take>
  void for_joined(std::size_t level, std::size_t point, const Take& take) const;

  /// The interpolated slices.
  std::vector<Window> windows() const;

 private:
  void add_given(const Outline& outline, const std::vector<ContourFacts>& facts);
  void add_interpolated(const Window& window);
  bool diagonal(const Level& level, std::size_t a, std::size_t b, std::size_t c, std::size_t d) const;

  Grid grid_;
  std::ptrdiff_t first_i_ = 0, first_j_ = 0, columns_ = 0, rows_ = 0;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> lower_class_, upper_class_;  // of each region of the given slices
};

template <class Take>
void LevelStack::for_joined(std::size_t number, std::size_t point, const Take& take) const {
  const Level& level = levels_[number];
  const auto column = static_cast<std::ptrdiff_t>(point) % columns_,
             row = static_cast<std::ptrdiff_t>(point) / columns_;
  const auto at = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return static_cast<std::size_t>(j * columns_ + i); };
  for (std::ptrdiff_t dj = -1; dj <= 1; ++dj) {
    for (std::ptrdiff_t di = -1; di <= 1; ++di) {
      const std::ptrdiff_t i = column + di, j = row + dj;
      if ((di == 0 && dj == 0) || i < 0 || j < 0 || i >= columns_ || j >= rows_) continue;
      const std::size_t other = at(i, j);
      if (level.solid[other] != level.solid[point]) continue;
      if (di != 0 && dj != 0) {
        const std::size_t c = at(i, row), d = at(column, j);
        const bool parted = level.solid[c] != level.solid[point] && level.solid[d] != level.solid[point];
        if (parted && !diagonal(level, point, other, c, d)) continue;
      }
      take(other);
    }
  }
}

}  // namespace odontoscope::between
