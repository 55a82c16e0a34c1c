#pragma once
// A teacher's notes: the list in the panel, the card to write one on, and the card that a lesson is read from.

#include <string>

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

void notes_section(ViewerState& state, const Interface& interface);

/// The note that is being written, or else the one that is shown.
void draw_note_card(ViewerState& state, const Interface& interface, const Area& viewport, float scale);

}  // namespace odontoscope
