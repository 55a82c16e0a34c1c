#pragma once
// What walls tell in flight: depth, thickness or nothing; and the legend of the colours of thickness.

#include "engine/navigate/labels.h"
#include "engine/ui/area.h"
#include "engine/ui/interface.h"
#include "engine/viewer/settings.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// Thickness goes before depth.
WallNumber told_on_wall(const Comfort& comfort);
void tell_on_wall(Comfort& comfort, WallNumber number);
/// Depth, then thickness where the model has any, then nothing.
void next_on_wall(Comfort& comfort, bool tells_thickness);

/// "A line every 0.2 mm, ...".
std::string thickness_in_words(const Model& model);

/// A bar of the colours with the bold lines' numbers below, at the lower left of the picture; nothing if the scene
/// shows no thickness.
void draw_thickness_legend(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale);

}  // namespace odontoscope
