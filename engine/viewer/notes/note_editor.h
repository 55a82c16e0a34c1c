#pragma once
// A note being written or changed: title, text, pins and a question. Drawn into the window that is open (see
// lesson_cards.h).

#include <string>

#include "engine/ui/interface.h"
#include "engine/viewer/notes/notes_state.h"

namespace odontoscope {

/// `canal`: that one is in, if any.
void note_editor(NotesState& notes, const std::string& canal, const Interface& interface);

/// What is wrong with the draft, in words; empty: it can be kept.
std::string fault_of_draft(const LessonNote& draft);

}  // namespace odontoscope
