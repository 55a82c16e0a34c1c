// Pins in the picture.

#include "engine/viewer/notes/pins.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

constexpr double wall_slack_mm = 0.3, opaque_slack_mm = 1.5;  // a pin may stand in the middle of a canal
constexpr float hides = 0.9f;

struct DrawnPin {
  ImVec2 at, corner, size;
  const char* label;
  bool behind;
};

}  // namespace

PlaceSeen seen_place(const ViewerState& state, const PinsSeenFrom& from, const ViewPane& pane, const glm::dvec3& at) {
  const glm::dvec3 eye = pane.camera.position, way = at - eye;
  const double distance = glm::length(way);
  if (distance < 1e-9) return PlaceSeen::hidden;
  if (!from.outside) {
    if (!from.cavity) return PlaceSeen::plain;
    const Walls& walls = from.cavity->walls;
    return walls.free_distance(eye, way / distance, distance) < distance - wall_slack_mm ? PlaceSeen::hidden
                                                                                         : PlaceSeen::plain;
  }
  const auto place = place_of(pane.camera, at);
  if (!place) return PlaceSeen::hidden;
  const SightLine sight = sight_line(pane.camera, *place);
  const auto hit = pick(*state.shown->pickable, state.scene, {sight.origin, sight.direction}, {.least_opacity = hides});
  return hit && hit->distance_mm < glm::dot(at - sight.origin, sight.direction) - opaque_slack_mm ? PlaceSeen::behind
                                                                                                  : PlaceSeen::plain;
}

void draw_pins(const std::vector<LessonPin>& marks, const ViewerState& state, const PinsSeenFrom& from,
               const ViewPane& pane, const Interface& interface, float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 low = vec(pane.area.left, pane.area.top),
               high = vec(pane.area.left + pane.area.width, pane.area.top + pane.area.height);
  list.PushClipRect(low, high);
  const ImFont* font = interface.bold;
  std::vector<DrawnPin> pins;
  for (const LessonPin& mark : marks) {
    const auto place = place_of(pane.camera, mark.at);
    const PlaceSeen how = place ? seen_place(state, from, pane, mark.at) : PlaceSeen::hidden;
    if (how == PlaceSeen::hidden) continue;
    const ImVec2 at = vec(pixel_of(pane.area, *place));
    const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e9f, 0, mark.label.c_str()),
                 size(text.x + 16 * scale, text.y + 10 * scale);
    // Away from the middle, where the tooth is.
    const bool right = at.x > 0.5f * (low.x + high.x);
    const float gap = 46 * scale, wanted = right ? at.x + gap : at.x - gap - size.x;
    const ImVec2 corner(std::clamp(wanted, low.x + 6 * scale, std::max(low.x + 6 * scale, high.x - size.x - 6 * scale)),
                        at.y - size.y - 12 * scale);
    pins.push_back({at, corner, size, mark.label.c_str(), how == PlaceSeen::behind});
  }
  // Labels one under another rather than one on another.
  std::stable_sort(pins.begin(), pins.end(),
                   [](const DrawnPin& a, const DrawnPin& b) { return a.corner.y < b.corner.y; });
  for (std::size_t i = 0; i < pins.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const bool beside =
          pins[i].corner.x > pins[k].corner.x + pins[k].size.x || pins[k].corner.x > pins[i].corner.x + pins[i].size.x;
      if (!beside && *pins[i].label && *pins[k].label)
        pins[i].corner.y = std::max(pins[i].corner.y, pins[k].corner.y + pins[k].size.y + 4 * scale);
    }
  for (const DrawnPin& pin : pins) {
    const double strength = pin.behind ? 0.45 : 1;
    if (*pin.label) {
      const float middle = pin.corner.y + 0.5f * pin.size.y,
                  side = pin.corner.x > pin.at.x ? pin.corner.x : pin.corner.x + pin.size.x;
      list.AddLine(pin.at, {side, middle}, faded(theme::mark_outline, strength), 4 * scale);
      list.AddLine(pin.at, {side, middle}, faded(theme::mark, strength), 1.8f * scale);
      list.AddRectFilled(pin.corner, {pin.corner.x + pin.size.x, pin.corner.y + pin.size.y}, theme::rgb(0x14181c, 225),
                         6 * scale);
      list.AddText(font, font->FontSize, {pin.corner.x + 8 * scale, pin.corner.y + 5 * scale},
                   faded(theme::mark, pin.behind ? 0.75 : 1), pin.label);
    }
    const float radius = (*pin.label ? 5.5f : 9.0f) * scale;
    list.AddCircleFilled(pin.at, radius + 2 * scale, faded(theme::mark_outline, strength), 32);
    if (pin.behind)
      list.AddCircle(pin.at, radius, faded(theme::mark, strength), 32, 2 * scale);
    else
      list.AddCircleFilled(pin.at, radius, theme::mark, 32);
    if (!*pin.label && !pin.behind) {
      const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, "?");
      list.AddText(font, font->FontSize, {pin.at.x - 0.5f * extent.x, pin.at.y - 0.5f * extent.y}, theme::rgb(0x10151a),
                   "?");
    }
  }
  list.PopClipRect();
}

}  // namespace odontoscope
