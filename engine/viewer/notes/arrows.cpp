// Arrows in the picture.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/viewer/notes/pins.h"

namespace odontoscope {

namespace {

constexpr float head_length = 17, head_half_width = 7.5f, shaft = 3.4f, outline = 2;  // interface pixels

/// From tail to head. A head is drawn whole however short the arrow comes out.
void draw_shape(ImDrawList& list, const ImVec2& tail, const ImVec2& head, double strength, float scale) {
  const float across = head.x - tail.x, down = head.y - tail.y, length = std::hypot(across, down);
  if (length < 1e-3f) return;
  const ImVec2 along(across / length, down / length), side(-along.y, along.x);
  const auto place = [&](float back, float aside) {
    return ImVec2(head.x - back * along.x + aside * side.x, head.y - back * along.y + aside * side.y);
  };
  const float end = head_length * scale, half = head_half_width * scale, edge = outline * scale;
  const ImVec2 neck = place(std::min(0.8f * end, length), 0);
  const ImU32 dark = faded(theme::mark_outline, strength), bright = faded(theme::mark, strength);
  list.AddLine(tail, neck, dark, shaft * scale + 2 * edge);
  list.AddTriangleFilled(place(-2 * edge, 0), place(end + edge, half + 1.5f * edge),
                         place(end + edge, -half - 1.5f * edge), dark);
  list.AddLine(tail, neck, bright, shaft * scale);
  list.AddTriangleFilled(head, place(end, half), place(end, -half), bright);
}

/// The tail, or of an arrow that comes from behind the eye the last place before it.
std::optional<glm::dvec2> tail_in_picture(const Camera& camera, const LessonArrow& arrow) {
  if (const auto place = place_of(camera, arrow.from)) return place;
  double seen = 0, unseen = 1;  // of the way back from the head
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (seen + unseen);
    (place_of(camera, glm::mix(arrow.to, arrow.from, middle)) ? seen : unseen) = middle;
  }
  return place_of(camera, glm::mix(arrow.to, arrow.from, 0.98 * seen));
}

struct LabelBox {
  ImVec2 corner, size;
};

/// Beyond the tail as seen from the head, within the pane, below labels that are there already.
void draw_label(ImDrawList& list, const ImFont* font, const std::string& label, const ImVec2& tail, const ImVec2& head,
                const ViewPane& pane, double strength, float scale, std::vector<LabelBox>& labels) {
  const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e9f, 0, label.c_str()),
               size(text.x + 16 * scale, text.y + 10 * scale);
  const float length = std::max(std::hypot(tail.x - head.x, tail.y - head.y), 1e-3f),
              right = (tail.x - head.x) / length, down = (tail.y - head.y) / length;
  const auto within = [](float wanted, double low, double high) {
    return std::clamp(wanted, static_cast<float>(low), std::max(static_cast<float>(low), static_cast<float>(high)));
  };
  const float gap = 2 * scale, margin = 6 * scale;
  const ImVec2 middle(tail.x + right * (0.5f * size.x + gap), tail.y + down * (0.5f * size.y + gap));
  ImVec2 corner(
      within(middle.x - 0.5f * size.x, pane.area.left + margin, pane.area.left + pane.area.width - size.x - margin),
      within(middle.y - 0.5f * size.y, pane.area.top + margin, pane.area.top + pane.area.height - size.y - margin));
  for (const LabelBox& other : labels) {
    const bool beside = corner.x > other.corner.x + other.size.x || other.corner.x > corner.x + size.x;
    const bool apart = corner.y > other.corner.y + other.size.y || other.corner.y > corner.y + size.y;
    if (!beside && !apart) corner.y = other.corner.y + other.size.y + 4 * scale;
  }
  const auto below =
      std::find_if(labels.begin(), labels.end(), [&](const LabelBox& other) { return other.corner.y > corner.y; });
  labels.insert(below, {corner, size});
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, theme::rgb(0x14181c, 225), 6 * scale);
  list.AddText(font, font->FontSize, {corner.x + 8 * scale, corner.y + 5 * scale}, faded(theme::mark, strength),
               label.c_str());
}

}  // namespace

void draw_arrows(const std::vector<LessonArrow>& arrows, const ViewerState& state, const PinsSeenFrom& from,
                 const ViewPane& pane, const Interface& interface, float scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ClipTo clip(list, pane.area);
  std::vector<LabelBox> labels;  // from above to below
  for (const LessonArrow& arrow : arrows) {
    const auto to = place_of(pane.camera, arrow.to);
    const PlaceSeen seen = to ? seen_place(state, from, pane, arrow.to) : PlaceSeen::hidden;
    if (seen == PlaceSeen::hidden) continue;
    const auto begins = tail_in_picture(pane.camera, arrow);
    if (!begins) continue;
    const ImVec2 head = vec(pixel_of(pane.area, *to)), tail = vec(pixel_of(pane.area, *begins));
    const bool behind = seen == PlaceSeen::behind;
    draw_shape(list, tail, head, behind ? 0.45 : 1, scale);
    if (!arrow.label.empty())
      draw_label(list, interface.bold, arrow.label, tail, head, pane, behind ? 0.75 : 1, scale, labels);
  }
}

void draw_begun_arrow(const ArrowTail& tail, const ViewPane& pane, const glm::dvec2& pointer, float scale) {
  const glm::dvec3 about = tail.surface.value_or(point_at_depth_of(tail.camera, tail.place, tail.camera.target));
  const auto place = place_of(pane.camera, about);
  if (!place) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ClipTo clip(list, pane.area);
  const ImVec2 begins = vec(pixel_of(pane.area, *place));
  draw_shape(list, begins, vec(pointer), 1, scale);
  draw_dot(list, begins, scale);
}

}  // namespace odontoscope
