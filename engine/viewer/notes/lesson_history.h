#pragma once
// What undo brings back of a lesson that is being made: the whole lesson as it was after each change, and the note that
// was being written.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "engine/viewer/notes/notes_state.h"

namespace odontoscope {

struct LessonEdit {
  Lesson lesson;
  std::optional<LessonNote> draft = {};
  std::optional<std::size_t> draft_of = {};
};

/// Changes of one note are single steps as long as it is being written; once it is kept, all of them are one. What was
/// cancelled comes back by undo.
class LessonHistory {
 public:
  /// Looks in each frame what has changed. Words that are begun, as somebody types them, are one change in the end.
  enum class Words { whole, begun };
  void watch(const NotesState& notes, Words words);
  /// The lesson as it was before the last change; nothing: there was none. Tells what was changed, in words.
  std::optional<std::string> undo(NotesState& notes) { return step(notes, past_, future_); }
  /// What was undone last, again.
  std::optional<std::string> redo(NotesState& notes) { return step(notes, future_, past_); }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

 private:
  std::optional<std::string> step(NotesState& notes, std::deque<LessonEdit>& from, std::deque<LessonEdit>& to);

  std::optional<LessonEdit> now_;
  std::deque<LessonEdit> past_, future_;  // the nearest one last
};

/// What is not the same in two states of a lesson, as words that go on after "Undone: ".
std::string change_in_words(const LessonEdit& one, const LessonEdit& other);

}  // namespace odontoscope
