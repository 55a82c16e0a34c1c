#pragma once
// A teacher's notes as the viewer has them. Part of ViewerState.

#include <cstddef>
#include <optional>

#include "engine/navigate/notes.h"
#include "engine/ui/loading.h"

namespace odontoscope {

/// What would lose notes that were not saved, and waits for an answer.
struct LeavingNotes {
  std::optional<LoadRequest> to_open;    // none: the window is to be closed
  enum class Answer { none, save, drop, stay };
  Answer answer = Answer::none;
};

struct NotesState {
  TourNotes tour;
  std::optional<std::size_t> shown;      // of tour.notes: the lesson is being given
  std::optional<TourNote> draft;         // being written
  bool unsaved = false;
  std::optional<LeavingNotes> leaving;   // the question is being asked
  // Asked for by the panels, done in the next frame.
  std::optional<std::size_t> go_to;
  bool write = false, save = false;
};

/// The draft becomes a note. Precondition: there is one.
void keep_draft(NotesState& notes);

}  // namespace odontoscope
