#pragma once
// How the grey values of a volume are shown, in the panel.

#include "engine/ui/interface.h"
#include "engine/viewer/viewer_state.h"
#include "engine/viewer/volume/volume_layout.h"

namespace odontoscope {

/// Surfaces, volume or both; how rays are cast; transfer function over the histogram, on which the values of the
/// surfaces stand as lines. Nothing for what came from no volume.
void volume_section(VolumeLayout& layout, VolumeAsked& asked, ViewerState& state, const Interface& interface);

}  // namespace odontoscope
