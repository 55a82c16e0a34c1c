#pragma once
// What a picture is made of: any file that has, or can be made into, surfaces.

#include <string>

#include "engine/app/command.h"
#include "engine/app/volume_options.h"
#include "engine/scene/model.h"

namespace odontoscope::app {

/// A contour stack is reconstructed, and so is a volume if `words` say where its surface lies; GLB, STL and PLY are taken as
/// they are, told by their content. Empty `file`: the sample molar. Throws as the readers and the engine do.
odontoscope::Model model_from(const std::string& file, const VolumeWords& words, Session& session);

}  // namespace odontoscope::app
