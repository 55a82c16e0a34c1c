#pragma once
// Limits of the DB engine, each with its reason.

#include <cstddef>

namespace odontoscope::limits {

/// Grid points along x or y: fewer than four leave no cell inside the margin; more than these are finer than any scan.
inline constexpr std::size_t least_grid_points = 4, most_grid_points = 8'192;
/// Values of all structures' grids together: 2 GiB of doubles.
inline constexpr std::size_t grid_values = 1ull << 28;
/// What an empty layer holds, and a grid point away from the surface: the paper's 1 (in mm beside distances).
inline constexpr double empty_value = 1;
/// Points along x and y of the blocks that end the search for the nearest contour edge.
inline constexpr std::size_t distance_block = 4;
/// Added to the reach of that search, over the size of the grid: far above rounding, so that no nearest edge is missed.
inline constexpr double distance_slack = 1e-9;
/// How far decimation "to the most possible" may move the surface, over the grid's larger spacing in the plane.
inline constexpr double decimation_error = 0.5;

}  // namespace odontoscope::limits
