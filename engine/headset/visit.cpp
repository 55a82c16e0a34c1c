#include "engine/headset/visit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/navigate/flight.h"

namespace odontoscope {

namespace {

/// Buttons that give numbers: pressed above the first, released below the second, so that a tremor is no second press.
constexpr double pressed_above = 0.6, released_below = 0.4;
constexpr double stick_at_rest = 0.15;
constexpr double true_size = 1;

bool went_down(double before, double now) { return before <= pressed_above && now > pressed_above; }

/// What lies under a hand's ray, as it is seen: opaque, not cut away.
std::optional<Hit> pointed_at(const Visit& visit, const HandInput& hand, const VisitWorld& world) {
  if (!hand.tracked) return std::nullopt;
  const Ray ray{to_model(visit.stage, hand.aim.position), direction_to_model(visit.stage, hand.aim.ahead())};
  return pick(world.pickable, world.scene, ray, {.least_opacity = 1});
}

/// The cavity whose wall, or the body that fills it, was hit. In the sample teeth the void is the dentine's, and a pulp of its own fills it, whose
/// horns and tips reach beyond the void by a fraction of a slice.
std::optional<std::size_t> cavity_of(const Hit& hit, const VisitWorld& world) {
  constexpr double rounded = 1e-4, of_a_slice = 0.03;   // of the model's radius
  for (std::size_t i = 0; i < world.cavities.size(); ++i) {
    const FlightSpace& cavity = world.cavities[i];
    const double near = (hit.structure == cavity.structure ? rounded : of_a_slice) * world.model.radius_mm;
    if (cavity.walls.locate(hit.point_mm) != Walls::Side::outside || cavity.walls.nearest(hit.point_mm, near).distance < near) return i;
  }
  return std::nullopt;
}


/// The side that the window's camera looks at is the side towards the person.
glm::dvec3 facing(const Camera& camera) { return camera.position - camera.target; }

glm::dvec3 centre_of(const Visit& visit, const VisitWorld& world) { return to_room(visit.stage, world.model.bounds_mm.centre()); }

/// Holds or lets go, by what the hand's buttons say now.
Visit::Held held_outside(Visit::Held held, const HandInput& before, const HandInput& hand, bool trigger_is_taken) {
  if (!hand.tracked) return Visit::Held::nothing;
  const double button = hand.can_grab ? hand.grab : hand.trigger, was = hand.can_grab ? before.grab : before.trigger;
  if (held == Visit::Held::model) return button < released_below ? Visit::Held::nothing : held;
  if (!hand.can_grab && trigger_is_taken) return Visit::Held::nothing;
  return went_down(was, button) && before.tracked ? Visit::Held::model : Visit::Held::nothing;
}

void carry(Visit& visit, const HeadsetInput& input) {
  const auto holds = [&](std::size_t i) { return visit.held[i] == Visit::Held::model; };
  if (holds(0) && holds(1)) {
    visit.stage = carried(visit.stage, {visit.before[0].grip.position, visit.before[1].grip.position}, {input.hands[0].grip.position, input.hands[1].grip.position});
    return;
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (holds(i)) visit.stage = carried(visit.stage, visit.before[i].grip, input.hands[i].grip);
}

/// +1 or -1 in the moment in which the stick is pushed to a side.
int snap_of(const HandInput& before, const HandInput& hand) {
  if (std::abs(hand.stick.x) <= pressed_above || std::abs(before.stick.x) > pressed_above) return 0;
  return hand.stick.x > 0 ? 1 : -1;
}

double along(const HandInput& hand) { return std::abs(hand.stick.y) > stick_at_rest ? hand.stick.y : 0; }

/// The sticks outside: turn the tooth by steps, push it away or bring it nearer.
void turn_and_bring(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  constexpr double nearest = 0.25, farthest = 4;   // metres from the head to the model's middle
  for (std::size_t i = 0; i < 2; ++i) {
    const int snap = snap_of(visit.before[i], input.hands[i]);
    if (snap != 0) visit.stage = turned_about(visit.stage, centre_of(visit, world), snap * glm::radians(rules.snap_turn_deg));
    const glm::dvec3 away = centre_of(visit, world) - input.head.position;
    const double apart = glm::length(away);
    if (along(input.hands[i]) == 0 || !(apart > 0)) continue;
    const double wanted = apart + seconds * rules.most_speed * along(input.hands[i]);
    // Carried nearer or farther by hand it stays there until the stick brings it back.
    const double to = along(input.hands[i]) > 0 ? std::max(apart, std::min(wanted, farthest)) : std::min(apart, std::max(wanted, nearest));
    visit.stage = moved(visit.stage, (to / apart - 1) * away);
  }
}

void step_outside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput &hand = input.hands[i], &before = visit.before[i];
    visit.pointed[i] = pointed_at(visit, hand, world);
    const std::optional<std::size_t> cavity = visit.pointed[i] ? cavity_of(*visit.pointed[i], world) : std::nullopt;
    visit.held[i] = held_outside(visit.held[i], before, hand, cavity.has_value());
    if (cavity && before.tracked && went_down(before.trigger, hand.trigger)) visit.way = Visit::Way{cavity};
    if (hand.menu && !before.menu) visit.stage = odontoscope::before(input.head, world.model, visit.stage.magnification == true_size ? usual_magnification : true_size, facing(world.scene.camera));
  }
  carry(visit, input);
  turn_and_bring(visit, input, world, rules, seconds);
}

FlightRules flight_rules(const Stage& stage, const ComfortRules& rules) {
  const double mm = mm_per_metre(stage);
  FlightRules flight;
  flight.clearance = rules.clearance * mm;
  flight.speed_per_distance = rules.speed_per_distance;
  flight.least_speed = 0.1 * rules.most_speed * mm;
  flight.most_speed = rules.most_speed * mm;
  flight.upright = glm::dvec3(0);   // the head rights itself
  return flight;
}

/// Where to, in the room, from 0 to 1 fast: where the hands point by the triggers, where the head looks by the sticks.
glm::dvec3 wanted_way(const HeadsetInput& input) {
  glm::dvec3 way(0);
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    if (!hand.tracked) continue;
    way += hand.trigger * hand.aim.ahead() + along(hand) * input.head.ahead();
    const bool strafes = i == 0 && std::abs(hand.stick.x) > stick_at_rest;   // the right stick turns
    if (strafes) way += hand.stick.x * (input.head.turn * glm::dvec3(1, 0, 0));
  }
  const double length = glm::length(way);
  return length > 1 ? way / length : way;
}

void step_inside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  for (std::size_t i = 0; i < 2; ++i)
    if (input.hands[i].menu && !visit.before[i].menu) visit.way = Visit::Way{};
  const FlightSpace& cavity = world.cavities[*visit.cavity];
  const FlightRules flight_limits = flight_rules(visit.stage, rules);
  // Where the head itself went. A wall that it would go through is pushed along instead.
  const glm::dvec3 head_mm = to_model(visit.stage, input.head.position);
  Flight flight;
  flight.eye = slid(visit.eye_mm, head_mm - visit.eye_mm, cavity.walls, flight_limits.clearance);
  flight.sight = direction_to_model(visit.stage, input.head.ahead());
  flight.up = direction_to_model(visit.stage, input.head.up());
  flight.velocity = visit.velocity;
  const glm::dvec3 way = glm::conjugate(input.head.turn) * wanted_way(input);
  flight = flown(flight, {.move = {way.x, way.y, -way.z}, .turn = {}}, cavity.walls, flight_limits, seconds);
  visit.eye_mm = flight.eye;
  visit.velocity = flight.velocity;
  visit.stage = moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));
  if (const int snap = snap_of(visit.before[1], input.hands[1]); snap != 0)
    visit.stage = turned_about(visit.stage, input.head.position, snap * glm::radians(rules.snap_turn_deg));
}

/// In the dark.
void go(Visit& visit, const Visit::Way& way, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules) {
  if (way.into) {
    visit.stage_outside = visit.stage;
    visit.stage = inside(world.cavities[*way.into], input.head, world.model, rules);
    visit.eye_mm = world.cavities[*way.into].middle;
  } else {
    visit.stage = visit.stage_outside;
  }
  visit.cavity = way.into;
  visit.velocity = glm::dvec3(0);
  visit.held = {};
  visit.pointed = {};
}

void fade(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  const double share = seconds / rules.fade_seconds;
  visit.dark = std::clamp(visit.dark + (visit.way ? share : -share), 0.0, 1.0);
  if (!visit.way || visit.dark < 1) return;
  go(visit, *visit.way, input, world, rules);
  visit.way.reset();
}

}  // namespace

Stage inside(const FlightSpace& cavity, const Pose& head, const Model& model, const ComfortRules& rules) {
  const Stage stage = before(head, model, rules.roomy / (metres_per_mm * cavity.room_mm));
  return moved(stage, head.position - to_room(stage, cavity.middle));
}

Visit stepped(const Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  Visit after = visit;
  if (!input.head_tracked) return after;
  if (!after.placed || (input.recentred && !after.cavity)) {
    after.stage = before(input.head, world.model, after.placed ? after.stage.magnification : usual_magnification, facing(world.scene.camera));
    after.placed = true;
  }
  if (input.recentred && after.cavity) after.stage = moved(after.stage, input.head.position - to_room(after.stage, after.eye_mm));   // only the numbers changed
  if (!input.focused) {   // what was held is let go; nothing jumps when the focus comes back
    after.held = {};
    after.before = {};
    after.pointed = {};
    after.velocity = glm::dvec3(0);
    return after;
  }
  fade(after, input, world, rules, seconds);
  if (!after.way) {
    if (after.cavity) step_inside(after, input, world, rules, seconds);
    else step_outside(after, input, world, rules, seconds);
  }
  constexpr double told_for = 3;
  if (!after.cavity && after.stage.magnification != visit.stage.magnification) after.told = told_for;
  else after.told = std::max(0.0, after.told - seconds);
  const double speed = after.cavity ? glm::length(after.velocity) / mm_per_metre(after.stage) / rules.most_speed : 0;
  const double share = 1 - std::exp(-seconds / rules.vignette_seconds);
  after.vignette += share * (std::min(speed, 1.0) - after.vignette);
  after.before = input.hands;
  return after;
}

}  // namespace odontoscope
