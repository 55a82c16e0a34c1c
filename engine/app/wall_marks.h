#pragma once
// Which part of a model walls a void in, and how deep its places lie.

#include <vector>

#include "engine/navigate/seen_within.h"
#include "engine/scene/model.h"
#include "recon/cavity/cavity.h"
#include "recon/core/progress.h"

namespace odontoscope::app {

/// The model's part that walls the void in.
VoidWall wall_of(const Cavity& cavity, const odontoscope::Model& model);

/// Fills in ModelPart::depths_mm of all walls of voids. `surfaces` are those that the model was made from. UsageError
/// if there is no void.
void mark_wall_depths(odontoscope::Model& model, const std::vector<NamedSurface>& surfaces, const Progress& progress);

}  // namespace odontoscope::app
