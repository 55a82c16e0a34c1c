#pragma once
// Roots with known canals, drawn at random and cut into slices: what the anatomy tells of them can be judged.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/cavity/anatomy.h"
#include "recon/input/contour_stack.h"
#include "tests/cavity/voids.h"

namespace odontoscope::test {

/// One of Vertucci's eight types, by turns; height, width, radius, chamber and unevenness at random. The same for the same seed, on every machine.
RootShape random_root(std::uint64_t seed);

/// The root's void in a round block, cut so far apart.
ContourStack slices_of(const RootShape& shape, double spacing);

/// What was told of one, against what is known.
struct FamilyVerdict {
  bool counted = false;        // as many canals, the type and the sections
  double length_error = 0;     // greatest of its canals', from the chamber's centre, as a share
  double width_error = 0;      // greatest of its canals' narrowest width, likewise
  std::string told;            // "II expected, told I [1], 1 canal"
};
FamilyVerdict judge(const RootShape& shape, double spacing);

}  // namespace odontoscope::test
