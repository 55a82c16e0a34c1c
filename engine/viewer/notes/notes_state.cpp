#include "engine/viewer/notes/notes_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"

namespace odontoscope {

std::optional<LessonArrow> arrow_from(const ArrowTail& tail, const glm::dvec3& to) {
  const double depth = depth_of(tail.camera, to);
  const bool before = depth > 0 || tail.camera.projection == Camera::Projection::parallel;
  if (!before && !tail.surface) return {};
  glm::dvec3 from = before ? point_at_depth_of(tail.camera, tail.place, to) : *tail.surface;
  if (tail.surface && depth_of(tail.camera, *tail.surface) < depth) from = *tail.surface;
  if (glm::distance(from, to) < least_arrow_mm) return {};
  return LessonArrow{from, to};
}

const LessonNote* NotesState::seen() const {
  if (draft) return &*draft;
  return shown && *shown < lesson.notes.size() ? &lesson.notes[*shown] : nullptr;
}

bool NotesState::at_risk() const {
  if (unsaved || !draft) return unsaved;
  if (draft_of) return *draft_of >= lesson.notes.size() || !(*draft == lesson.notes[*draft_of]);
  return !draft->title.empty() || !draft->text.empty() || !draft->narration.empty() || !draft->marks.empty() ||
         !draft->arrows.empty() || draft->question;
}

void keep_draft(NotesState& notes) {
  LessonNote note = std::move(*std::exchange(notes.draft, std::nullopt));
  const std::optional<std::size_t> place = std::exchange(notes.draft_of, std::nullopt);
  stop_placing(notes);
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
  stop_placing(notes);
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
  notes.lesson.notes.erase(notes.lesson.notes.begin() + static_cast<std::ptrdiff_t>(number));
  notes.shown.reset();
  notes.unsaved = !notes.lesson.notes.empty();
}

bool end_arrow(NotesState& notes, const glm::dvec3& to) {
  std::optional<LessonArrow> arrow = arrow_from(*notes.tail, to);
  if (!arrow) return false;
  auto& arrows = notes.draft->arrows;
  if (notes.redrawn && *notes.redrawn < arrows.size()) {
    arrow->label = arrows[*notes.redrawn].label;
    arrows[*notes.redrawn] = std::move(*arrow);
  } else if (arrows.size() < most_arrows) {
    arrows.push_back(std::move(*arrow));
  }
  stop_placing(notes);
  return true;
}

void stop_placing(NotesState& notes) {
  notes.placing = NotesState::Placing::none;
  notes.tail.reset();
  notes.redrawn.reset();
}

}  // namespace odontoscope
