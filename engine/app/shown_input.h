#pragma once
// What a picture is made of: any file that has, or can be made into, surfaces.

#include <string>

#include "engine/app/command.h"
#include "engine/app/volume_options.h"
#include "engine/scene/model.h"
#include "engine/scene/overlay.h"

namespace odontoscope::app {

/// What a picture shows, and what its overlays are made from: contours and tetrahedra of whatever was reconstructed, the faulty edges of
/// any surface.
struct Shown {
  odontoscope::Model model;
  OverlaySource overlays;
};

/// A contour stack is reconstructed, and so is a volume if `words` say where its surface lies; GLB, STL and PLY are taken as
/// they are, told by their content. Empty `file`: the sample molar. Throws as the readers and the engine do.
Shown shown_from(const std::string& file, const VolumeWords& words, Session& session);

}  // namespace odontoscope::app
