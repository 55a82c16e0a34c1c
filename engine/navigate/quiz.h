#pragma once
// A quiz: the questions of a lesson's notes in their order, what was answered, and the marks for it as CSV and JSON.
//
//   number,kind,question,given,right,seconds
//   1,choice,Which structure is this?,dentine,yes,4.2
//
//   {"format":"odontoscope.marks","version":1,"title":"Find your way","score":1,"of":1,
//    "rows":[{"number":1,"kind":"choice","question":"Which structure is
//    this?","given":"dentine","right":true,"seconds":4.2}]}
//
// "given" is the answer in words, "right" whether it counts. A question that was passed over has an empty "given" and
// is not right.

#include <optional>
#include <string>
#include <vector>

#include "engine/navigate/notes.h"

namespace odontoscope {

/// What was clicked: its structure, and the named part nearest there, if the model has any.
struct PointedAt {
  std::string structure, part;
};

struct QuizRow {
  std::size_t note = 0;  // whose question it is
  LessonQuestion::Kind kind = LessonQuestion::Kind::choice;
  std::string question, given;
  bool answered = false, right = false;
  double seconds = 0;  // from when it was first seen to its answer
};

bool is_right(const LessonQuestion& question, const PointedAt& clicked);
bool is_right(const LessonQuestion& question, std::size_t choice);
bool is_right(const LessonQuestion& question, double number);
/// "mesiobuccal canal", "dentine", "13.6 mm".
std::string right_answer(const LessonQuestion& question);
/// "13.6 mm"; no more digits than the number has.
std::string number_in_words(double number, const std::string& unit);
/// A decimal comma counts as a point; empty: no number, or not finite.
std::optional<double> number_from(std::string text);

/// One run through the questions.
struct Quiz {
  std::string title;
  std::vector<QuizRow> rows;  // one for each note with a question
  bool at_end = false;        // right or wrong is told when all are answered
  std::size_t score() const;
  bool finished() const;  // all are answered
  QuizRow* row_of(std::size_t note);
  const QuizRow* row_of(std::size_t note) const;
};
Quiz quiz_of(const Lesson& lesson);

std::string marks_csv(const Quiz& quiz);
std::string marks_json(const Quiz& quiz);

}  // namespace odontoscope
