#include "engine/viewer/panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

using widgets::scaled;

/// With a capital at its beginning.
std::string sentence(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

}  // namespace

void panel_heading(ViewerState& state, const Interface& interface) {
  ImGui::PushFont(interface.large);
  widgets::text(state.shown ? state.shown->title : "Odontoscope");
  ImGui::PopFont();
  const float button = scaled(30);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  if (widgets::button("?", {button, button})) state.pending_actions.push_back(Action::toggle_help);
  if (!state.shown) return;
  if (!state.shown->tooth.empty()) widgets::wrapped(sentence(state.shown->tooth));
  // In a word; what wants a look has its report above all else.
  const Certificate::Verdict verdict = state.shown->certificate.verdict;
  if (mark_of(verdict) != Certificate::Mark::good) return;
  ImGui::PushFont(interface.small);
  widgets::marked(
      interface, Certificate::Mark::good,
      verdict == Certificate::Verdict::certified ? "Certified: the report is below" : "Sound: the report is below");
  ImGui::PopFont();
}

void two_buttons(std::vector<Action>& pending, const char* left, Action on_left, const char* right, Action on_right) {
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (widgets::button(left, {width, 0})) pending.push_back(on_left);
  ImGui::SameLine();
  if (widgets::button(right, {width, 0})) pending.push_back(on_right);
}

bool colour_swatch(const char* id, Colour& colour) {
  std::array channels{colour.red, colour.green, colour.blue};
  if (!widgets::swatch(id, channels)) return false;
  colour = {channels[0], channels[1], channels[2]};
  return true;
}

void draw_notices(const std::vector<Notice>& notices, const Interface& interface, const Area& viewport) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  float bottom = static_cast<float>(viewport.top + viewport.height) - scaled(20);
  const float wrap = std::min(scaled(520), static_cast<float>(viewport.width) - scaled(60));
  for (auto notice = notices.rbegin(); notice != notices.rend(); ++notice) {
    const std::string said = interface.say(notice->words);
    const char* words = said.c_str();
    ImFont* font = interface.regular;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, wrap, words);
    const float middle = static_cast<float>(viewport.left + viewport.width / 2);
    const ImVec2 low(middle - size.x / 2 - scaled(16), bottom - size.y - scaled(20)),
        high(middle + size.x / 2 + scaled(16), bottom);
    list.AddRectFilled(low, high, theme::rgb(0x252b32, 240), scaled(8));
    list.AddRect(low, high, notice->kind == NoticeKind::bad ? theme::bad : theme::line, scaled(8));
    list.AddText(font, font->FontSize, {low.x + scaled(16), low.y + scaled(10)},
                 notice->kind == NoticeKind::bad ? theme::bad : theme::text, words, nullptr, wrap);
    bottom = low.y - scaled(8);
  }
}

}  // namespace odontoscope
