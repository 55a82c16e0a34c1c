#pragma once
// A lesson that is given: the menu to choose one from, the questions of a quiz with what was answered, and the dock
// below the picture that they are read from. What the notes are and which is shown stands in NotesState; going to one
// is the work of NotesMode.
//
// Without a mouse: in the menu arrows and Enter, or a digit; a choice by its digit; a number by typing it, then Enter;
// something to click by turning the tooth under the cross, then Enter. After an answer Enter leads on.

#include <optional>
#include <string>
#include <vector>

#include "engine/navigate/built_in_lessons.h"
#include "engine/navigate/quiz.h"
#include "engine/view/input.h"
#include "engine/viewer/notes/notes_state.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

class LessonPlayer {
 public:
  /// The list of lessons is open.
  bool menu() const { return menu_; }
  void toggle_menu();
  void close_menu() { menu_ = false; }

  /// Another note is shown: begins the quiz of its lesson if that is not being taken already.
  void enter(const NotesState& notes);
  /// Forgets answers: the lesson is over.
  void leave();
  /// true: it was meant for the lesson.
  bool handle(const Event& event, const NotesState& notes, ViewerState& state);
  /// Past the last note lies the result. true: it was shown, or put away.
  bool step(int by, const NotesState& notes);
  /// Counts the time for the question that waits. `seconds` are the frame's, which a window at rest cuts short: by the
  /// clock it may have been longer.
  void advance(const NotesState& notes, double seconds);

  /// The question on the screen that waits for an answer; null: none.
  const LessonQuestion* asked(const NotesState& notes) const;
  bool wants_click(const NotesState& notes) const;
  void answer(const NotesState& notes, const PointedAt& clicked);
  void answer(const NotesState& notes, std::size_t choice);
  /// What was typed; nothing happens if that is no number.
  void answer_typed(const NotesState& notes);

  const std::optional<Quiz>& quiz() const { return quiz_; }
  /// The result is shown instead of a note.
  bool result() const { return result_; }
  const std::string& typed() const { return typed_; }
  std::size_t menu_at() const { return menu_at_; }
  /// Built-in ones that the menu lists; read when it is opened first.
  const std::vector<BuiltInLesson>& lessons() const { return lessons_; }
  /// Words for what was just answered: "Right.", "No: it is the distal canal."; empty while nothing may be told.
  std::string feedback(const NotesState& notes) const;
  const QuizRow* row(const NotesState& notes) const;
  void again(NotesState& notes);
  /// Of the menu: a built-in lesson, or behind them the one about culling, or a file.
  void choose(std::size_t number, ViewerState& state);

  // Asked for, done in the next frame.
  bool pick_middle = false, save_marks = false;
  /// What is said beyond a note's text is unfolded.
  bool narration_open = false;
  /// How high the dock was when it was drawn last, in pixels.
  double dock_height = 0;

 private:
  QuizRow* row_asked(const NotesState& notes);
  void finish(QuizRow& row, std::string given, bool right);

  bool menu_ = false, result_ = false;
  std::size_t menu_at_ = 0;
  std::vector<BuiltInLesson> lessons_;
  std::optional<Quiz> quiz_;
  std::string typed_;
  std::optional<double> clock_before_;  // s, of the frame before, while a question waits
};

/// Entries of the menu: built-in lessons, "Why culling shows errors", "Open a lesson's file".
std::size_t lesson_choices();

}  // namespace odontoscope
