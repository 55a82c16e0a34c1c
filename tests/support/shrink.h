#pragma once
// Makes a failing stack small enough to look at.

#include <chrono>
#include <functional>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::test {

/// Drops slices, contours and runs of points, then single points, as long as the stack stays valid and `fails` still
/// says true; stops at a stack from which nothing more can go, or when the time is up. `fails(stack)` must be true on
/// entry.
ContourStack shrunk(ContourStack stack, const std::function<bool(const ContourStack&)>& fails,
                    std::chrono::seconds time = std::chrono::seconds(20));

/// A stack, its slices by ascending z, and the user's links between its contours.
struct LinkedStack {
  ContourStack stack;
  std::vector<Link> links;
};

/// The same with links, which are dropped too, and keep naming the same contours when others go.
LinkedStack shrunk(LinkedStack linked, const std::function<bool(const LinkedStack&)>& fails,
                   std::chrono::seconds time = std::chrono::seconds(20));

}  // namespace odontoscope::test
