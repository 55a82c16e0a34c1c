#pragma once
// What of a lesson is drawn beside the picture: the menu over it, and the dock below it with the note, its question or
// the result.

#include "engine/ui/interface.h"
#include "engine/viewer/notes/lesson_player.h"

namespace odontoscope {

/// The note that is being written, or else the one that is shown, or the result of a quiz: a strip along the lower edge
/// of `whole`, over all its width. Keeps its height in LessonPlayer::dock_height, so that the picture can end above it.
/// `canal`: that one is in, if any.
void draw_lesson_dock(NotesState& notes, ViewerState& state, LessonPlayer& lesson, const std::string& canal,
                      const Interface& interface, const Area& whole, float scale);

void draw_lesson_menu(ViewerState& state, LessonPlayer& lesson, const Interface& interface, const Area& viewport);

}  // namespace odontoscope
