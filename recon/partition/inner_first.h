#pragma once
// Which structure lies in which.

#include <cstdint>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::partition {

/// The structures' numbers, from the inside out: those that most others enclose first, of these the one with the least
/// area. A structure encloses another if most of that one's contours lie within its outer contours. Precondition: the
/// stack is ordered.
std::vector<std::uint32_t> inner_first(const ContourStack& stack, const std::vector<std::string>& structures);

}  // namespace odontoscope::partition
