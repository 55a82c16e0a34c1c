#pragma once
// Stacks that are awkward for a grid.

#include "tests/support/shapes.h"

namespace odontoscope::test {

/// Two squares nearly touching with a corner each, a block over both, and the squares again: the face of the grid
/// between the corners is ambiguous, and the cells above and below it have few and many corners inside.
inline ContourStack corners_under_a_block() {
  const std::vector<Ring> squares{rectangle({0, 0}, {4, 4}), rectangle({4.05, 4.05}, {8, 8})};
  return stack_of({squares, {rectangle({0, 0}, {8, 8})}, squares});
}

}  // namespace odontoscope::test
