#pragma once
// Random but valid stacks of contours. A seed means the same stack on every machine.

#include <cstdint>
#include <string>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

struct RandomStack {
  ContourStack stack;
  std::string kind;   // for messages
  /// No four points cocircular and no five cospherical but by the rarest accident: no tie to break.
  bool general_position = false;
};

/// One of five kinds, by the seed: round blobs; spiky stars; shapes on a coarse integer lattice; outlines of voxels through
/// the middles of their edges (both full of cocircular points); iso-contours of a smooth field. Two to five slices, sometimes an
/// empty one among them, sometimes a second structure; contours overlap between slices and nest within them.
RandomStack random_stack(std::uint64_t seed);

}  // namespace odontoscope::test
