#include "engine/viewer/notes/notes_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

/// What can be done with the note that is shown.
void note_buttons(NotesState& notes, std::size_t number) {
  const float width = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x) / 4;
  if (widgets::button("Edit", {width, 0})) edit_note(notes, number);
  ImGui::SameLine();
  ImGui::BeginDisabled(number == 0);
  if (widgets::button("Up", {width, 0})) move_note(notes, number, -1);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(number + 1 >= notes.lesson.notes.size());
  if (widgets::button("Down", {width, 0})) move_note(notes, number, 1);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (widgets::button("Delete", {width, 0})) remove_note(notes, number);
}

void undo_buttons(NotesState& notes, const LessonHistory& history) {
  if (!history.can_undo() && !history.can_redo()) return;
  const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  ImGui::BeginDisabled(!history.can_undo());
  if (widgets::button("Undo", {width, 0})) notes.undo = true;
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!history.can_redo());
  if (widgets::button("Redo", {width, 0})) notes.redo = true;
  ImGui::EndDisabled();
}

}  // namespace

void notes_section(NotesState& notes, const LessonHistory& history, bool from_outside, const Interface& interface) {
  if (!widgets::section(interface, "Notes", widgets::open_if(!notes.lesson.notes.empty()))) return;
  if (!notes.lesson.notes.empty() && !notes.shown &&
      widgets::wide_button("Play as a lesson", widgets::Emphasis::strong))
    notes.go_to = 0;
  const std::optional<std::size_t> shown = notes.shown;  // what is pressed here counts in the next frame
  const std::size_t count = notes.lesson.notes.size();
  for (std::size_t i = 0; i < count && i < notes.lesson.notes.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const LessonNote& note = notes.lesson.notes[i];
    const std::string words =
        fmt::format("{}   {}{}", i + 1, note.title.empty() ? "(no title)" : note.title, note.question ? "   ?" : "");
    if (widgets::wide_button(words.c_str(), widgets::strong_if(shown == i))) notes.go_to = i;
    if (shown == i && !notes.draft) note_buttons(notes, i);
    ImGui::PopID();
  }
  undo_buttons(notes, history);
  if (widgets::wide_button(from_outside ? "Note this view" : "Note this view (N)")) notes.write = true;
  if (notes.lesson.notes.empty()) {
    widgets::remark(interface,
                    "Make a lesson: views with a title and a text, pins and questions, for others to be led along. "
                    "Click a note in the list to change it.");
    return;
  }
  widgets::text("Title of the lesson");
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##lesson");
  if (ImGui::InputText("##lesson", &notes.lesson.title)) notes.unsaved = true;
  widgets::noted("##lesson");
  if (notes.lesson.title.size() > most_title_bytes) notes.lesson.title.resize(most_title_bytes);
  if (notes.lesson.is_quiz() && widgets::toggle("Right or wrong at the end", notes.lesson.feedback_at_end))
    notes.unsaved = true;
  if (widgets::wide_button(notes.unsaved ? "Save the notes" : "Save the notes again")) notes.save = true;
}

}  // namespace odontoscope
