#pragma once
// Makes a failing stack small enough to look at.

#include <chrono>
#include <functional>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// Drops slices, contours and runs of points, then single points, as long as the stack stays valid and `fails` still says true; stops at
/// a stack from which nothing more can go, or when the time is up. `fails(stack)` must be true on entry.
ContourStack shrunk(ContourStack stack, const std::function<bool(const ContourStack&)>& fails,
                    std::chrono::seconds time = std::chrono::seconds(20));

}  // namespace odontoscope::test
