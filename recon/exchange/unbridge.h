#pragma once
// Keyholes of structure sets: an outline and its holes drawn as one line, which goes along a bridge and comes back
// along the very same points. Inner part of read_rtstruct.h.

#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

/// The closed lines that are left when edges that are there in both directions are taken out: `points` alone if there
/// is none. Only edges whose ends agree to the bit count, so the region within an odd number of lines is the same as
/// before. Lines of fewer than three points (spurs) vanish. Cost: O(n log n).
std::vector<std::vector<Point2>> without_bridges(const std::vector<Point2>& points);

}  // namespace odontoscope
