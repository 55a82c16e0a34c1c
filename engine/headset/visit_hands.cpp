// Outside: the tooth carried, turned, scaled and pointed at by hands.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/section_frame.h"
#include "engine/headset/visit_steps.h"

namespace odontoscope::visit_steps {

namespace {

/// The cavity whose wall, or the body that fills it, was hit. In the sample teeth the void is the dentine's, and a pulp
/// of its own fills it, whose horns and tips reach beyond the void by a fraction of a slice.
std::optional<std::size_t> cavity_of(const Hit& hit, const VisitWorld& world) {
  constexpr double rounded = 1e-4, of_a_slice = 0.03;  // of the model's radius
  for (std::size_t i = 0; i < world.cavities.size(); ++i) {
    const FlightSpace& cavity = world.cavities[i];
    const double near = (hit.structure == cavity.structure ? rounded : of_a_slice) * world.model.radius_mm;
    if (cavity.walls.locate(hit.point_mm) != Walls::Side::outside ||
        cavity.walls.nearest(hit.point_mm, near).distance < near)
      return i;
  }
  return std::nullopt;
}

glm::dvec3 centre_of(const Visit& visit, const VisitWorld& world) {
  return to_room(visit.stage, world.model.bounds_mm.centre());
}

/// Holds or lets go, by what the hand's buttons say now.
Visit::Held held_outside(Visit::Held held, const HandInput& before, const HandInput& hand, bool trigger_is_taken,
                         bool means_section) {
  if (held == Visit::Held::panel) return held;
  if (!hand.tracked) return Visit::Held::nothing;
  const double button = hand.can_grab ? hand.grab : hand.trigger, was = hand.can_grab ? before.grab : before.trigger;
  if (held != Visit::Held::nothing) return button < released_below ? Visit::Held::nothing : held;
  if (!hand.can_grab && trigger_is_taken) return Visit::Held::nothing;
  if (!went_down(was, button) || !before.tracked) return Visit::Held::nothing;
  return means_section ? Visit::Held::section : Visit::Held::model;
}

/// The frame is meant before the tooth behind it; a hand that holds it means the place that it holds.
void point_at_frame(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    visit.hands.on_frame[i].reset();
    if (visit.scene.section && hand.tracked && !at_panel(visit, i) && visit.hands.held[i] != Visit::Held::model)
      visit.hands.on_frame[i] =
          meant(section_frame(*visit.scene.section, visit.stage, world.model), hand.grip, hand.aim);
    if (visit.hands.on_frame[i] || visit.hands.held[i] == Visit::Held::section) visit.hands.pointed[i].reset();
    if (visit.hands.held[i] == Visit::Held::section && !visit.scene.section) visit.hands.held[i] = Visit::Held::nothing;
  }
}

void carry(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  for (std::size_t i = 0; i < 2; ++i)
    if (visit.hands.held[i] == Visit::Held::section)
      visit.scene.section =
          carried(*visit.scene.section, visit.stage, visit.hands.before[i].grip, input.hands[i].grip, world.model);
  const auto holds = [&](std::size_t i) { return visit.hands.held[i] == Visit::Held::model; };
  if (holds(0) && holds(1)) {
    visit.stage = carried(visit.stage, {visit.hands.before[0].grip.position, visit.hands.before[1].grip.position},
                          {input.hands[0].grip.position, input.hands[1].grip.position});
    return;
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (holds(i)) visit.stage = carried(visit.stage, visit.hands.before[i].grip, input.hands[i].grip);
}

/// The sticks outside: turn the tooth by steps, push it away or bring it nearer.
void turn_and_bring(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                    double seconds) {
  constexpr double nearest = 0.25, farthest = 4;  // metres from the head to the model's middle
  for (std::size_t i = 0; i < 2; ++i) {
    const int snap = snap_of(visit.hands.before[i], input.hands[i]);
    if (snap != 0)
      visit.stage = turned_about(visit.stage, centre_of(visit, world), snap * glm::radians(rules.snap_turn_deg));
    const glm::dvec3 away = centre_of(visit, world) - input.head.position;
    const double apart = glm::length(away);
    if (along(input.hands[i]) == 0 || !(apart > 0)) continue;
    const double wanted = apart + seconds * rules.most_speed * along(input.hands[i]);
    // Carried nearer or farther by hand it stays there until the stick brings it back.
    const double to = along(input.hands[i]) > 0 ? std::max(apart, std::min(wanted, farthest))
                                                : std::min(apart, std::max(wanted, nearest));
    visit.stage = moved(visit.stage, (to / apart - 1) * away);
  }
}

}  // namespace

int snap_of(const HandInput& before, const HandInput& hand) {
  if (std::abs(hand.stick.x) <= pressed_above || std::abs(before.stick.x) > pressed_above) return 0;
  return hand.stick.x > 0 ? 1 : -1;
}

double along(const HandInput& hand) { return std::abs(hand.stick.y) > stick_at_rest ? hand.stick.y : 0; }

void point_at_model(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  constexpr float faintest = 0.05f;
  const Scene scene = scene_of(visit, world);
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    visit.hands.pointed[i].reset();
    if (!hand.tracked || at_panel(visit, i)) continue;
    const Ray ray{to_model(visit.stage, hand.aim.position), direction_to_model(visit.stage, hand.aim.ahead())};
    visit.hands.pointed[i] = pick(world.pickable, scene, ray, {.least_opacity = 1});
    if (!visit.hands.pointed[i]) visit.hands.pointed[i] = pick(world.pickable, scene, ray, {.least_opacity = faintest});
  }
}

bool use_tool(Visit& visit, std::size_t hand) {
  const std::optional<Hit>& hit = visit.hands.pointed[hand];
  if (!hit) return false;
  if (visit.chosen.tool == HandTool::distance) {
    if (visit.marks.ends.size() == 2) visit.marks.ends.clear();
    visit.marks.ends.push_back(*hit);
  } else {
    visit.marks.named = hit;
  }
  return true;
}

void step_outside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                  double seconds) {
  point_at_model(visit, input, world);
  point_at_frame(visit, input, world);
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput &hand = input.hands[i], &before = visit.hands.before[i];
    const bool looks = visit.chosen.tool == HandTool::look && visit.hands.pointed[i];
    const std::optional<std::size_t> cavity = looks ? cavity_of(*visit.hands.pointed[i], world) : std::nullopt;
    const bool taken =
        at_panel(visit, i) || cavity || (visit.chosen.tool == HandTool::distance && visit.hands.pointed[i]);
    visit.hands.held[i] = held_outside(visit.hands.held[i], before, hand, taken, visit.hands.on_frame[i].has_value());
    if (at_panel(visit, i) || !pulled(visit, input, i)) continue;
    const bool did = cavity || use_tool(visit, i);
    if (cavity) visit.way = Visit::Way{cavity};
    if (did) feel(visit, i, tap);
  }
  carry(visit, input, world);
  turn_and_bring(visit, input, world, rules, seconds);
}

}  // namespace odontoscope::visit_steps
