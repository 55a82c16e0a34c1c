#pragma once
// A note being written or changed: title, text, pins and a question. Drawn into the window that is open (see
// lesson_cards.h).

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

void note_editor(ViewerState& state, const Interface& interface);

/// What is wrong with the draft, in words; empty: it can be kept.
std::string fault_of_draft(const LessonNote& draft);

}  // namespace odontoscope
