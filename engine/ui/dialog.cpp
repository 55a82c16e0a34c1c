#include "engine/ui/dialog.h"

#include <imgui.h>

#include <algorithm>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

using widgets::scaled;

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

void dialog_title(const Interface& interface, const char* words) {
  ImGui::PushFont(interface.large);
  widgets::wrapped(words);
  ImGui::PopFont();
}

}  // namespace odontoscope
