#pragma once
// What the benchmark runs on.

#include <cstddef>
#include <string>

#include "recon/input/contour_stack.h"

namespace odontoscope::benchmark_inputs {

/// The CT molar's contours at 120 with a least area of 4, or, where that data set is missing, the sample molar's.
struct Molar {
  std::string name;
  ContourStack stack;
};
Molar molar();

/// A tube with a drifting canal: `slices` slices with `points` points each.
ContourStack made_up(std::size_t slices, std::size_t points);

std::size_t points_of(const ContourStack& stack);

}  // namespace odontoscope::benchmark_inputs
