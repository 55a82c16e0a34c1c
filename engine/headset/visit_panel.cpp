// The panel and the menu button: fetched, put away, carried, pointed at; and what was asked for on it.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/headset/visit_steps.h"
#include "engine/navigate/section_handle.h"

namespace odontoscope {

namespace visit_steps {

namespace {

constexpr double true_size = 1;

/// Not behind a wall, if there is room before it.
RoomPanel fetched(const Visit& visit, const HeadsetInput& input, const VisitWorld& world, double side) {
  const RoomPanel usual = place_panel(input.head, side);
  if (!visit.cavity) return usual;
  constexpr double before_wall = 0.9;
  const glm::dvec3 way = direction_to_model(visit.stage, glm::normalize(usual.pose.position - input.head.position));
  const double free = world.cavities[*visit.cavity].walls.free_distance(visit.eye_mm, way) / mm_per_metre(visit.stage);
  return place_panel(input.head, side, std::isfinite(free) ? before_wall * free : panel_distance);
}

void on_short_press(Visit& visit, const HeadsetInput& input, const VisitWorld& world, std::size_t hand) {
  const bool seen = visit.panel && within_sight(*visit.panel, input.head);
  if (seen)
    visit.panel.reset();
  else
    visit.panel = fetched(visit, input, world, hand == 0 ? -1 : 1);
}

}  // namespace

void change_size(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  const glm::dvec3 facing = world.scene.camera.position - world.scene.camera.target;
  visit.stage =
      before(input.head, world.model, visit.stage.magnification == true_size ? usual_magnification : true_size, facing);
}

void use_menu(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
              double seconds) {
  for (std::size_t i = 0; i < 2; ++i) {
    double& held = visit.hands.menu_held[i];
    const bool down = input.hands[i].menu, was_down = visit.hands.before[i].menu;
    if (down && !was_down) held = 0;
    if (down && held >= 0) held += seconds;
    if (down && held >= rules.menu_seconds) {
      held = -1;
      if (visit.cavity)
        visit.way = Visit::Way{};
      else
        change_size(visit, input, world);
    }
    if (!down && was_down && held >= 0) on_short_press(visit, input, world, i);
  }
}

void point_at_panel(Visit& visit, const HeadsetInput& input) {
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    visit.hands.on_panel[i].reset();
    const std::optional<PanelPlace> aimed =
        visit.panel && hand.tracked ? aimed_at(*visit.panel, hand.aim) : std::nullopt;
    if (!aimed || !(visit.hands.pressing[i] ? hand.trigger >= released_below : true)) visit.hands.pressing[i] = false;
    if (!aimed || visit.hands.held[i] == Visit::Held::model) continue;
    if (aimed->on_it() && pulled(visit, input, i)) {
      visit.hands.pressing[i] = true;
      feel(visit, i, tap);
    }
    if (aimed->on_it() || visit.hands.pressing[i]) visit.hands.on_panel[i] = aimed;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    if (visit.hands.held[i] == Visit::Held::panel && (!visit.panel || !hand.tracked || hand.grab < released_below))
      visit.hands.held[i] = Visit::Held::nothing;
    if (visit.hands.held[i] == Visit::Held::panel)
      visit.panel = carried(*visit.panel, visit.hands.before[i].grip, hand.grip);
    else if (at_panel(visit, i) && hand.can_grab && visit.hands.before[i].tracked &&
             went_down(visit.hands.before[i].grab, hand.grab))
      visit.hands.held[i] = Visit::Held::panel;
  }
}

void perform(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  if (const auto line = std::exchange(visit.tour.asked, {}); line && !world.cavities.empty())
    visit.way = Visit::Way{visit.cavity.value_or(0), line};
  for (const VisitAction action : std::exchange(visit.pending_actions, {})) {
    switch (action) {
      case VisitAction::enter:
        if (!visit.cavity && !world.cavities.empty()) visit.way = Visit::Way{0};
        break;
      case VisitAction::leave:
        if (visit.cavity) visit.way = Visit::Way{};
        break;
      case VisitAction::change_size:
        if (!visit.cavity) change_size(visit, input, world);
        break;
      case VisitAction::toggle_section:
        toggle_section(visit.scene.section, visit.section_put_away,
                       with_offset({world.model.bounds_mm.centre(), AnatomicalFrame{}.buccal}, 0, world.model));
        break;
      case VisitAction::flip_section:
        if (visit.scene.section) visit.scene.section->normal = -visit.scene.section->normal;
        break;
      case VisitAction::forget_marks:
        visit.marks.ends.clear();
        visit.marks.named.reset();
        break;
      case VisitAction::show_dt:
        visit.chosen.db = false;
        break;
      case VisitAction::show_db:
        visit.chosen.db = true;  // what one method hides, the other must hide as well
        make_opaque(visit.scene);
        break;
      case VisitAction::tour_play:
        if (visit.tour.ride) play(*visit.tour.ride);
        break;
      case VisitAction::tour_back:
        if (visit.tour.ride) turn_round(*visit.tour.ride);
        break;
      case VisitAction::end_tour:
        visit.tour.ride.reset();
        break;
      case VisitAction::put_panel_away:
        visit.panel.reset();
        break;
      case VisitAction::leave_headset:
        visit.leaving = true;
        break;
    }
  }
}

}  // namespace visit_steps

std::optional<std::size_t> panel_hand(const Visit& visit) {
  for (const bool presses : {true, false})
    for (const std::size_t i : {1u, 0u})
      if (visit.hands.on_panel[i] && visit.hands.pressing[i] == presses) return i;
  return std::nullopt;
}

}  // namespace odontoscope
