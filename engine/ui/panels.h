#pragma once
// The panel at the left, section by section. They change the state's plain values at once and ask for everything else
// as actions.

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// All of it, in `area` of the picture.
void draw_panel(ViewerState& state, const Interface& interface, const Area& area);

/// Two buttons side by side, each half as wide as the panel.
void two_buttons(ViewerState& state, const char* left, Action on_left, const char* right, Action on_right);

void report_section(ViewerState& state, const Interface& interface);
void structures_section(ViewerState& state, const Interface& interface);
void faces_section(ViewerState& state, const Interface& interface);
void overlays_section(ViewerState& state, const Interface& interface);
void measure_section(ViewerState& state, const Interface& interface);
void section_section(ViewerState& state, const Interface& interface);
void camera_section(ViewerState& state, const Interface& interface);
void picture_section(ViewerState& state, const Interface& interface);

}  // namespace odontoscope
