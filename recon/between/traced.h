#pragma once
// From a field on the grid to contours. Inner part of blend.h and joined.h.

#include <cmath>
#include <cstdint>
#include <functional>

#include "recon/between/composed.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::between {

/// Where a contour crosses the grid edge from the material point to the void point, as a part of it: asked with the
/// numbers of both in the window and what interpolation says.
using CrossingRule = std::function<double(std::size_t material, std::size_t hollow, double interpolated)>;

struct TraceRules {
  /// Two material points across a cell's diagonal are never joined; else the field's saddle decides.
  bool diagonals_part = false;
  CrossingRule crossing;  // may be empty
};

/// Contours of the region where the window's values are negative; coordinates are multiples of the grain. Precondition:
/// the window's border is not negative.
Slice traced(const Window& window, const Grid& grid, const TraceRules& rules = {});

/// Thinned to the tolerance, and further, up to `largest`, while it has more points than `enough`.
Outline thinned(const Slice& slice, double tolerance, double largest, std::size_t enough);

/// The grid point in material (or, for a hole, in void) beside the first point of a traced contour.
struct GridPoint {
  std::ptrdiff_t i = 0, j = 0;
};
GridPoint beside_first_point(const std::vector<Point2>& contour, const Grid& grid, bool in_void);

std::size_t points_in(const Outline& outline);

}  // namespace odontoscope::between
