#pragma once
// What is shown while a model is being made: the same contours, but few of them.

#include <optional>

#include "engine/ui/loading.h"
#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::app {

/// A model of at most two dozen slices and of contours with fewer points, said to be such by its certificate; nothing where that fails, or where
/// the whole is not much more work. Throws Cancelled.
std::optional<LoadedModel> draft_of(const ContourStack& stack, const std::string& title, const Progress& progress);

}  // namespace odontoscope::app
