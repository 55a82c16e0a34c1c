#pragma once
// A teacher's notes as plain values.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/navigate/notes.h"
#include "engine/viewer/loading.h"

namespace odontoscope {

/// What would lose notes that were not saved, and waits for an answer.
struct LeavingNotes {
  std::optional<LoadRequest> to_open;  // none: the window is to be closed
  enum class Answer { none, save, drop, stay };
  Answer answer = Answer::none;
};

struct NotesState {
  Lesson lesson;
  std::optional<std::size_t> shown;     // of lesson.notes: the lesson is being given
  std::optional<LessonNote> draft;      // being written,
  std::optional<std::size_t> draft_of;  // in place of this one of lesson.notes; none: a new one
  bool fresh_draft = false;             // its first field has not had the keyboard yet
  enum class Placing { none, pin, answer };
  Placing placing = Placing::none;                          // the next click in the picture is for the draft
  std::vector<std::pair<std::size_t, LessonNote>> removed;  // the last one last: from where, and what
  bool unsaved = false;
  std::optional<LeavingNotes> leaving;  // the question is being asked
  // Asked for by the panels, done in the next frame.
  std::optional<std::size_t> go_to;
  bool write = false, save = false, retake = false;

  /// Of the note that is being written, or else of the one that is shown; null: neither is there.
  const std::vector<LessonPin>* pins() const;
  /// Something would be lost if they went.
  bool at_risk() const;
};

/// The draft becomes a note. Precondition: there is one.
void keep_draft(NotesState& notes);
/// As if it had never been begun.
void drop_draft(NotesState& notes);
/// Begins to change a note. Precondition: there is one of that number.
void edit_note(NotesState& notes, std::size_t number);
/// One place up (`by` is -1) or down, as far as there is one.
void move_note(NotesState& notes, std::size_t number, int by);
void remove_note(NotesState& notes, std::size_t number);
/// The one that was removed last comes back where it was. Precondition: `removed` is not empty.
void bring_back_note(NotesState& notes);

}  // namespace odontoscope
