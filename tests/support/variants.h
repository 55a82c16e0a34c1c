#pragma once
// The same stack seen differently. All of these are exact in floating point, so whatever an engine decides on the
// original it can decide on the variant.

#include <cstdint>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

struct Variant {
  const char* name;
  ContourStack stack;
  /// Turning, mirroring and reversing permute the lexicographic order of points, by which ties between cocircular or
  /// cospherical points are broken; only stacks without such ties must then keep their topology. Permuting and doubling
  /// keep that order.
  bool keeps_order_of_points;
};

/// Rotated by 90 degrees, mirrored, z reversed, permuted (slices, contours, first points, directions), doubled in size.
std::vector<Variant> variants_of(const ContourStack& stack, std::uint64_t seed);

ContourStack rotated(ContourStack stack);
ContourStack mirrored(ContourStack stack);
ContourStack reversed(ContourStack stack);
ContourStack permuted(ContourStack stack, std::uint64_t seed);
ContourStack doubled(ContourStack stack);

}  // namespace odontoscope::test
