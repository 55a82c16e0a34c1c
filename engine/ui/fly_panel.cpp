#include "engine/ui/fly_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "engine/ui/fly_marks.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void two_buttons(ViewerState& state, const char* left, Action on_left, const char* right, Action on_right) {
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::Button(left, {width, 0})) state.todo.push_back(on_left);
  ImGui::SameLine();
  if (ImGui::Button(right, {width, 0})) state.todo.push_back(on_right);
}

void flight_section(ViewerState& state, const Interface& interface) {
  FlyState& fly = state.fly;
  if (widgets::wide_button("Back to outside (C)", true)) state.todo.push_back(Action::leave_flight);
  if (widgets::wide_button("Through the wall ahead (X)")) state.todo.push_back(Action::pass_wall);
  widgets::remark(interface, "W A S D fly, Q E down and up, or with the other hand I J K L and U O. Arrow keys or a drag look around. Shift: faster. ? lists all keys.");
  widgets::slider("Speed", fly.haste, least_haste, most_haste, "%.1f \xC3\x97");
  widgets::toggle("Mouse looks without a button (M)", fly.mouse_caught);
}

void comfort_section(ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Comfort", false)) return;
  Comfort& comfort = state.settings.comfort;
  widgets::slider("Angle of view", comfort.field_of_view_deg, 40, 110, "%.0f\xC2\xB0");
  widgets::slider("Speed limit", comfort.speed_limit, 0.5, 24, "%.1f \xC3\x97");
  widgets::toggle("Dark rim while turning", comfort.vignette);
  widgets::toggle("Reduced motion", comfort.reduced_motion);
  widgets::remark(interface, "Reduced motion: no dives and no flights by themselves, and keys turn more slowly. All of this is remembered.");
}

}  // namespace

void fly_entrance(ViewerState& state, const Interface& interface) {
  if (!state.shown || !state.shown->flight) return;
  if (state.shown->flight->cavities.empty()) {
    if (widgets::wide_button("Fly around (A)")) state.todo.push_back(Action::fly_outdoors);
    widgets::remark(interface, "This model has no cavity to fly in.");
    return;
  }
  two_buttons(state, "Fly inside (C)", Action::enter_pulp, "Fly around (A)", Action::fly_outdoors);
}

void fly_sections(ViewerState& state, const Interface& interface) {
  flight_section(state, interface);
  comfort_section(state, interface);
}

}  // namespace odontoscope
