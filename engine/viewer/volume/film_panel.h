#pragma once
// The panel's controls of an X-ray film: of the model where there is no CT, and for either how the tube stands and how
// long canals are on the film.

#include "engine/ui/interface.h"
#include "engine/viewer/viewer_state.h"
#include "engine/viewer/volume/volume_layout.h"

namespace odontoscope {

/// The section of a model without grey values, if it is closed and anything is known of its tissues; else nothing.
void film_section(VolumeAsked& asked, ViewerState& state, const Interface& interface);

/// The film's size, the beam and the tube, and lengths on the film as the camera shows it.
void film_controls(VolumeAsked& asked, ViewerState& state, const Interface& interface);

}  // namespace odontoscope
