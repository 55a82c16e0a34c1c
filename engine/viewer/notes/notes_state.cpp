#include "engine/viewer/notes/notes_state.h"

#include <fmt/format.h>

#include <algorithm>

namespace odontoscope {

const std::vector<LessonPin>* NotesState::pins() const {
  if (draft) return &draft->marks;
  return shown && *shown < lesson.notes.size() ? &lesson.notes[*shown].marks : nullptr;
}

bool NotesState::at_risk() const {
  if (unsaved || !draft) return unsaved;
  if (draft_of) return *draft_of >= lesson.notes.size() || !(*draft == lesson.notes[*draft_of]);
  return !draft->title.empty() || !draft->text.empty() || !draft->marks.empty() || draft->question;
}

void keep_draft(NotesState& notes) {
  LessonNote note = std::move(*std::exchange(notes.draft, std::nullopt));
  const std::optional<std::size_t> place = std::exchange(notes.draft_of, std::nullopt);
  notes.placing = NotesState::Placing::none;
  if (note.title.empty()) note.title = fmt::format("Note {}", place.value_or(notes.lesson.notes.size()) + 1);
  if (place && *place < notes.lesson.notes.size())
    notes.lesson.notes[*place] = std::move(note);
  else
    notes.lesson.notes.push_back(std::move(note));
  notes.unsaved = true;
}

void drop_draft(NotesState& notes) {
  notes.draft.reset();
  notes.draft_of.reset();
  notes.placing = NotesState::Placing::none;
}

void edit_note(NotesState& notes, std::size_t number) {
  notes.draft = notes.lesson.notes[number];
  notes.draft_of = number;
  notes.fresh_draft = true;
}

void move_note(NotesState& notes, std::size_t number, int by) {
  const std::size_t to = number + static_cast<std::size_t>(by);  // below 0 is beyond the last
  if (number >= notes.lesson.notes.size() || to >= notes.lesson.notes.size()) return;
  std::swap(notes.lesson.notes[number], notes.lesson.notes[to]);
  if (notes.shown == number) notes.shown = to;
  notes.unsaved = true;
}

void remove_note(NotesState& notes, std::size_t number) {
  if (number >= notes.lesson.notes.size()) return;
  notes.removed.emplace_back(number, std::move(notes.lesson.notes[number]));
  notes.lesson.notes.erase(notes.lesson.notes.begin() + static_cast<std::ptrdiff_t>(number));
  notes.shown.reset();
  notes.unsaved = !notes.lesson.notes.empty();
}

void bring_back_note(NotesState& notes) {
  auto [number, note] = std::move(notes.removed.back());
  notes.removed.pop_back();
  number = std::min(number, notes.lesson.notes.size());
  notes.lesson.notes.insert(notes.lesson.notes.begin() + static_cast<std::ptrdiff_t>(number), std::move(note));
  notes.shown.reset();
  notes.unsaved = true;
}

}  // namespace odontoscope
