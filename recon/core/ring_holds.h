#pragma once
// Whether a closed ring of points has a place inside it.

#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

/// By the parity of the edges that a ray along x crosses, either way round. In doubles: within rounding of an edge it
/// may say either.
inline bool ring_holds(const std::vector<Point2>& ring, Point2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

}  // namespace odontoscope
