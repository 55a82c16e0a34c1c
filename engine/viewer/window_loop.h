#pragma once
// The viewer in a window, until it is closed.

#include <stop_token>

#include "engine/view/window.h"
#include "engine/viewer/viewer.h"

namespace odontoscope {

/// Returns when the window is closed, a stop is requested, or the headset is asked for (ViewerState::headset_asked).
/// What would be lost by closing is asked about first, also of a stop; of each stop once. Draws when something happens,
/// and rests otherwise.
void run_in_window(Viewer& viewer, Window& window, const std::stop_token& stop);

}  // namespace odontoscope
