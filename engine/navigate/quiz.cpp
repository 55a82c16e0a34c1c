#include "engine/navigate/quiz.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/core/lower_case.h"

namespace odontoscope {

namespace {

/// "-3", "-3 mm": no formula.
bool is_measure(const std::string& text) {
  const std::size_t space = std::min(text.find(' '), text.size());
  return number_from(text.substr(0, space)) &&
         std::all_of(text.begin() + static_cast<std::ptrdiff_t>(space), text.end(),
                     [](char c) { return c == ' ' || std::isalpha(static_cast<unsigned char>(c)); });
}

/// Capitals do not count, and the pulp chamber may be called the chamber.
std::string plain_name(const std::string& name) {
  const std::string lower = lower_case(name);
  return lower == "pulp chamber" ? "chamber" : lower;
}

/// As RFC 4180 wants it; what begins like a formula is told to be text, since questions come from files and CSV is
/// opened in spreadsheets.
std::string csv_field(std::string text) {
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos && !is_measure(text))
    text.insert(text.begin(), '\'');
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

double rounded_seconds(double seconds) { return std::round(10 * seconds) / 10; }

}  // namespace

bool is_right(const LessonQuestion& question, const PointedAt& clicked) {
  return plain_name(clicked.structure) == plain_name(question.structure) &&
         (question.part.empty() || plain_name(clicked.part) == plain_name(question.part));
}
bool is_right(const LessonQuestion& question, std::size_t choice) {
  return static_cast<double>(choice) == question.answer;
}
/// Decimal numbers are rarely doubles: 0.1 off is within 0.1.
bool is_right(const LessonQuestion& question, double number) {
  const double slack = 1e-9 * std::max({1.0, std::abs(number), std::abs(question.answer)});
  return std::abs(number - question.answer) <= question.within + slack;
}

std::string number_in_words(double number, const std::string& unit) {
  return unit.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, unit);
}

std::string right_answer(const LessonQuestion& question) {
  switch (question.kind) {
    case LessonQuestion::Kind::click:
      return question.part.empty() ? question.structure : question.part;
    case LessonQuestion::Kind::choice:
      return question.choices[static_cast<std::size_t>(question.answer)];
    case LessonQuestion::Kind::number:
      break;
  }
  return number_in_words(question.answer, question.unit);
}

std::optional<double> number_from(std::string text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(' ') - first + 1);
  std::replace(text.begin(), text.end(), ',', '.');
  double value = 0;
  const char *begin = text.data() + (text.front() == '+' ? 1 : 0), *end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc() && rest == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::size_t Quiz::score() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const QuizRow& row) { return row.right; }));
}
bool Quiz::finished() const {
  return std::all_of(rows.begin(), rows.end(), [](const QuizRow& row) { return row.answered; });
}
QuizRow* Quiz::row_of(std::size_t note) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const QuizRow& row) { return row.note == note; });
  return found == rows.end() ? nullptr : &*found;
}
const QuizRow* Quiz::row_of(std::size_t note) const { return const_cast<Quiz*>(this)->row_of(note); }

Quiz quiz_of(const Lesson& lesson) {
  Quiz quiz{lesson.title, {}, lesson.feedback_at_end};
  for (std::size_t note = 0; note < lesson.notes.size(); ++note)
    if (const auto& question = lesson.notes[note].question)
      quiz.rows.push_back({note, question->kind, question->ask, {}});
  return quiz;
}

std::string marks_csv(const Quiz& quiz) {
  std::string text = "number,kind,question,given,right,seconds\n";
  for (std::size_t i = 0; i < quiz.rows.size(); ++i) {
    const QuizRow& row = quiz.rows[i];
    text += fmt::format("{},{},{},{},{},{:.1f}\n", i + 1, word_of(question_kinds, row.kind), csv_field(row.question),
                        csv_field(row.given), row.right ? "yes" : "no", rounded_seconds(row.seconds));
  }
  return text;
}

std::string marks_json(const Quiz& quiz) {
  using Json = nlohmann::ordered_json;
  Json json{{"format", "odontoscope.marks"}, {"version", 1},           {"title", quiz.title},
            {"score", quiz.score()},         {"of", quiz.rows.size()}, {"rows", Json::array()}};
  for (std::size_t i = 0; i < quiz.rows.size(); ++i) {
    const QuizRow& row = quiz.rows[i];
    json["rows"].push_back({{"number", i + 1},
                            {"kind", word_of(question_kinds, row.kind)},
                            {"question", row.question},
                            {"given", row.given},
                            {"right", row.right},
                            {"seconds", rounded_seconds(row.seconds)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace odontoscope
