#include "engine/viewer/notes/note_editor.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

using widgets::scaled;

/// A field of one line, no longer than `most` bytes.
bool line_field(const char* id, std::string& text, std::size_t most, float width = -1, const char* hint = "") {
  ImGui::SetNextItemWidth(width);
  widgets::text_field(id);
  const bool entered =
      ImGui::InputTextWithHint(id, widgets::say(hint).c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
  widgets::noted(id);
  if (text.size() > most) text.resize(most);
  return entered;
}

void number_line(const char* id, double& number, const char* words) {
  ImGui::AlignTextToFramePadding();
  widgets::text(words);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(70));
  widgets::text_field(id);
  ImGui::InputDouble(id, &number, 0, 0, "%.6g");
  widgets::noted(id);
}

void pins(NotesState& notes) {
  LessonNote& draft = *notes.draft;
  for (std::size_t i = 0; i < draft.marks.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    line_field("##label", draft.marks[i].label, most_title_bytes, ImGui::GetContentRegionAvail().x - scaled(76),
               "no label: a bare pin");
    ImGui::SameLine();
    const bool gone = widgets::button("Remove");
    ImGui::PopID();
    if (gone) {
      draft.marks.erase(draft.marks.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
}

void arrows(NotesState& notes) {
  LessonNote& draft = *notes.draft;
  for (std::size_t i = 0; i < draft.arrows.size(); ++i) {
    ImGui::PushID(static_cast<int>(i) + 1000);
    line_field("##arrow", draft.arrows[i].label, most_title_bytes, ImGui::GetContentRegionAvail().x - scaled(150),
               "no label: a bare arrow");
    ImGui::SameLine();
    if (widgets::button("Redraw")) {
      notes.redrawn = i;
      notes.placing = NotesState::Placing::arrow_tail;
    }
    ImGui::SameLine();
    const bool gone = widgets::button("Remove");
    ImGui::PopID();
    if (gone) {
      draft.arrows.erase(draft.arrows.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
}

void place_buttons(NotesState& notes) {
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  ImGui::BeginDisabled(notes.draft->marks.size() >= most_marks);
  if (widgets::button("Place a pin", {width, 0})) notes.placing = NotesState::Placing::pin;
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(notes.draft->arrows.size() >= most_arrows);
  if (widgets::button("Draw an arrow", {width, 0})) notes.placing = NotesState::Placing::arrow_tail;
  ImGui::EndDisabled();
}

const char* placing_in_words(NotesState::Placing placing) {
  switch (placing) {
    case NotesState::Placing::pin:
      return "Click where the pin goes.";
    case NotesState::Placing::arrow_tail:
      return "Click where the arrow begins: beside the place that it points at.";
    case NotesState::Placing::arrow_head:
      return "Click what the arrow points at.";
    default:
      return "Click what is right.";
  }
}

void click_fields(NotesState& notes, LessonQuestion& question) {
  const std::string said = question.structure.empty() ? "nothing yet"
                           : question.part.empty()    ? question.structure
                                                      : question.structure + ", " + question.part;
  widgets::wrapped("Right is: " + said);
  if (widgets::wide_button("Show what is right")) notes.placing = NotesState::Placing::answer;
}

void choice_fields(LessonQuestion& question) {
  question.choices.resize(std::max(question.choices.size(), least_choices));
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool right = question.answer == static_cast<double>(i);
    if (widgets::button(right ? "Right" : "Wrong", {scaled(62), 0})) question.answer = static_cast<double>(i);
    ImGui::SameLine();
    line_field("##choice", question.choices[i], most_title_bytes, -1, "a choice");
    ImGui::PopID();
  }
  if (question.choices.size() < most_choices && widgets::wide_button("One choice more"))
    question.choices.emplace_back();
}

void question_fields(NotesState& notes) {
  LessonNote& draft = *notes.draft;
  int kind = draft.question ? static_cast<int>(draft.question->kind) + 1 : 0;
  if (widgets::choice("question", kind, {"No question", "Click", "Choice", "Number"})) {
    if (kind == 0) {
      draft.question.reset();
    } else {
      LessonQuestion fresh{.kind = static_cast<LessonQuestion::Kind>(kind - 1),
                           .ask = draft.question ? draft.question->ask : "",
                           .explain = draft.question ? draft.question->explain : ""};
      draft.question = std::move(fresh);
    }
  }
  if (!draft.question) return;
  LessonQuestion& question = *draft.question;
  line_field("##ask", question.ask, most_text_bytes, -1, "what is asked");
  if (question.kind == LessonQuestion::Kind::click) click_fields(notes, question);
  if (question.kind == LessonQuestion::Kind::choice) choice_fields(question);
  if (question.kind == LessonQuestion::Kind::number) {
    number_line("##answer", question.answer, "Right is");
    ImGui::SameLine();
    number_line("##within", question.within, "within");
    ImGui::SameLine();
    line_field("##unit", question.unit, most_unit_bytes, -1, "unit");
  }
  line_field("##explain", question.explain, most_text_bytes, -1, "what is told after the answer");
}

/// In a canal, or where the note rides already: down it to where the view is.
void ride_toggle(LessonNote& draft, const std::string& canal) {
  const std::string name = canal.empty() ? draft.tour : canal;
  if (name.empty() || !draft.inside) return;
  bool rides = draft.tour == name;
  if (widgets::toggle(fmt::format("Ride down the {}", name).c_str(), rides)) draft.tour = rides ? name : "";
}

void placing_part(NotesState& notes, const Interface& interface) {
  ImGui::PushFont(interface.bold);
  widgets::wrapped(placing_in_words(notes.placing));
  ImGui::PopFont();
  widgets::remark(interface, "The tooth can be turned meanwhile. Enter takes the place at the cross.");
  if (widgets::button("Cancel (Esc)")) stop_placing(notes);
}

}  // namespace

std::string fault_of_draft(const LessonNote& draft) { return draft.question ? fault_of(*draft.question) : ""; }

void note_editor(NotesState& notes, const std::string& canal, const Interface& interface) {
  if (notes.placing != NotesState::Placing::none) {
    placing_part(notes, interface);
    return;
  }
  LessonNote& draft = *notes.draft;
  ImGui::PushFont(interface.large);
  widgets::text(notes.draft_of ? fmt::format("Note {}", *notes.draft_of + 1) : "A note on this view");
  ImGui::PopFont();
  ImGui::Columns(2, "columns", false);
  widgets::text("Title");
  if (ImGui::IsWindowAppearing() && notes.fresh_draft) ImGui::SetKeyboardFocusHere();
  if (ImGui::IsWindowAppearing()) notes.fresh_draft = false;
  const bool entered = line_field("##title", draft.title, most_title_bytes);
  widgets::text("What is there to see?");
  widgets::text_field("##text");
  ImGui::InputTextMultiline("##text", &draft.text, {-1, scaled(74)});
  widgets::noted("##text");
  if (draft.text.size() > most_text_bytes) draft.text.resize(most_text_bytes);
  widgets::text("Narration, to be read or spoken (may be left out)");
  widgets::text_field("##narration");
  ImGui::InputTextMultiline("##narration", &draft.narration, {-1, scaled(52)});
  widgets::noted("##narration");
  if (draft.narration.size() > most_text_bytes) draft.narration.resize(most_text_bytes);
  ride_toggle(*notes.draft, canal);
  if (notes.draft_of && widgets::wide_button("Take the view as it is now")) notes.retake = true;
  const std::string fault = fault_of_draft(draft);
  if (!fault.empty()) widgets::remark(interface, fault);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  ImGui::BeginDisabled(!fault.empty());
  const bool keep = widgets::button("Keep the note", {width, 0});
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool cancel = widgets::button("Cancel (Esc)", {width, 0});
  ImGui::NextColumn();
  widgets::text("Pins and arrows");
  pins(notes);
  arrows(notes);
  place_buttons(notes);
  widgets::text("Question");
  question_fields(notes);
  ImGui::Columns(1);
  if ((keep || entered) && fault.empty())
    keep_draft(notes);
  else if (cancel)
    drop_draft(notes);
}

}  // namespace odontoscope
