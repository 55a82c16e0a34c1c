#include "engine/viewer/notes/lesson_dialogs.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "engine/ui/dialog.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/notes/note_editor.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void large(const Interface& interface, const std::string& words) {
  ImGui::PushFont(interface.large);
  widgets::as_written(words);
  ImGui::PopFont();
}

float button_width(int count) {
  return (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
         static_cast<float>(count);
}

/// A button in a colour of its own.
bool coloured_button(const char* words, float width, ImU32 colour) {
  for (const ImGuiCol part : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
    ImGui::PushStyleColor(part, colour);
  const bool pressed = widgets::button(words, {width, 0});
  ImGui::PopStyleColor(3);
  return pressed;
}

void choices(const NotesState& notes, LessonPlayer& lesson, const LessonQuestion& question, const QuizRow& row) {
  const int columns = ImGui::GetContentRegionAvail().x > scaled(480) ? 2 : 1;
  const float width = button_width(columns);
  const bool told = row.answered && !lesson.quiz()->at_end;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    if (columns == 2 && i % 2 == 1) ImGui::SameLine();
    const std::string words = fmt::format("{}   {}", i + 1, question.choices[i]);
    const bool right = is_right(question, i), given = row.answered && row.given == question.choices[i];
    const ImU32 colour = told && right   ? theme::good_back
                         : told && given ? theme::bad_back
                         : given         ? theme::accent_dark
                                         : theme::raised;
    if (coloured_button(words.c_str(), width, colour) && !row.answered) lesson.answer(notes, i);
  }
}

/// Letters go here without a click, see LessonPlayer::handle: drawn, not ImGui's.
void number_field(const NotesState& notes, LessonPlayer& lesson, const Interface& interface,
                  const LessonQuestion& question, const QuizRow& row) {
  if (row.answered) return;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), width = scaled(150);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, scaled(6));
  list.AddRect(corner, {corner.x + width, corner.y + height}, theme::accent, scaled(6));
  const std::string& typed = lesson.typed();
  const ImVec2 at(corner.x + scaled(10), corner.y + 0.5f * (height - ImGui::GetFontSize()));
  list.AddText(at, typed.empty() ? theme::quiet : theme::text,
               typed.empty() ? interface.say("type a number").c_str() : typed.c_str());
  const float end = at.x + (typed.empty() ? -scaled(3) : ImGui::CalcTextSize(typed.c_str()).x + scaled(2));
  list.AddLine({end, at.y}, {end, at.y + ImGui::GetFontSize()}, theme::text, scaled(1.4f));
  ImGui::Dummy({width, height});
  if (!question.unit.empty()) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(question.unit.c_str());
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!number_from(typed));
  if (widgets::button("Answer (Enter)")) lesson.answer_typed(notes);
  ImGui::EndDisabled();
  if (!typed.empty() && !number_from(typed)) widgets::remark(interface, "That is no number yet.");
}

void question_part(const NotesState& notes, LessonPlayer& lesson, const Interface& interface,
                   const LessonQuestion& question, const QuizRow& row) {
  ImGui::PushFont(interface.bold);
  widgets::as_written(question.ask);
  ImGui::PopFont();
  if (question.kind == LessonQuestion::Kind::choice) choices(notes, lesson, question, row);
  if (question.kind == LessonQuestion::Kind::number) number_field(notes, lesson, interface, question, row);
  if (question.kind == LessonQuestion::Kind::click && !row.answered)
    widgets::remark(
        interface,
        "Drag or the arrow keys turn the tooth. Click the place; or bring it under the cross and press Enter.");
  if (!row.answered) return;
  const std::string words = lesson.feedback(notes);
  if (lesson.quiz()->at_end) {
    widgets::remark(interface, words);
    return;
  }
  widgets::marked(interface, row.right ? Certificate::Mark::good : Certificate::Mark::bad, words);
  if (!question.explain.empty()) widgets::as_written(question.explain);
}

void note_part(const NotesState& notes, ViewerState& state, LessonPlayer& lesson, const Interface& interface) {
  const LessonNote& note = notes.lesson.notes[*notes.shown];
  const bool last = *notes.shown + 1 == notes.lesson.notes.size();
  large(interface, fmt::format("{} / {}   {}", *notes.shown + 1, notes.lesson.notes.size(), note.title));
  if (!note.text.empty()) widgets::as_written(note.text);
  if (!note.narration.empty()) {
    widgets::toggle("Narration", lesson.narration_open);
    if (lesson.narration_open) widgets::as_written(note.narration);
  }
  const QuizRow* row = lesson.row(notes);
  if (row && note.question) question_part(notes, lesson, interface, *note.question, *row);
  ImGui::Dummy({0, scaled(1)});
  const float width = button_width(3);
  if (widgets::button("Back (Page up)", {width, 0})) state.pending_actions.push_back(Action::previous_step);
  ImGui::SameLine();
  const bool result_next = last && lesson.quiz();
  ImGui::BeginDisabled(last && !lesson.quiz());
  const bool lead_on = row && row->answered;
  if (coloured_button(result_next ? "Result (Page down)" : "Next (Page down)", width,
                      lead_on ? theme::accent_dark : theme::raised))
    state.pending_actions.push_back(Action::next_step);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (widgets::button("Close (Esc)", {width, 0})) state.pending_actions.push_back(Action::escape);
}

/// A line for each question: right or wrong, what was given, and what is right.
void result_rows(const NotesState& notes, const Quiz& quiz, const Interface& interface) {
  for (std::size_t i = 0; i < quiz.rows.size(); ++i) {
    const QuizRow& row = quiz.rows[i];
    const LessonQuestion& question = *notes.lesson.notes[row.note].question;
    std::string words = fmt::format("{}   {}   ", i + 1, row.question);
    if (row.right)
      words += row.given;
    else if (row.answered)
      words += fmt::format("You said {}; it is {}.", row.given, right_answer(question));
    else
      words += fmt::format("Not answered; it is {}.", right_answer(question));
    widgets::marked(interface, row.right ? Certificate::Mark::good : Certificate::Mark::bad, words);
    if (quiz.at_end && !question.explain.empty()) {
      ImGui::Indent(scaled(20));
      widgets::remark(interface, question.explain);
      ImGui::Unindent(scaled(20));
    }
  }
}

void result_part(NotesState& notes, ViewerState& state, LessonPlayer& lesson, const Interface& interface) {
  const Quiz& quiz = *lesson.quiz();
  large(interface, interface.say(fmt::format("{} of {} right", quiz.score(), quiz.rows.size())));
  constexpr std::size_t most_rows = 8;
  const float height =
      scaled(22) * static_cast<float>(std::min((quiz.at_end ? 2 : 1) * quiz.rows.size(), most_rows)) + scaled(8);
  ImGui::BeginChild("rows", {0, height});
  result_rows(notes, quiz, interface);
  ImGui::EndChild();
  const float width = button_width(4);
  if (widgets::button("Back (Page up)", {width, 0})) state.pending_actions.push_back(Action::previous_step);
  ImGui::SameLine();
  if (coloured_button("Save the marks (Enter)", width, theme::accent_dark)) lesson.save_marks = true;
  ImGui::SameLine();
  if (widgets::button("Once more", {width, 0})) lesson.again(notes);
  ImGui::SameLine();
  if (widgets::button("Close (Esc)", {width, 0})) state.pending_actions.push_back(Action::escape);
}

/// A strip along the lower edge, its words no wider than can be read.
class Dock {
 public:
  Dock(const char* id, const Area& whole, float scale, double& height) : height_(height) {
    constexpr float most_line = 860, most_share = 0.62f;
    const float wide = static_cast<float>(whole.width), inset = std::max(18 * scale, 0.5f * (wide - most_line * scale));
    ImGui::SetNextWindowPos({static_cast<float>(whole.left), static_cast<float>(whole.top + whole.height)},
                            ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, most_share * static_cast<float>(whole.height)});
    ImGui::SetNextWindowSize({wide, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {inset, 12 * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    const ImVec2 corner = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddLine(corner, {corner.x + wide, corner.y}, theme::line, scale);
  }
  ~Dock() {
    height_ = static_cast<double>(ImGui::GetWindowSize().y);
    ImGui::End();
  }
  Dock(const Dock&) = delete;
  Dock& operator=(const Dock&) = delete;

 private:
  double& height_;
};

}  // namespace

void draw_lesson_dock(NotesState& notes, ViewerState& state, LessonPlayer& lesson, const std::string& canal,
                      const Interface& interface, const Area& whole, float scale) {
  const bool note = notes.shown && *notes.shown < notes.lesson.notes.size();
  if (notes.draft) {
    const Dock dock(notes.placing == NotesState::Placing::none ? "note draft" : "placing", whole, scale,
                    lesson.dock_height);
    note_editor(notes, canal, interface);
  } else if (note && lesson.result() && lesson.quiz()) {
    const Dock dock("quiz result", whole, scale, lesson.dock_height);
    result_part(notes, state, lesson, interface);
  } else if (note) {
    const Dock dock("note", whole, scale, lesson.dock_height);
    note_part(notes, state, lesson, interface);
  } else {
    lesson.dock_height = 0;
  }
}

void draw_lesson_menu(ViewerState& state, LessonPlayer& lesson, const Interface& interface, const Area& viewport) {
  if (!lesson.menu()) return;
  const Dialog dialog("lessons", viewport, 440);
  large(interface, interface.say("Lessons"));
  std::size_t number = 0;
  const auto entry = [&](const std::string& words, const std::string& remark) {
    ImGui::PushID(static_cast<int>(number));
    if (widgets::wide_button(fmt::format("{}   {}", number + 1, words).c_str(),
                             widgets::strong_if(number == lesson.menu_at())))
      lesson.choose(number, state);
    ImGui::PopID();
    if (!remark.empty()) widgets::remark(interface, remark);
    ++number;
  };
  for (const BuiltInLesson& built_in : lesson.lessons())
    entry(built_in.title, built_in.questions > 0 ? fmt::format("A quiz of {} questions", built_in.questions)
                                                 : fmt::format("{} steps", built_in.notes));
  entry("Why culling shows errors", "The sample molar made in two ways, for those who make models");
  entry("Open a lesson's file\xE2\x80\xA6", "NAME.tour.json, from a teacher; dropping it on the window does the same");
  if (widgets::wide_button("Close (Esc)")) lesson.close_menu();
}

}  // namespace odontoscope
