#pragma once
// What of a lesson is drawn: the menu over the picture, the dock below it with the note, its question or the result,
// and pins in the picture.

#include "engine/ui/interface.h"
#include "engine/viewer/notes/lesson_player.h"

namespace odontoscope {

/// The note that is being written, or else the one that is shown, or the result of a quiz: a strip along the lower edge
/// of `whole`, over all its width. Keeps its height in LessonPlayer::dock_height, so that the picture can end above it.
/// `canal`: that one is in, if any.
void draw_lesson_dock(NotesState& notes, ViewerState& state, LessonPlayer& lesson, const std::string& canal,
                      const Interface& interface, const Area& whole, float scale);

void draw_lesson_menu(ViewerState& state, LessonPlayer& lesson, const Interface& interface, const Area& viewport);

/// From outside; else in that cavity, or around the tooth (null).
struct PinsSeenFrom {
  bool outside = true;
  const FlightSpace* cavity = nullptr;
};
/// Pins, each with its label; inside a cavity a wall hides them, outside they pale behind what is opaque.
void draw_pins(const std::vector<LessonPin>& marks, const ViewerState& state, const PinsSeenFrom& from,
               const ViewPane& pane, const Interface& interface, float scale);

}  // namespace odontoscope
