#pragma once
// A teacher's notes as the viewer has them. Part of ViewerState.

#include <cstddef>
#include <optional>

#include "engine/navigate/notes.h"

namespace odontoscope {

struct NotesState {
  TourNotes tour;
  std::optional<std::size_t> shown;      // of tour.notes: the lesson is being given
  std::optional<TourNote> draft;         // being written
  bool unsaved = false;
  // Asked for by the panels, done in the next frame.
  std::optional<std::size_t> go_to;
  bool write = false, save = false;
};

}  // namespace odontoscope
