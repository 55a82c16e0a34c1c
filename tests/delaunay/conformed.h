#pragma once
// Stacks taken as far as the engine's first steps take them.

#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/input/validate.h"

namespace odontoscope::test {

/// One structure's slices by ascending z.
inline std::vector<delaunay::ConformedSlice> conformed(const ContourStack& stack,
                                                       const std::string& structure = "tooth") {
  validate(stack);
  const OrderedStack input = ordered(stack);
  std::vector<delaunay::ConformedSlice> slices;
  for (std::size_t k = 0; k < input.stack.slices.size(); ++k)
    slices.push_back(delaunay::conform(input.stack.slices[k], structure, k, {}, {}));
  return slices;
}

}  // namespace odontoscope::test
