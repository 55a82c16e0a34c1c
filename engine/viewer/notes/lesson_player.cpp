#include "engine/viewer/notes/lesson_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace odontoscope {

namespace {

constexpr std::size_t most_typed = 24;

const LessonQuestion* question_of(const NotesState& notes) {
  if (!notes.shown || *notes.shown >= notes.lesson.notes.size()) return nullptr;
  const auto& question = notes.lesson.notes[*notes.shown].question;
  return question ? &*question : nullptr;
}

/// The same questions of the same notes.
bool is_of(const Quiz& quiz, const Lesson& lesson) {
  const Quiz fresh = quiz_of(lesson);
  return quiz.title == fresh.title && quiz.at_end == fresh.at_end &&
         std::equal(quiz.rows.begin(), quiz.rows.end(), fresh.rows.begin(), fresh.rows.end(),
                    [](const QuizRow& a, const QuizRow& b) {
                      return a.note == b.note && a.kind == b.kind && a.question == b.question;
                    });
}

bool belongs_to_number(char32_t character, const std::string& typed) {
  if (character >= U'0' && character <= U'9') return true;
  if (character == U'-') return typed.empty();
  return (character == U'.' || character == U',') && typed.find_first_of(".,") == std::string::npos;
}

}  // namespace

std::size_t lesson_choices() { return lesson_tours().size() + 2; }

void LessonPlayer::toggle_menu() {
  menu_ = !menu_;
  if (menu_ && lessons_.empty()) lessons_ = built_in_lessons();
  menu_at_ = 0;
}

void LessonPlayer::choose(std::size_t number, ViewerState& state) {
  const std::size_t built_in = lesson_tours().size();
  menu_ = false;
  if (number < built_in)
    state.to_load = LoadRequest{.file = {}, .volume = {}, .lesson = number};
  else if (number == built_in)
    state.pending_actions.push_back(Action::toggle_lesson);
  else if (number == built_in + 1)
    state.pending_actions.push_back(Action::open_file);
}

void LessonPlayer::enter(const NotesState& notes) {
  typed_.clear();
  result_ = false;
  if (!notes.lesson.is_quiz())
    quiz_.reset();
  else if (!quiz_ || !is_of(*quiz_, notes.lesson))
    quiz_ = quiz_of(notes.lesson);
}

void LessonPlayer::leave() {
  quiz_.reset();
  result_ = false;
  typed_.clear();
}

void LessonPlayer::again(NotesState& notes) {
  leave();
  notes.go_to = 0;
}

const QuizRow* LessonPlayer::row(const NotesState& notes) const {
  return quiz_ && notes.shown && !result_ ? quiz_->row_of(*notes.shown) : nullptr;
}

const LessonQuestion* LessonPlayer::asked(const NotesState& notes) const {
  const QuizRow* now = row(notes);
  return now && !now->answered ? question_of(notes) : nullptr;
}

bool LessonPlayer::wants_click(const NotesState& notes) const {
  const LessonQuestion* question = asked(notes);
  return question && question->kind == LessonQuestion::Kind::click;
}

QuizRow* LessonPlayer::row_asked(const NotesState& notes) {
  return asked(notes) ? quiz_->row_of(*notes.shown) : nullptr;
}

void LessonPlayer::finish(QuizRow& row, std::string given, bool right) {
  row.given = std::move(given);
  row.answered = true;
  row.right = right;
  typed_.clear();
}

void LessonPlayer::answer(const NotesState& notes, const PointedAt& clicked) {
  if (!wants_click(notes)) return;
  finish(*row_asked(notes), clicked.part.empty() ? clicked.structure : clicked.part, is_right(*asked(notes), clicked));
}

void LessonPlayer::answer(const NotesState& notes, std::size_t choice) {
  const LessonQuestion* question = asked(notes);
  if (!question || question->kind != LessonQuestion::Kind::choice || choice >= question->choices.size()) return;
  finish(*row_asked(notes), question->choices[choice], is_right(*question, choice));
}

void LessonPlayer::answer_typed(const NotesState& notes) {
  const LessonQuestion* question = asked(notes);
  if (!question || question->kind != LessonQuestion::Kind::number) return;
  if (const auto number = number_from(typed_))
    finish(*row_asked(notes), number_in_words(*number, question->unit), is_right(*question, *number));
}

std::string LessonPlayer::feedback(const NotesState& notes) const {
  const QuizRow* now = row(notes);
  const LessonQuestion* question = question_of(notes);
  if (!now || !now->answered || !question) return {};
  if (quiz_->at_end) return fmt::format("Your answer: {}. Right or wrong is told at the end.", now->given);
  if (now->right) return fmt::format("Right: {}.", now->given);
  return fmt::format("You said {}. It is {}.", now->given, right_answer(*question));
}

bool LessonPlayer::step(int by, const NotesState& notes) {
  if (!quiz_ || !notes.shown) return false;
  if (result_) {
    result_ = by > 0;
    return true;
  }
  if (by < 0 || *notes.shown + 1 < notes.lesson.notes.size()) return false;
  result_ = true;
  return true;
}

void LessonPlayer::advance(const NotesState& notes, double seconds) {
  QuizRow* waiting = row_asked(notes);
  if (!waiting) {
    clock_before_.reset();
    return;
  }
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  waiting->seconds += std::max(seconds, now - clock_before_.value_or(now));
  clock_before_ = now;
}

bool LessonPlayer::handle(const Event& event, const NotesState& notes, ViewerState& state) {
  const auto* key = std::get_if<KeyChanged>(&event);
  const auto* text = std::get_if<TextTyped>(&event);
  const bool enter = key && key->down && key->key == Key::enter;
  if (menu_) {
    const std::size_t count = lesson_choices();
    if (key && key->down && key->key == Key::down)
      menu_at_ = (menu_at_ + 1) % count;
    else if (key && key->down && key->key == Key::up)
      menu_at_ = (menu_at_ + count - 1) % count;
    else if (enter)
      choose(menu_at_, state);
    else if (text && text->character >= U'1' && text->character < U'1' + count)
      choose(text->character - U'1', state);
    else
      return text && text->character != U'?' && text->character != U'g' && text->character != U'G';
    return true;
  }
  if (notes.draft || !notes.shown) return false;
  if (result_ && enter) {
    save_marks = true;
    return true;
  }
  const LessonQuestion* question = asked(notes);
  if (!question) {
    if (!enter || !row(notes)) return false;
    state.pending_actions.push_back(Action::next_step);
    return true;
  }
  switch (question->kind) {
    case LessonQuestion::Kind::click:
      if (!enter) return false;
      pick_middle = true;
      return true;
    case LessonQuestion::Kind::choice:
      if (!text || text->character < U'1' || text->character >= U'1' + question->choices.size()) return false;
      answer(notes, static_cast<std::size_t>(text->character - U'1'));
      return true;
    case LessonQuestion::Kind::number:
      break;
  }
  if (text && belongs_to_number(text->character, typed_)) {
    if (typed_.size() < most_typed) typed_ += static_cast<char>(text->character);
    return true;
  }
  if (key && key->down && key->key == Key::backspace && !typed_.empty()) {
    typed_.pop_back();
    return true;
  }
  if (enter) answer_typed(notes);
  return enter;
}

}  // namespace odontoscope
