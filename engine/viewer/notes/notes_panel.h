#pragma once
// A teacher's notes: the list in the panel.

#include "engine/ui/interface.h"
#include "engine/viewer/notes/lesson_history.h"

namespace odontoscope {

void notes_section(NotesState& notes, const LessonHistory& history, bool from_outside, const Interface& interface);

}  // namespace odontoscope
