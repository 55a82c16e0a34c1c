#pragma once
// What is drawn over the picture while one flies: the fade, the vignette, and where one is.

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// The inside of a tooth by lamplight: dentine, warmer than from outside.
inline constexpr Colour wall_colour = colour_of(0xe8cba6);

/// Slower and faster than usual, at most.
inline constexpr double least_haste = 0.2, most_haste = 8;

/// Darkens the picture for passages, and its rim while it turns if that is wanted.
void draw_fade(const ViewerState& state, const Area& viewport);

}  // namespace odontoscope
