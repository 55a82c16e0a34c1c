#pragma once
// What of a lesson is drawn: the menu over the picture, the dock below it with the note, its question or the result,
// and pins in the picture.

#include "engine/ui/lesson_mode.h"

namespace odontoscope {

/// The note that is being written, or else the one that is shown, or the result of a quiz: a strip along the lower edge
/// of `whole`, over all its width. Keeps its height in LessonMode::dock_height, so that the picture can end above it.
void draw_lesson_dock(ViewerState& state, LessonMode& lesson, const Interface& interface, const Area& whole,
                      float scale);

void draw_lesson_menu(ViewerState& state, LessonMode& lesson, const Interface& interface, const Area& viewport);

/// Pins of the note that is shown or written, each with its label; inside a cavity a wall hides them, outside they pale
/// behind what is opaque.
void draw_pins(const ViewerState& state, const ViewPane& pane, const Interface& interface, float scale);

/// The cross in the picture's middle that Enter takes, where something is to be pointed at.
void draw_cross(const ViewPane& pane, float scale);

}  // namespace odontoscope
