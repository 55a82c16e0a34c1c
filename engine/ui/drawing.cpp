#include "engine/ui/drawing.h"

#include <utility>

#include "engine/ui/theme.h"

namespace odontoscope {

void draw_dot(ImDrawList& list, const ImVec2& place, float scale) {
  list.AddCircleFilled(place, 6.5f * scale, theme::mark_outline, 24);
  list.AddCircleFilled(place, 4.5f * scale, theme::mark, 24);
}

void draw_cross(const Area& area, float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 middle = vec(area.left + area.width / 2, area.top + area.height / 2);
  for (const float thick : {4.0f, 1.6f})
    for (const ImVec2& arm : {ImVec2(9 * scale, 0), ImVec2(0, 9 * scale)})
      list.AddLine({middle.x - arm.x, middle.y - arm.y}, {middle.x + arm.x, middle.y + arm.y},
                   thick > 2 ? theme::mark_outline : theme::mark, thick * scale);
}

void outlined(ImDrawList& list, ImFont* font, float size, const ImVec2& place, ImU32 colour, const char* words) {
  for (const auto& [dx, dy] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
    list.AddText(font, size, {place.x + dx, place.y + dy}, theme::mark_outline, words);
  list.AddText(font, size, place, colour, words);
}

}  // namespace odontoscope
