#pragma once
// The border of the region that any closed polygons enclose, as simple contours. Inner part of repair_contours.h.

#include <vector>

#include "recon/core/geometry.h"
#include "recon/exchange/repair_contours.h"

namespace odontoscope {

/// Outer borders counter-clockwise, holes clockwise. They keep apart but for rounding, which the caller checks.
/// Preconditions: finite; three points or more in each, neighbours different.
std::vector<std::vector<Point2>> region_border(const std::vector<std::vector<Point2>>& polygons,
                                               const RepairOptions& options);

}  // namespace odontoscope
