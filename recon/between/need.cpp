#include <algorithm>
#include <cmath>

#include "recon/between/blend.h"
#include "recon/between/composed.h"

namespace odontoscope::between {

SlabNeed need(const Outline& lower, const Outline& upper, std::size_t most_grid_points) {
  if (lower.empty() && upper.empty()) return {};
  Box box;
  for (const Outline* outline : {&lower, &upper}) {
    for (const std::vector<Point2>& ring : *outline) {
      for (const Point2 p : ring) box.take(p);
    }
  }
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  if (!std::isnormal(width * height)) return {};  // too small, or too narrow, for areas to be numbers
  const double points = static_cast<double>(most_grid_points);
  const double step = std::max(std::sqrt(width * height / points), std::max(width, height) / points);
  Lattice lattice{{box.low.x - step, box.low.y - step}, step, 0, 0};
  lattice.columns = static_cast<std::ptrdiff_t>(width / step) + 4;
  lattice.rows = static_cast<std::ptrdiff_t>(height / step) + 4;
  const std::vector<double> below = signed_distances(lattice, lower), above = signed_distances(lattice, upper);
  SlabNeed result;
  for (std::size_t n = 0; n < below.size(); ++n) {
    if ((below[n] < 0) == (above[n] < 0)) continue;
    result.area += step * step;
    result.travel = std::max(result.travel, 2 * std::min(std::abs(below[n]), std::abs(above[n])));
  }
  return result;
}

}  // namespace odontoscope::between
