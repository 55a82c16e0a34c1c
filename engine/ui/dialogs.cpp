#include "engine/ui/dialogs.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "engine/ui/actions.h"
#include "engine/ui/theme.h"
#include "engine/ui/volume_dialog.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void title(const Interface& interface, const char* words) {
  ImGui::PushFont(interface.large);
  widgets::wrapped(words);
  ImGui::PopFont();
}

std::string name_of(const std::string& file) {
  return file.empty() ? "the sample molar" : std::filesystem::path(file).filename().string();
}
std::string name_of(const LoadRequest& request) { return request.lesson ? "the lesson" : name_of(request.file); }

void loading_dialog(ViewerState& state, const LoadJob& loading, const Interface& interface, const Area& viewport) {
  // Below a draft, which is to be seen.
  const double strip = std::min<double>(scaled(190), viewport.height);
  const Dialog dialog(
      "loading",
      state.draft ? Area{viewport.left, viewport.top + viewport.height - strip, viewport.width, strip} : viewport, 400);
  title(interface, fmt::format("Making {}", name_of(loading.request().file)).c_str());
  const LoadJob::Stage stage = loading.stage();
  widgets::remark(interface, loading.cancelling() ? "Stopping\xE2\x80\xA6" : stage_in_words(stage.name));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, height / 2);
  const float done = static_cast<float>(std::clamp(stage.fraction, 0.02, 1.0));
  list.AddRectFilled(corner, {corner.x + done * width, corner.y + height}, theme::accent, height / 2);
  ImGui::Dummy({width, height + scaled(6)});
  if (widgets::wide_button("Cancel")) state.cancel_loading = true;
}

void trouble_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const Dialog dialog("trouble", viewport, 520);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::bad);
  title(interface, "That did not work");
  ImGui::PopStyleColor();
  widgets::wrapped(state.trouble);
  ImGui::Dummy({0, scaled(2)});
  if (widgets::wide_button("Close")) state.trouble.clear();
}

void question_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const float with_picture = 760, with_series = 560, alone = 460;
  const Dialog dialog("question", viewport,
                      state.question->preview          ? with_picture
                      : state.question->series.empty() ? alone
                                                       : with_series);
  title(interface, name_of(state.question->request.file).c_str());
  VolumeAnswer answer = volume_dialog(*state.question, interface);
  if (answer.open) state.to_load = std::move(answer.open);
  if (answer.put_away) state.question.reset();
}

/// Recent files, and the folder to go through; the file that was pressed, or nothing.
std::string listed_file(ViewerState& state, const Interface& interface) {
  std::string chosen;
  const auto row = [&](const std::string& words, const std::string& file) {
    if (widgets::wide_button(words.c_str())) chosen = file;
  };
  if (!state.settings.recent.empty()) widgets::remark(interface, "Opened before");
  constexpr std::size_t most_shown = 4;
  for (std::size_t i = 0; i < std::min(state.settings.recent.size(), most_shown); ++i) {
    const std::filesystem::path file(state.settings.recent[i]);
    ImGui::PushID(static_cast<int>(i));
    row(fmt::format("{}   in {}", file.filename().string(), file.parent_path().filename().string()), file.string());
    ImGui::PopID();
  }
  widgets::remark(interface, state.folder.folder.string());
  if (!state.folder.trouble.empty()) widgets::remark(interface, state.folder.trouble);
  ImGui::BeginChild("folder", {0, scaled(190)});
  std::filesystem::path enter;
  if (state.folder.folder.has_parent_path() && state.folder.folder != state.folder.folder.root_path() &&
      widgets::wide_button(".."))
    enter = state.folder.folder.parent_path();
  for (const FolderEntry& entry : state.folder.entries) {
    ImGui::PushID(entry.name.c_str());
    if (entry.folder) {
      if (widgets::wide_button((entry.name + "/").c_str())) enter = state.folder.folder / entry.name;
    } else {
      row(entry.name, (state.folder.folder / entry.name).string());
    }
    ImGui::PopID();
  }
  if (state.folder.left_out > 0)
    widgets::remark(interface, fmt::format("{} more are not listed: type the name.", state.folder.left_out));
  ImGui::EndChild();
  if (!enter.empty()) state.folder = list_folder(enter);
  return chosen;
}

void open_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const Dialog dialog("open", viewport, 560);
  title(interface, "Open a file");
  widgets::remark(interface,
                  "A contour stack, a GLB, STL or PLY mesh, a volume, or a lesson. Dropping it on the window does the "
                  "same. Nothing typed: the sample molar.");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##file");
  bool open = ImGui::InputText("##file", &*state.file_asked_for, ImGuiInputTextFlags_EnterReturnsTrue);
  widgets::noted("##file");
  if (const std::string chosen = listed_file(state, interface); !chosen.empty()) {
    state.file_asked_for = chosen;
    open = true;
  }
  open = widgets::wide_button("Open", true) || open;
  if (open) {
    state.to_load = LoadRequest{.file = *state.file_asked_for, .volume = {}};
    state.file_asked_for.reset();
    return;
  }
  if (widgets::wide_button("Cancel")) state.file_asked_for.reset();
}

void leaving_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  using Answer = LeavingNotes::Answer;
  const Dialog dialog("leaving", viewport, 460);
  LeavingNotes& leaving = *state.notes.leaving;
  title(interface, "Your notes are not saved");
  widgets::wrapped(leaving.to_open
                       ? fmt::format("They are about {} and go when {} is opened.",
                                     state.shown ? state.shown->title : "this model", name_of(*leaving.to_open))
                       : "They go when the window is closed.");
  if (widgets::wide_button(leaving.to_open ? "Save them, then open" : "Save them, then close", true))
    leaving.answer = Answer::save;
  if (widgets::wide_button(leaving.to_open ? "Open without saving" : "Close without saving"))
    leaving.answer = Answer::drop;
  if (widgets::wide_button("Stay (Esc)")) leaving.answer = Answer::stay;
}

void key_row(const Interface& interface, std::string_view printed, std::string_view words, float column) {
  ImGui::PushFont(interface.bold);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::accent);
  const float start = ImGui::GetCursorPosX() - ImGui::GetColumnOffset();  // `column` is counted from the window's edge
  widgets::expect_room(widgets::say(std::string(printed)), column - start);
  widgets::text(std::string(printed));
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::SameLine(column);
  widgets::expect_room(widgets::say(std::string(words)), ImGui::GetContentRegionAvail().x);
  widgets::text(std::string(words));
}

void gamepad_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const Dialog dialog("help", viewport, 480);
  title(interface, "Gamepad");
  for (const Gesture& gesture : gamepad_gestures()) key_row(interface, gesture.printed, gesture.words, scaled(170));
  widgets::remark(interface,
                  "By the letters of an Xbox pad: A lies below, B at the right, X at the left, Y above. ? on the "
                  "keyboard lists the keys.");
  if (widgets::wide_button("Close (Start or B)")) state.help = false;
}

void help_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const Dialog dialog("help", viewport, 840);
  title(interface, "Mouse and keys");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(8), scaled(5)});
  ImGui::Columns(2, "columns", false);
  ImGui::SetColumnWidth(0, scaled(420));
  for (const Gesture& gesture : state.fly.on ? flight_gestures() : gestures())
    key_row(interface, gesture.printed, gesture.words, scaled(180));
  ImGui::Dummy({0, scaled(6)});
  std::set<Action> told;
  std::size_t row = 0;
  for (const ActionKey& key : state.fly.on ? flight_keys() : action_keys()) {
    if (!told.insert(key.action).second || key.words.empty()) continue;  // a second key for the same
    const std::size_t rows_at_left = state.fly.on ? 7 : 12;
    if (row++ == rows_at_left) ImGui::NextColumn();
    key_row(interface, key.printed, key.words, scaled(72));
  }
  ImGui::Columns(1);
  ImGui::PopStyleVar();
  ImGui::Dummy({0, scaled(4)});
  if (widgets::wide_button("Close")) state.help = false;
}

void empty_dialog(ViewerState& state, const Interface& interface, const Area& viewport) {
  const Dialog dialog("empty", viewport, 420);
  title(interface, "Nothing to look at yet");
  widgets::remark(interface, "Drop a contour stack, a mesh or a volume here.");
  if (widgets::wide_button("Show the sample molar", true)) state.to_load = LoadRequest{};
  if (widgets::wide_button("Open\xE2\x80\xA6")) state.pending_actions.push_back(Action::open_file);
}

void draw_notices(const ViewerState& state, const Interface& interface, const Area& viewport) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  float bottom = static_cast<float>(viewport.top + viewport.height) - scaled(20);
  const float wrap = std::min(scaled(520), static_cast<float>(viewport.width) - scaled(60));
  for (auto notice = state.notices.rbegin(); notice != state.notices.rend(); ++notice) {
    const std::string said = interface.say(notice->words);
    const char* words = said.c_str();
    ImFont* font = interface.regular;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, wrap, words);
    const float middle = static_cast<float>(viewport.left + viewport.width / 2);
    const ImVec2 low(middle - size.x / 2 - scaled(16), bottom - size.y - scaled(20)),
        high(middle + size.x / 2 + scaled(16), bottom);
    list.AddRectFilled(low, high, theme::rgb(0x252b32, 240), scaled(8));
    list.AddRect(low, high, notice->bad ? theme::bad : theme::line, scaled(8));
    list.AddText(font, font->FontSize, {low.x + scaled(16), low.y + scaled(10)}, notice->bad ? theme::bad : theme::text,
                 words, nullptr, wrap);
    bottom = low.y - scaled(8);
  }
}

}  // namespace

Dialog::Dialog(const char* id, const Area& viewport, float width) {
  const float most = static_cast<float>(viewport.width) - scaled(32);
  ImGui::SetNextWindowPos(
      {static_cast<float>(viewport.left + viewport.width / 2), static_cast<float>(viewport.top + viewport.height / 2)},
      ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(scaled(width), most), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(24), scaled(20)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(10));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin(id, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(3);
}

Dialog::~Dialog() { ImGui::End(); }

bool begin_dialog(const char* id, const Area& viewport, float scale, float most_width, float from_bottom) {
  const float width = std::min(most_width * scale, static_cast<float>(viewport.width) - 40 * scale);
  ImGui::SetNextWindowPos({static_cast<float>(viewport.left + viewport.width / 2),
                           static_cast<float>(viewport.top + viewport.height) - from_bottom * scale},
                          ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {16 * scale, 12 * scale});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10 * scale);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::rgb(0x1a1e23, 240));
  const bool open = ImGui::Begin(id, nullptr,
                                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return open;
}

std::string stage_in_words(std::string_view stage) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> known = {
      {{"read", "Reading the file"},
       {"contours", "Tracing contours through the volume"},
       {"simplify", "Leaving out points that say nothing"},
       {"validate", "Checking the contours"},
       {"conform", "Triangulating the slices"},
       {"slabs", "Joining neighbouring slices"},
       {"plates", "Closing what ends between slices"},
       {"assemble", "Putting the slabs together"},
       {"certify", "Proving that the model is sound"},
       {"shade", "Smoothing the light"},
       {"prepare picking", "Preparing to measure"},
       {"centre lines", "Finding the canals"}}};
  for (const auto& [name, words] : known)
    if (stage == name) return std::string(words);
  return stage.empty() ? "Beginning" : fmt::format("Working: {}", stage);
}

void draw_cards(ViewerState& state, const LoadJob* loading, const Interface& interface, const Area& viewport) {
  if (loading)
    loading_dialog(state, *loading, interface, viewport);
  else if (!state.trouble.empty())
    trouble_dialog(state, interface, viewport);
  else if (state.notes.leaving)
    leaving_dialog(state, interface, viewport);
  else if (state.question)
    question_dialog(state, interface, viewport);
  else if (state.file_asked_for)
    open_dialog(state, interface, viewport);
  else if (state.help && state.pad_in_hand)
    gamepad_dialog(state, interface, viewport);
  else if (state.help)
    help_dialog(state, interface, {0, 0, viewport.left + viewport.width, viewport.height});  // long, so over all
  else if (!state.shown)
    empty_dialog(state, interface, viewport);
  draw_notices(state, interface, viewport);
}

}  // namespace odontoscope
