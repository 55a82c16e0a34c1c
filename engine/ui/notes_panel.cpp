#include "engine/ui/notes_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "engine/ui/cards.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void draft_card(NotesState& notes, const Interface& interface, const Area& viewport, float scale) {
  if (begin_card("note draft", viewport, scale, 620, 60)) {
    TourNote& draft = *notes.draft;
    ImGui::PushFont(interface.large);
    ImGui::TextUnformatted("A note on this view");
    ImGui::PopFont();
    ImGui::TextUnformatted("Title");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    widgets::text_field("##title");
    const bool entered = ImGui::InputText("##title", &draft.title, ImGuiInputTextFlags_EnterReturnsTrue);
    widgets::noted("##title");
    ImGui::TextUnformatted("What is there to see?");
    widgets::text_field("##text");
    ImGui::InputTextMultiline("##text", &draft.text, {-1, scaled(90)});
    widgets::noted("##text");
    if (draft.title.size() > most_title_bytes) draft.title.resize(most_title_bytes);
    if (draft.text.size() > most_text_bytes) draft.text.resize(most_text_bytes);
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (widgets::button("Keep the note", {width, 0}) || entered) {
      keep_draft(notes);
    }
    ImGui::SameLine();
    if (widgets::button("Cancel (Esc)", {width, 0})) notes.draft.reset();
  }
  ImGui::End();
}

void note_card(ViewerState& state, const Interface& interface, const Area& viewport, float scale) {
  const NotesState& notes = state.notes;
  const TourNote& note = notes.tour.notes[*notes.shown];
  if (begin_card("note", viewport, scale, 620, 24)) {
    ImGui::PushFont(interface.large);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(fmt::format("{} / {}   {}", *notes.shown + 1, notes.tour.notes.size(), note.title).c_str());
    ImGui::PopFont();
    ImGui::TextUnformatted(note.text.c_str());
    ImGui::PopTextWrapPos();
    const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (widgets::button("Back (Page up)", {width, 0})) state.todo.push_back(Action::previous_step);
    ImGui::SameLine();
    if (widgets::button("Next (Page down)", {width, 0})) state.todo.push_back(Action::next_step);
    ImGui::SameLine();
    if (widgets::button("Close (Esc)", {width, 0})) state.todo.push_back(Action::escape);
  }
  ImGui::End();
}

}  // namespace

void notes_section(ViewerState& state, const Interface& interface) {
  NotesState& notes = state.notes;
  if (!widgets::section(interface, "Notes", !notes.tour.notes.empty())) return;
  if (!notes.tour.notes.empty() && !notes.shown && widgets::wide_button("Play as a lesson", true)) notes.go_to = 0;
  for (std::size_t i = 0; i < notes.tour.notes.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (widgets::wide_button(notes.tour.notes[i].title.empty() ? "(no title)" : notes.tour.notes[i].title.c_str(), notes.shown == i)) notes.go_to = i;
    ImGui::PopID();
  }
  if (widgets::wide_button(state.fly.on ? "Note this view (N)" : "Note this view")) notes.write = true;
  if (notes.tour.notes.empty()) {
    widgets::remark(interface, "Views with a title and a text, for others to be led along: camera, looks, section and all. Open them again by dropping the file on the window.");
    return;
  }
  ImGui::TextUnformatted("Title of the lesson");
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##lesson");
  if (ImGui::InputText("##lesson", &notes.tour.title)) notes.unsaved = true;
  widgets::noted("##lesson");
  if (notes.tour.title.size() > most_title_bytes) notes.tour.title.resize(most_title_bytes);
  if (widgets::wide_button(notes.unsaved ? "Save the notes" : "Save the notes again")) notes.save = true;
}

void draw_note_card(ViewerState& state, const Interface& interface, const Area& viewport, float scale) {
  Area room = viewport;
  constexpr double small_pictures = 230, least_width = 360;   // interface pixels
  if (state.fly.on && state.fly.show_where) room.width = std::max(room.width - small_pictures * scale, std::min(room.width, least_width * scale));
  if (state.notes.draft) draft_card(state.notes, interface, room, scale);
  else if (state.notes.shown && *state.notes.shown < state.notes.tour.notes.size()) note_card(state, interface, room, scale);
}

}  // namespace odontoscope
