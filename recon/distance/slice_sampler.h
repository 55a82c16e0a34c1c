#pragma once
// One structure's contours in one slice, asked from the points of a grid. For the .cpp files of this room only.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recon/distance/grid.h"

namespace odontoscope::distance {

/// -1 inside, 0 exactly on a contour, +1 outside, for all points of a layer, row by row. Exact.
void sample_signs(const Slice& slice, const std::string& structure, const Grid& grid, std::span<std::int8_t> signs);

/// Distance to the nearest contour edge, written to `distances` where `wanted` is not 0. Precondition: there is a
/// contour. Exact but for rounding: blocks of points are halved, each half keeping the edges that can be nearest to one
/// of its points.
void sample_distances(const Slice& slice, const std::string& structure, const Grid& grid,
                      std::span<const std::uint8_t> wanted, std::span<double> distances);

}  // namespace odontoscope::distance
