#pragma once
// Which part of a model walls a void in, how deep its places lie and how thick the wall is there.

#include <vector>

#include "engine/navigate/seen_within.h"
#include "engine/scene/model.h"
#include "engine/scene/scene.h"
#include "recon/cavity/cavity.h"
#include "recon/core/progress.h"

namespace odontoscope::app {

/// The model's part that walls the void in.
VoidWall wall_of(const Cavity& cavity, const odontoscope::Model& model);

/// What the scene's walls tell, if anything: ModelPart::depths_mm, ModelPart::thicknesses_mm. `surfaces` are those that
/// the model was made from. UsageError if there is no void, or no wall has a thickness to tell.
void mark_walls(const Scene& scene, odontoscope::Model& model, const std::vector<NamedSurface>& surfaces,
                const Progress& progress);

}  // namespace odontoscope::app
