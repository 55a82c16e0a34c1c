#include "engine/viewer/measure/measure_mode.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "engine/measure/film_length.h"
#include "engine/navigate/screen.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

void MeasureMode::leave() {
  tool_ = Tool::look;
  measured_ = {};
}

void MeasureMode::choose(Tool tool) {
  tool_ = tool_ == tool ? Tool::look : tool;
  measured_ = {};
}

bool MeasureMode::perform(Action action) {
  if (!state_.shown) return false;
  switch (action) {
    case Action::measure_distance:
      choose(Tool::distance);
      return true;
    case Action::measure_thickness:
      choose(Tool::thickness);
      return true;
    case Action::enter_here:
      if (tool_ == Tool::look) return false;
      measure_middle();
      return true;
    default:
      return false;
  }
}

void MeasureMode::measure_middle() {
  const ViewPane& pane = at_.front();
  const double x = pane.area.left + pane.area.width / 2, y = pane.area.top + pane.area.height / 2;
  if (const auto hit = at_.hit_at(pane, x, y))
    measure_at(at_.pickable_of(pane), *hit);
  else
    notice("In the middle of the picture there is no surface: turn the model with the arrow keys.");
}

bool MeasureMode::click(const Click& click) {
  if (tool_ == Tool::look) return false;
  if (at_.modes.get<NamesMode>().tell_name(click)) return true;  // it lies over the surface
  if (const auto hit = at_.hit_at(click.pane, click.x, click.y)) measure_at(at_.pickable_of(click.pane), *hit);
  return true;
}

void MeasureMode::measure_at(const Pickable& pickable, const Hit& hit) {
  if (tool_ == Tool::distance) {
    if (measured_.ends.size() != 1) measured_ = {};
    measured_.ends.push_back(hit);
    return;
  }
  measured_ = {};
  measured_.wall_at = hit;
  measured_.wall = wall_thickness(pickable, hit);
  if (!measured_.wall)
    notice(hit.triangle ? "No wall here: straight into the material there is no other side."
                        : "Measure walls on a surface, not on the cut.");
}

bool MeasureMode::hover(const Hover&) {
  if (tool_ != Tool::look) at_.pointing.pointer = Pointer::cross;
  return false;
}

bool MeasureMode::put_away(PutAway what) {
  if (what == PutAway::step && tool_ != Tool::look) {
    lay_down_tool();
    return true;
  }
  if (what == PutAway::mark) measured_ = {};
  return what == PutAway::mark;
}

std::string MeasureMode::click_hint() const {
  if (tool_ == Tool::look) return {};
  if (tool_ == Tool::thickness) return "Click a surface to measure the wall behind it. Enter: at the cross";
  return measured_.ends.size() == 1 ? "Click the second point. Enter: at the cross"
                                    : "Click the first point. Enter: at the cross";
}

std::vector<PanelSection> MeasureMode::panel() {
  return {{SectionPlace::measure, [this] { section(); }}};
}

void MeasureMode::section() {
  if (!widgets::section(at_.interface, "Measure")) return;
  int tool = tool_ == Tool::distance ? 0 : tool_ == Tool::thickness ? 1 : -1;
  if (widgets::choice("tool", tool, {"Distance", "Wall thickness"}))
    state_.pending_actions.push_back(tool == 0 ? Action::measure_distance : Action::measure_thickness);
  if (measured_.ends.size() == 2) {
    widgets::text(fmt::format("{:.3f} mm", distance_between_mm(measured_.ends[0], measured_.ends[1])));
    widgets::remark(at_.interface,
                    fmt::format("from {} to {}, straight", measured_.ends[0].structure, measured_.ends[1].structure));
  } else if (measured_.wall) {
    widgets::text(fmt::format("{:.3f} mm", measured_.wall->along_normal_mm));
    widgets::remark(at_.interface,
                    fmt::format("{}, straight through. The largest ball that fits in is {:.3f} mm across.",
                                measured_.wall_at->structure, measured_.wall->largest_ball_mm));
  }
  if (tool_ != Tool::look && widgets::wide_button("Done")) state_.pending_actions.push_back(Action::escape);
}

namespace {

void draw_length(const ViewPane& pane, const glm::dvec3& from, const glm::dvec3& to, const std::string& english,
                 const Interface& interface, float scale) {
  const std::string words = interface.say(english);
  const auto a = place_of(pane.camera, from), b = place_of(pane.camera, to);
  if (!a || !b) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 start = vec(pixel_of(pane.area, *a)), end = vec(pixel_of(pane.area, *b));
  list.AddLine(start, end, theme::mark_outline, 5 * scale);
  list.AddLine(start, end, theme::mark, 2.2f * scale);
  draw_dot(list, start, scale);
  draw_dot(list, end, scale);
  ImFont* font = interface.bold;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
  const ImVec2 corner((start.x + end.x) / 2 + 12 * scale, (start.y + end.y) / 2 - extent.y / 2);
  list.AddRectFilled({corner.x - 8 * scale, corner.y - 5 * scale},
                     {corner.x + extent.x + 8 * scale, corner.y + extent.y + 5 * scale}, theme::rgb(0x14181c, 225),
                     6 * scale);
  list.AddText(font, font->FontSize, corner, theme::mark, words.c_str());
}

}  // namespace

void MeasureMode::draw(DrawLayer layer, const DrawnPane& drawn) {
  if (layer != DrawLayer::marks || drawn.again) return;
  const ViewPane& pane = drawn.pane;
  const float scale = at_.layout.scale;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ClipTo clip(list, pane.area);
  if (measured_.ends.size() == 2) {
    const std::array ends{measured_.ends[0].point_mm, measured_.ends[1].point_mm};
    const std::string words =
        state_.film() ? fmt::format("{:.2f} mm on the film",
                                    length_on_film(ends, pane.camera, state_.shown->model.bounds_mm.centre()))
                      : fmt::format("{:.2f} mm", distance_between_mm(measured_.ends[0], measured_.ends[1]));
    draw_length(pane, ends[0], ends[1], words, at_.interface, scale);
  } else if (measured_.wall_at && measured_.wall) {
    draw_length(pane, measured_.wall_at->point_mm, measured_.wall->opposite_mm,
                fmt::format("{:.2f} mm", measured_.wall->along_normal_mm), at_.interface, scale);
  } else if (measured_.wall_at || !measured_.ends.empty()) {
    const auto place =
        place_of(pane.camera, measured_.wall_at ? measured_.wall_at->point_mm : measured_.ends[0].point_mm);
    if (place) draw_dot(list, vec(pixel_of(pane.area, *place)), scale);
  }
}

}  // namespace odontoscope
