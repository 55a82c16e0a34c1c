#include "engine/viewer/notes/lesson_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace odontoscope {

namespace {

constexpr std::size_t most_steps = 200, most_steps_bytes = 64u << 20;

LessonEdit edit_of(const NotesState& notes) { return {notes.lesson, notes.draft, notes.draft_of}; }

/// A note that is open for writing, and has nothing in it that would be lost, is as good as none.
const LessonNote* words_of(const LessonEdit& edit) {
  NotesState notes;
  if (!edit.draft) return nullptr;
  if (edit.draft_of && *edit.draft_of < edit.lesson.notes.size())
    return *edit.draft == edit.lesson.notes[*edit.draft_of] ? nullptr : &*edit.draft;
  notes.draft = edit.draft;
  return notes.at_risk() ? &*edit.draft : nullptr;
}

bool same_words(const LessonEdit& one, const LessonEdit& other) {
  const LessonNote *a = words_of(one), *b = words_of(other);
  return one.lesson == other.lesson && (!a) == (!b) && (!a || (*a == *b && one.draft_of == other.draft_of));
}

/// About how much memory it takes.
std::size_t bytes_of(const LessonEdit& edit) {
  std::size_t bytes = 0;
  for (const LessonNote& note : edit.lesson.notes)
    bytes += sizeof(note) + note.text.size() + note.narration.size() + note.scene.size() +
             (note.marks.size() + note.arrows.size()) * sizeof(LessonArrow);
  return bytes;
}

std::string note_change_in_words(const LessonNote& one, const LessonNote& other) {
  if (one.title != other.title) return "the title";
  if (one.text != other.text) return "the text";
  if (one.narration != other.narration) return "the narration";
  if (one.marks != other.marks) return "a pin";
  if (one.arrows != other.arrows) return "an arrow";
  if (one.question != other.question) return "the question";
  if (one.tour != other.tour) return "the ride";
  return "the view";
}

}  // namespace

std::string change_in_words(const LessonEdit& one, const LessonEdit& other) {
  if (one.lesson.title != other.lesson.title) return "the lesson's title";
  if (one.lesson.notes.size() != other.lesson.notes.size()) return "a note more or less";
  if (one.lesson.notes != other.lesson.notes) {
    if (std::is_permutation(one.lesson.notes.begin(), one.lesson.notes.end(), other.lesson.notes.begin()))
      return "the order of notes";
    for (std::size_t i = 0; i < one.lesson.notes.size(); ++i)
      if (one.lesson.notes[i] != other.lesson.notes[i])
        return fmt::format("note {}, {}", i + 1, note_change_in_words(one.lesson.notes[i], other.lesson.notes[i]));
  }
  if (one.lesson.feedback_at_end != other.lesson.feedback_at_end) return "when answers are told";
  if (one.draft && other.draft && one.draft_of == other.draft_of) return note_change_in_words(*one.draft, *other.draft);
  return "a note being written";
}

void LessonHistory::watch(const NotesState& notes, Words words) {
  if (words == Words::begun && now_) return;
  if (now_ && now_->lesson == notes.lesson && now_->draft == notes.draft && now_->draft_of == notes.draft_of) return;
  LessonEdit edit = edit_of(notes);
  if (!now_ || same_words(*now_, edit)) {
    now_ = std::move(edit);
    return;
  }
  const bool kept = now_->draft && !edit.draft && now_->lesson != edit.lesson;
  if (kept) {
    while (!past_.empty() && past_.back().draft && past_.back().lesson == now_->lesson) past_.pop_back();
    past_.push_back({now_->lesson});
  } else {
    past_.push_back(std::move(*now_));
  }
  future_.clear();
  now_ = std::move(edit);
  const std::size_t most = std::clamp<std::size_t>(most_steps_bytes / (bytes_of(*now_) + 1), 2, most_steps);
  while (past_.size() > most) past_.pop_front();
}

std::optional<std::string> LessonHistory::step(NotesState& notes, std::deque<LessonEdit>& from,
                                               std::deque<LessonEdit>& to) {
  if (from.empty() || !now_) return {};
  LessonEdit wanted = std::move(from.back());
  from.pop_back();
  const std::string words = change_in_words(*now_, wanted);
  stop_placing(notes);
  notes.lesson = wanted.lesson;
  notes.draft = wanted.draft;
  notes.draft_of = wanted.draft_of;
  notes.unsaved = !notes.lesson.notes.empty() && notes.lesson != notes.saved;
  to.push_back(std::move(*now_));
  now_ = std::move(wanted);
  return words;
}

}  // namespace odontoscope
