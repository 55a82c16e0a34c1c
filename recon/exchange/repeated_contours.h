#pragma once
// Contours that a file has twice. Inner part of read_rtstruct.h and repair_contours.h.

#include <cstddef>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope {

/// Numbers of those contours, ascending, that repeat an earlier one of their structure: the same points in the same
/// order or the opposite one, wherever it begins, points that repeat their neighbour aside. Near linear time.
std::vector<std::size_t> repeats_of_earlier(const std::vector<Contour>& contours);

}  // namespace odontoscope
