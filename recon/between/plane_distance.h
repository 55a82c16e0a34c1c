#pragma once
// Signed distances to contours at the points of a grid. Inner part of blend.h.
//
// Each grid point near a contour looks at the edges themselves; from there the number of the nearest edge is handed on
// in two sweeps with eight neighbours (P. E. Danielsson, "Euclidean distance mapping", 1980), and the distance to that
// edge is computed: exact up to rounding next to contours, and elsewhere but for rare points whose nearest edge no
// neighbour shares, where it is too large by a small part of the step.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/between/blend.h"

namespace odontoscope::between {

/// Grid points at origin + step * (column, row), row by row.
struct Lattice {
  Point2 origin;
  double step = 1;
  std::ptrdiff_t columns = 0, rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns * rows); }
  double x(std::ptrdiff_t column) const { return origin.x + step * static_cast<double>(column); }
  double y(std::ptrdiff_t row) const { return origin.y + step * static_cast<double>(row); }
};

/// To the nearest contour, inside or outside. Infinite if there is none. Contours may lie partly outside the lattice.
std::vector<double> distances(const Lattice& lattice, const Outline& contours);

/// 1 for grid points inside an odd number of contours, else 0. On a contour: either.
std::vector<std::uint8_t> inside_mask(const Lattice& lattice, const Outline& contours);

/// Negative inside an odd number of contours.
std::vector<double> signed_distances(const Lattice& lattice, const Outline& contours);

}  // namespace odontoscope::between
