#pragma once
// From a sampled implicit function to closed, simple, pairwise disjoint contours.

#include <cstddef>
#include <functional>
#include <vector>

#include "recon/core/polygon.h"

namespace odontoscope::sample {

/// Values at (origin + step * (column, row)), row by row; negative inside.
struct Grid {
  Point2 origin;
  double step = 0;
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;

  Point2 at(std::size_t column, std::size_t row) const {
    return {origin.x + step * static_cast<double>(column), origin.y + step * static_cast<double>(row)};
  }
};

/// Marching squares with linear interpolation. The inside is on the left of each loop: outer loops run
/// counter-clockwise, holes clockwise. No point lies on a grid vertex (crossings keep away from them by a hundredth of
/// the step) and a cell's segments never meet, so all loops are simple and disjoint by construction. Loops of an area
/// below `speck` are left out. Precondition: the border of the grid is outside; throws InternalError if it is not.
std::vector<Polygon> trace(const Grid& grid, double speck);

/// Fewer points for the same loops: a subset of each loop's points such that neighbours are at most `spacing` apart
/// along the loop and the points left out lie within `deviation` of the chord; small loops keep closer points. The
/// result is simple, disjoint with at least `clearance` between segments that are not neighbours, and rounded to
/// `grain`; where thinning would break that, it is repeated with closer points.
struct Thinning {
  double spacing = 0, deviation = 0, clearance = 0, grain = 0;
};
std::vector<Polygon> thin(const std::vector<Polygon>& loops, const Thinning& thinning);

}  // namespace odontoscope::sample
