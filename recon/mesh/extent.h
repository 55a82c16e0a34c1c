#pragma once
// How large a thing is.

#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

/// From corner to corner of the box round all points; 0 if there are none.
inline double diagonal_of(const std::vector<Point3>& points) {
  if (points.empty()) return 0;
  Point3 low = points.front(), high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return portable::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

}  // namespace odontoscope
