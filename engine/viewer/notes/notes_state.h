#pragma once
// A teacher's notes as plain values.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
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

/// Where an arrow begins that is being drawn: on the sight line of the first click.
struct ArrowTail {
  Camera camera;                           // of that view
  glm::dvec2 place{0};                     // in its picture, as screen.h counts
  std::optional<glm::dvec3> surface = {};  // what lies there, mm; nothing beside the tooth
};
/// Beside the place that it points at, so that both lie in the picture of the first click; but on what lies before
/// that. Nothing: it would end where it begins, or behind the eye.
std::optional<LessonArrow> arrow_from(const ArrowTail& tail, const glm::dvec3& to);

struct NotesState {
  Lesson lesson;
  std::optional<std::size_t> shown;     // of lesson.notes: the lesson is being given
  std::optional<LessonNote> draft;      // being written,
  std::optional<std::size_t> draft_of;  // in place of this one of lesson.notes; none: a new one
  bool fresh_draft = false;             // its first field has not had the keyboard yet
  enum class Placing { none, pin, answer, arrow_tail, arrow_head };
  Placing placing = Placing::none;     // the next click in the picture is for the draft
  std::optional<ArrowTail> tail;       // of an arrow whose head is placed next,
  std::optional<std::size_t> redrawn;  // in place of this one of the draft's; none: another
  bool unsaved = false;
  Lesson saved;                         // as it was opened, or saved last
  std::optional<LeavingNotes> leaving;  // the question is being asked
  // Asked for by the panels, done in the next frame.
  std::optional<std::size_t> go_to;
  bool write = false, save = false, retake = false, undo = false, redo = false;

  /// Of the note that is being written, or else of the one that is shown; null: neither is there.
  const LessonNote* seen() const;
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
/// The draft's arrow ends there. Precondition: there is a tail. false: it cannot, and nothing has changed.
bool end_arrow(NotesState& notes, const glm::dvec3& to);
void stop_placing(NotesState& notes);

}  // namespace odontoscope
