#pragma once
// The panel while one flies, and its way in while one does not.

#include "engine/ui/interface.h"
#include "engine/viewer/fly/fly_state.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// Two buttons: into the pulp, and round the outside. Nothing where one cannot fly.
void fly_entrance(FlyState& fly, ViewerState& state, const Interface& interface);

/// Instead of the rest of the panel. Precondition: one flies.
void fly_sections(FlyState& fly, ViewerState& state, const Interface& interface);

}  // namespace odontoscope
