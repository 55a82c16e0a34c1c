#pragma once
// What is shown while a model is being made: the same contours, but few of them.

#include <optional>
#include <span>
#include <string>

#include "engine/viewer/loading.h"
#include "recon/core/embedded_file.h"
#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::app {

/// A model of at most two dozen slices and of contours with fewer points, said to be such by its certificate; nothing
/// where that fails, or where the whole is not much more work. Throws Cancelled.
std::optional<LoadedModel> draft_of(const ContourStack& stack, const std::string& title, const Progress& progress);

/// The sample molar with few triangles, made before and kept in assets/drafts: it is there at once.
/// docs/sample-teeth.md says how it is made anew.
LoadedModel draft_of_sample(const std::string& title, const Progress& progress);

}  // namespace odontoscope::app

namespace odontoscope {

/// In draft_files.cpp, written by the build.
std::span<const EmbeddedFile> draft_files();

}  // namespace odontoscope
