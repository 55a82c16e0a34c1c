#pragma once
// A teacher's notes: the list in the panel.

#include <string>

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

void notes_section(ViewerState& state, const Interface& interface);

}  // namespace odontoscope
