#pragma once
// The grid of the DB engine: where the distance to the contours is sampled.
//
// One layer of columns x rows points on each slice, at the slice's own height, so that uneven slices give cells of
// uneven height. Beyond each end lies one empty layer more, as far off as the last two slices are apart; it closes the
// surface. Empty layers may be put between slices, which forces what they part to end (the paper's way to choose what
// connects).
//
// In the plane the grid reaches half a spacing beyond the contours of all structures and slices. Its outermost points
// therefore lie outside, and the extreme coordinates of the contours fall between grid points.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

struct GridOptions {
  std::size_t columns = 128, rows = 128;  // points along x and y
  std::vector<double> splits;             // heights of empty layers, mm, strictly between the first and the last slice
};

struct GridLayer {
  double z = 0;
  std::optional<std::size_t> slice;  // of the ordered stack; none: an empty layer
};

struct Grid {
  double x0 = 0, y0 = 0, dx = 1, dy = 1;  // dx, dy > 0
  std::size_t columns = 0, rows = 0;
  std::vector<GridLayer> layers;  // by ascending z, the first and the last empty

  double x(std::size_t column) const { return x0 + static_cast<double>(column) * dx; }
  double y(std::size_t row) const { return y0 + static_cast<double>(row) * dy; }
  std::size_t layer_size() const { return columns * rows; }
  std::size_t size() const { return layer_size() * layers.size(); }
  std::size_t index(std::size_t column, std::size_t row, std::size_t layer) const {
    return (layer * rows + row) * columns + column;
  }
  Point3 point(std::size_t column, std::size_t row, std::size_t layer) const {
    return {x(column), y(row), layers[layer].z};
  }
};

/// A cell, or a grid point: the cell of (column, row, layer) has the points from that one to the next along each axis.
using GridPlace = std::array<std::uint32_t, 3>;

/// The edge from a grid point to the next one along `axis` (0 x, 1 y, 2 z).
struct GridEdge {
  GridPlace from{};
  std::uint8_t axis = 0;
  friend auto operator<=>(const GridEdge&, const GridEdge&) = default;
};

/// `ordered_stack` as `ordered` gives it; `structures` is how many grids will be filled. Throws UsageError, before any
/// memory is taken: too few or too many points, all values together beyond limits::grid_values, a grid finer than
/// doubles can tell apart at these coordinates, or a split on a slice, beyond the slices or named twice.
Grid make_grid(const ContourStack& ordered_stack, const GridOptions& options, std::size_t structures = 1);

}  // namespace odontoscope
