#include "engine/viewer/fly/fly_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "engine/navigate/thickness_colours.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/fly/on_wall.h"
#include "engine/viewer/panel.h"

namespace odontoscope {

namespace {

using widgets::scaled;

void flight_section(FlyState& fly, ViewerState& state, const Interface& interface) {
  if (widgets::wide_button("Back to outside (C)", widgets::Emphasis::strong))
    state.pending_actions.push_back(Action::leave_flight);
  if (widgets::wide_button("Through the wall ahead (X)")) state.pending_actions.push_back(Action::pass_wall);
  widgets::remark(interface,
                  "W A S D fly, Q E down and up, or with the other hand I J K L and U O. Arrow keys or a drag look "
                  "around. Shift: faster. ? lists all keys.");
  widgets::slider("Speed", fly.habits.speed_factor, least_speed_factor, most_speed_factor, "%.1f \xC3\x97");
  widgets::toggle("Mouse looks without a button (M)", fly.mouse_caught);
}

/// A button for each canal, horn and branch.
void canal_buttons(FlyState& fly, const std::vector<const CentreLine*>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool here = fly.ride && fly.ride->line == i;
    const double length = lines[i]->length_to_wall();
    const std::string words = fly.on && i < 9 ? fmt::format("{}   {:.1f} mm   ({})", lines[i]->name, length, i + 1)
                                              : fmt::format("{}   {:.1f} mm", lines[i]->name, length);
    if (widgets::wide_button(words.c_str(), widgets::strong_if(here))) fly.ride_asked = i;
  }
}

/// The canals, and the ride's controls.
void ride_section(FlyState& fly, ViewerState& state, const Interface& interface) {
  if (!fly.cavity) return;
  const auto lines = rideable(state.shown->flight->cavities[*fly.cavity].lines);
  if (lines.empty() || !widgets::section(interface, "Canals")) return;
  canal_buttons(fly, lines);
  if (!fly.ride) {
    widgets::remark(interface, "Choose one to be led along it; or click its name in the picture.");
    return;
  }
  Ride& ride = *fly.ride;
  two_buttons(state.pending_actions, ride.playing ? "Stop (Space)" : "Go on (Space)", Action::ride_play,
              ride.back ? "Forwards (R)" : "Backwards (R)", Action::ride_back);
  const double from = ride.track.points.front().along, to = ride.track.points.back().along;
  if (widgets::slider("Along the canal", ride.along, from, to, "%.2f mm")) ride.playing = false;
  widgets::remark(interface, "Arrow keys or a drag look around on the way; any key that flies leaves it.");
}

/// What the wall tells, and what that means.
void on_wall(ViewerState& state, const Interface& interface) {
  Comfort& comfort = state.settings.comfort;
  const Model& model = state.shown->model;
  if (!tells_thickness(model)) {
    widgets::toggle("Depth on the wall (G)", comfort.wall_depth);
  } else {
    widgets::text("On the wall (G)");
    int chosen = static_cast<int>(told_on_wall(comfort));
    if (widgets::choice("on the wall", chosen, {"Nothing", "Depth", "Thickness"}))
      tell_on_wall(comfort, static_cast<WallNumber>(chosen));
  }
  const WallNumber told = told_on_wall(comfort);
  if (told == WallNumber::depth)
    widgets::remark(interface, fmt::format("Below the orifice: a ring every {:.0f} mm, a bold one every {:.0f}. Amber "
                                           "near the crown, teal and blue towards the apex.",
                                           model.depth_step_mm, 5 * model.depth_step_mm));
  if (told == WallNumber::thickness)
    widgets::remark(interface, tells_thickness(model)
                                   ? thickness_in_words(model)
                                   : "Of this model no thickness is known: its walls have no outside.");
}

void where_section(FlyState& fly, ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Where am I")) return;
  widgets::remark(interface, where_in_words(fly, state));
  if (const std::string measured = measured_in_words(fly, state); !measured.empty())
    widgets::remark(interface, measured);
  widgets::toggle("Names (B)", fly.habits.labels);
  on_wall(state, interface);
  widgets::toggle("Tooth and slice, small (H)", fly.habits.inset);
}

void comfort_section(FlyState& fly, ViewerState& state, const Interface& interface) {
  if (!widgets::section(interface, "Comfort", widgets::AtFirst::folded)) return;
  Comfort& comfort = state.settings.comfort;
  if (widgets::slider("Angle of view", comfort.field_of_view_deg, 40, 110, "%.0f\xC2\xB0")) fly.view_deg.reset();
  widgets::slider("Speed limit", comfort.speed_limit, 0.5, 24, "%.1f \xC3\x97");
  widgets::toggle("Dark rim while turning", comfort.vignette);
  widgets::toggle("Reduced motion", comfort.reduced_motion);
  widgets::remark(
      interface,
      "Reduced motion: no dives and no flights by themselves, and keys turn more slowly. All of this is remembered.");
}

}  // namespace

void fly_entrance(FlyState& fly, ViewerState& state, const Interface& interface) {
  if (!state.shown || !state.shown->flight) return;
  if (state.shown->flight->cavities.empty()) {
    if (widgets::wide_button("Fly around (A)")) state.pending_actions.push_back(Action::fly_outdoors);
    widgets::remark(interface, "This model has no cavity to fly in. C says what can be done.");
    return;
  }
  two_buttons(state.pending_actions, "Fly inside (C)", Action::enter_pulp, "Fly around (A)", Action::fly_outdoors);
  const auto lines = rideable(state.shown->flight->cavities.front().lines);
  if (lines.empty() || !widgets::section(interface, "Canals", widgets::AtFirst::folded)) return;
  canal_buttons(fly, lines);
  widgets::remark(interface,
                  "Choose one to be led along it; or double click it in the picture, where you see it through the "
                  "tooth or in a section.");
}

void fly_sections(FlyState& fly, ViewerState& state, const Interface& interface) {
  flight_section(fly, state, interface);
  ride_section(fly, state, interface);
  where_section(fly, state, interface);
  comfort_section(fly, state, interface);
}

}  // namespace odontoscope
