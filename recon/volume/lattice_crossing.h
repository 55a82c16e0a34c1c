#pragma once
// Where a contour crosses a grid edge of a volume: always a point of the volume's lattice.

#include "recon/contours/trace.h"
#include "recon/volume/lattice.h"

namespace odontoscope::trace {

/// The point at `along`, counted from the lower of two neighbours whichever comes first, on the lattice.
inline Point2 between_from_low(const Lattice& lattice, Vertex a, Vertex b, double along) {
  const Vertex low = a.i < b.i || a.j < b.j ? a : b;
  if (a.j == b.j) return {lattice.x_between(low.i, along), lattice.y(low.j)};
  return {lattice.x(low.i), lattice.y_between(low.j, along)};
}

/// The point at `fraction` of the way from a to its neighbour b, on the lattice. Computed from the lower of the two, so
/// that it is the same point whichever way the edge is taken, as long as the fractions add up to 1 exactly.
inline Point2 between(const Lattice& lattice, Vertex a, Vertex b, double fraction) {
  const bool forward = a.i < b.i || a.j < b.j;
  return between_from_low(lattice, a, b, forward ? fraction : 1 - fraction);
}

}  // namespace odontoscope::trace
