#pragma once
// Random but valid stacks of contours. A seed means the same stack on every machine.

#include <cstdint>
#include <string>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

struct RandomStack {
  ContourStack stack;
  std::string kind;  // for messages
  /// No four points cocircular and no five cospherical but by the rarest accident: no tie to break.
  bool general_position = false;
};

/// One of five kinds, by the seed: round blobs; spiky stars; shapes on a coarse integer lattice; outlines of voxels
/// through the middles of their edges (both full of cocircular points); iso-contours of a smooth field. Two to five
/// slices, sometimes an empty one among them, sometimes a second structure; contours overlap between slices and nest
/// within them.
RandomStack random_stack(std::uint64_t seed);

/// A whole number that the environment sets, or `otherwise`.
std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise);

/// How many of them a test walks through that is not the long proof itself: `usual`, or fewer if
/// ODONTOSCOPE_RANDOM_STACKS says so.
std::uint64_t random_stacks_of(std::uint64_t usual);

}  // namespace odontoscope::test
