#pragma once
// The panel's heading, what its sections have in common, and short notices over the picture.

#include <vector>

#include "engine/ui/interface.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

void panel_heading(ViewerState& state, const Interface& interface);

/// Two buttons side by side, each half as wide as the panel.
void two_buttons(std::vector<Action>& pending, const char* left, Action on_left, const char* right, Action on_right);

/// A square of the colour that opens a picker. true: another was chosen.
bool colour_swatch(const char* id, Colour& colour);

/// At the lower edge of the viewport.
void draw_notices(const std::vector<Notice>& notices, const Interface& interface, const Area& viewport);

}  // namespace odontoscope
