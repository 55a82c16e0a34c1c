#include "engine/viewer/help/help_mode.h"

#include <imgui.h>

#include <set>
#include <utility>

#include "engine/ui/dialog.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

using widgets::scaled;

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

}  // namespace

bool HelpMode::perform(Action action) {
  if (action != Action::toggle_help) return false;
  open_ = !open_;
  return true;
}

bool HelpMode::put_away(PutAway what) { return what == PutAway::dialog && std::exchange(open_, false); }

bool HelpMode::answer() { return std::exchange(open_, false); }

bool HelpMode::hints_shown() const { return state_.settings.hints && state_.shown && at_.modes.effects().first_hints; }

void HelpMode::advance(double) {
  if (hints_.follow(at_)) notice("That is all it takes. ? lists the keys, G the lessons.", NoticeKind::told, 10);
}

void HelpMode::draw(DrawLayer layer, const DrawnPane&) {
  if (layer == DrawLayer::windows && hints_shown()) hints_.draw(at_);
}

bool HelpMode::draw_dialog() {
  if (!open_) return false;
  if (state_.pad_in_hand)
    gamepad_dialog();
  else
    keys_dialog();
  return true;
}

void HelpMode::gamepad_dialog() {
  const Dialog dialog("help", at_.layout.viewport, 480);
  dialog_title(at_.interface, "Gamepad");
  for (const Gesture& gesture : gamepad_gestures()) key_row(at_.interface, gesture.printed, gesture.words, scaled(170));
  widgets::remark(at_.interface,
                  "By the letters of an Xbox pad: A lies below, B at the right, X at the left, Y above. ? on the "
                  "keyboard lists the keys.");
  if (widgets::wide_button("Close (Start or B)")) open_ = false;
}

void HelpMode::keys_dialog() {
  const Area& viewport = at_.layout.viewport;
  const Dialog dialog("help", {0, 0, viewport.left + viewport.width, viewport.height}, 840);  // long, so over all
  dialog_title(at_.interface, "Mouse and keys");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(8), scaled(5)});
  ImGui::Columns(2, "columns", false);
  ImGui::SetColumnWidth(0, scaled(420));
  const auto gesture_rows = [&](std::span<const Gesture> gestures) {
    for (const Gesture& gesture : gestures) key_row(at_.interface, gesture.printed, gesture.words, scaled(180));
  };
  const KeyTable& table = at_.modes.keys();
  gesture_rows(table.gestures);
  for (const auto& mode : at_.modes) gesture_rows(mode->gestures());
  ImGui::Dummy({0, scaled(6)});
  std::set<Action> told;
  std::size_t row = 0;
  for (const ActionKey& key : table.keys) {
    if (!told.insert(key.action).second || key.words.empty()) continue;  // a second key for the same
    if (row++ == table.rows_at_left) ImGui::NextColumn();
    key_row(at_.interface, key.printed, key.words, scaled(72));
  }
  ImGui::Columns(1);
  ImGui::PopStyleVar();
  ImGui::Dummy({0, scaled(4)});
  if (widgets::wide_button("Close")) open_ = false;
}

}  // namespace odontoscope
