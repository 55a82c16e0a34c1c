#pragma once
// Cameras that see all that is shown: what is hidden needs no room in the picture.

#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace odontoscope {

/// As `fit` of camera.h, without the structures named; with all of them if nothing else is left.
Camera fit_without(const std::vector<std::string>& hidden, const Camera& looking, const Model& model, double aspect);
Camera fit_without(const std::vector<std::string>& hidden, NamedView view, const Model& model, double aspect,
                   Camera::Projection projection);

/// Names of the structures that the scene hides.
std::vector<std::string> hidden_in(const Scene& scene);

}  // namespace odontoscope
