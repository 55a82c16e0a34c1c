#pragma once
// Where a surface runs along a strip: the end of an open ring, as of enamel's margin on a tilted tooth, or of a groove.
// Inner part of blend.h.
//
// Blended distances tell when a point between two nested contours is reached, since it lies between them: the distance
// to one grows while that to the other falls. In a strip that juts out farther than it is wide both are those to its
// sides, and the blend lets the strip draw back at once and leaves a ledge as long as itself in the plane of the slice.
// There the way along the strip decides: a point is reached at its share of the way from where the strip begins to
// where it ends, so that a wedge keeps its form and only grows. Ways are measured within the places where one slice has
// material and the other has not (J. A. Sethian, "A fast marching level set method", PNAS 93, 1996).

#include <cstddef>
#include <vector>

#include "recon/between/plane_distance.h"

namespace odontoscope::between {

struct StripPoint {
  std::size_t at = 0;    // on the lattice
  double share = 0;      // of the way from the lower slice to the upper one, where material comes or goes
  double length = 0;     // of the strip there, mm
  double certainty = 0;  // 0: as wide as it is long, as between nested contours; 1: a strip
};

/// All points of strips, by place. `lower` and `upper` are signed distances on the lattice, `height` is the slab's.
/// What is much wider than the slab is high is no strip but a flat roof, and left to the blend.
std::vector<StripPoint> strip_points(const Lattice& lattice, const std::vector<double>& lower,
                                     const std::vector<double>& upper, double height);

}  // namespace odontoscope::between
