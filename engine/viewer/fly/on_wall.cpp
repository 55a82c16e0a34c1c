#include "engine/viewer/fly/on_wall.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/wall_colours.h"
#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

constexpr double bar_height = 12, legend_width = 240, above_bottom = 124;  // interface pixels

}  // namespace

WallNumber told_on_wall(const Comfort& comfort) {
  return comfort.wall_thickness ? WallNumber::thickness : comfort.wall_depth ? WallNumber::depth : WallNumber::none;
}

void tell_on_wall(Comfort& comfort, WallNumber number) {
  comfort.wall_thickness = number == WallNumber::thickness;
  comfort.wall_depth = number == WallNumber::depth;
}

void next_on_wall(Comfort& comfort, bool tells_thickness) {
  const WallNumber now = told_on_wall(comfort);
  if (now == WallNumber::depth)
    tell_on_wall(comfort, tells_thickness ? WallNumber::thickness : WallNumber::none);
  else
    tell_on_wall(comfort, now == WallNumber::thickness ? WallNumber::none : WallNumber::depth);
}

std::string thickness_in_words(const Model& model) {
  const auto [bold, twice, thickest] = thickness_marks_mm(model);
  return fmt::format(
      "To the outside: a line every {:g} mm, a bold one at {:g} and {:g} mm. Blue where it is thin, its own colour "
      "from {:g} mm on.",
      model.thickness_step_mm(), bold, twice, thickest);
}

void draw_thickness_legend(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale) {
  if (!state.shown) return;
  const Model& model = state.shown->model;
  const auto own = telling_thickness(state.scene, model);
  if (!own) return;
  const double width = std::min(legend_width * scale, 0.6 * pane.area.width), x = pane.area.left + 26 * scale,
               y = pane.area.top + pane.area.height - above_bottom * scale;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImFont* font = interface.small;
  const double letters = static_cast<double>(font->FontSize), bar_top = y + letters + 6 * scale,
               tall = bar_height * scale, numbers_top = bar_top + tall + 3 * scale,
               bottom = numbers_top + letters + 2 * scale;
  list.AddRectFilled(vec(x - 10 * scale, y - 6 * scale), vec(x + width + 10 * scale, bottom + 6 * scale),
                     theme::rgb(0x14181c, 205), 8 * scale);
  list.AddText(font, font->FontSize, vec(x, y), theme::text, interface.say("Thickness of the wall, mm").c_str());
  const std::vector<ShownColour> bar = thickness_bar(*own, static_cast<int>(std::lround(width)));
  for (std::size_t i = 0; i < bar.size(); ++i)
    list.AddRectFilled(vec(x + static_cast<double>(i), bar_top), vec(x + static_cast<double>(i + 1), bar_top + tall),
                       IM_COL32(bar[i][0], bar[i][1], bar[i][2], 255));
  const auto [bold, twice, thickest] = thickness_marks_mm(model);
  for (const double mm : {0.0, bold, twice, thickest}) {
    const std::string words = fmt::format("{:g}", mm);
    const double wide = static_cast<double>(font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str()).x);
    const double at = std::clamp(x + width * mm / thickest - 0.5 * wide, x, x + width - wide);
    list.AddText(font, font->FontSize, vec(at, numbers_top), theme::text, words.c_str());
  }
}

}  // namespace odontoscope
