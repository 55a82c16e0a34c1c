#pragma once
// From a field on the grid to contours. Inner part of blend.h.

#include "recon/between/composed.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::between {

/// Contours of the region where the window's values are negative; coordinates are multiples of the grain. Precondition:
/// the window's border is not negative.
Slice traced(const Window& window, const Grid& grid);

/// Thinned to the tolerance, and further, up to `largest`, while it has more points than `enough`.
Outline thinned(const Slice& slice, double tolerance, double largest, std::size_t enough);

std::size_t points_in(const Outline& outline);

}  // namespace odontoscope::between
