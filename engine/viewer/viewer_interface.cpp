// What is written and drawn over the picture: marks, the panel, dialogs.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/ui/drawing.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/panel.h"
#include "engine/viewer/viewer.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void draw_dark(const Area& viewport, double dark) {
  if (!(dark > 0)) return;
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      vec(viewport.left, viewport.top), vec(viewport.left + viewport.width, viewport.top + viewport.height),
      theme::rgb(0x000000, static_cast<unsigned>(std::lround(255 * std::clamp(dark, 0.0, 1.0)))));
}

}  // namespace

void Viewer::draw_interface(const FrameInput& input, const Target& target) {
  FrameInput scaled_input = input;
  scaled_input.scale = at_.layout.scale;
  at_.interface.begin(scaled_input);
  if (at_.state.shown) draw_panes();
  const double height = static_cast<double>(input.size.height);
  if (at_.state.settings.panel) draw_panel({0, 0, at_.layout.viewport.left, height});
  const DrawnPane first{at_.front()};
  for (const auto& mode : at_.modes) mode->draw(DrawLayer::windows, first);
  draw_dialogs();
  for (const auto& mode : at_.modes) mode->draw(DrawLayer::lists, first);
  const ImDrawData* drawn = at_.interface.end();
  if (const int by = std::exchange(steps_by_tab_, 0))
    at_.interface.step(by, !at_.modes.dialog_open() && !at_.modes.writing());
  std::optional<GreyPicture> slice;
  for (const auto& mode : at_.modes)
    if (!slice) slice = mode->slice();
  interface_pass_.draw(at_.interface, *drawn, target, slice ? &*slice : nullptr);
  if (at_.state.shown) at_.state.settings.back_faces = at_.state.scene.back_faces;
}

void Viewer::draw_panes() {
  const std::vector<ViewPane>& panes = at_.layout.panes;
  for (auto mode = at_.modes.rbegin(); mode != at_.modes.rend(); ++mode)
    (*mode)->draw(DrawLayer::ground, {panes.front()});
  draw_dark(at_.layout.viewport, at_.fade.dark());
  for (const ViewPane& pane : panes) {
    const bool first = &pane == &panes.front();
    const DrawnPane drawn{pane, first, &pane == &panes.back(), pane.seen && !first};
    for (const DrawLayer layer : {DrawLayer::marks, DrawLayer::front})
      for (auto mode = at_.modes.rbegin(); mode != at_.modes.rend(); ++mode) (*mode)->draw(layer, drawn);
  }
}

void Viewer::draw_panel(const Area& area) {
  ViewerState& state = at_.state;
  ImGui::SetNextWindowPos({static_cast<float>(area.left), static_cast<float>(area.top)});
  ImGui::SetNextWindowSize({static_cast<float>(area.width), static_cast<float>(area.height)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  panel_heading(state, at_.interface);
  if (state.shown) {
    const bool outside = at_.modes.effects().from_outside;
    std::vector<PanelSection> sections;
    for (const auto& mode : at_.modes)
      for (PanelSection& section : mode->panel())
        if (outside || section.also_inside) sections.push_back(std::move(section));
    std::stable_sort(sections.begin(), sections.end(),
                     [](const PanelSection& a, const PanelSection& b) { return a.place < b.place; });
    for (const PanelSection& section : sections) section.draw();
  }
  ImGui::Dummy({0, scaled(2)});
  if (state.shown && state.headset_possible && widgets::wide_button("Enter the headset")) state.headset_asked = true;
  if (widgets::wide_button("Open a file\xE2\x80\xA6")) state.pending_actions.push_back(Action::open_file);
  ImGui::End();
}

/// The first only: they would lie on one another.
void Viewer::draw_dialogs() {
  for (const auto& mode : at_.modes)
    if (mode->draw_dialog()) break;
  draw_notices(at_.state.notices, at_.interface, at_.layout.viewport);
}

}  // namespace odontoscope
