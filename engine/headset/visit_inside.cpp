// Inside a cavity: gliding, and walls that neither hand nor head gets through.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/visit_steps.h"

namespace odontoscope::visit_steps {

namespace {

/// Where to, in the room, from 0 to 1 fast: where the hands point by the triggers, where the head looks by the sticks.
glm::dvec3 wanted_way(const Visit& visit, const HeadsetInput& input) {
  glm::dvec3 way(0);
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    if (!hand.tracked) continue;
    if (visit.chosen.travel != Travel::glide) continue;
    const bool glides = visit.chosen.tool == HandTool::look && !at_panel(visit, i);
    way += (glides ? hand.trigger : 0) * hand.aim.ahead() + along(hand) * input.head.ahead();
    const bool strafes = i == 0 && std::abs(hand.stick.x) > stick_at_rest;  // the right stick turns
    if (strafes) way += hand.stick.x * (input.head.turn * glm::dvec3(1, 0, 0));
  }
  const double length = glm::length(way);
  return length > 1 ? way / length : way;
}

/// By triggers and sticks, and as the head itself goes.
void glide(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
           double seconds) {
  const FlightSpace& cavity = world.cavities[*visit.cavity];
  const FlightRules flight_limits = flight_rules(visit.stage, rules);
  // Where the head itself went. A wall that it would go through is pushed along instead.
  const glm::dvec3 head_mm = to_model(visit.stage, input.head.position);
  Flight flight;
  flight.eye = slide_along_walls(visit.eye_mm, head_mm - visit.eye_mm, cavity.walls, flight_limits.clearance);
  flight.view_direction = direction_to_model(visit.stage, input.head.ahead());
  flight.up = direction_to_model(visit.stage, input.head.up());
  flight.velocity = visit.velocity;
  const glm::dvec3 way = glm::conjugate(input.head.turn) * wanted_way(visit, input);
  flight = flight_after(flight, {.move = {way.x, way.y, -way.z}, .turn = {}}, cavity.walls, flight_limits, seconds);
  visit.eye_mm = flight.eye;
  visit.velocity = flight.velocity;
  visit.stage = moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));
}

/// A wall is felt when it is met, and again only after it was left.
void feel_wall(Visit& visit, const HeadsetInput& input, const FlightSpace& cavity, double clearance) {
  constexpr double meets = 1.05, leaves = 1.3;  // clearances
  const double near = cavity.walls.nearest(visit.eye_mm, leaves * clearance).distance;
  if (!visit.at_wall && near < meets * clearance) {
    visit.at_wall = true;
    for (std::size_t i = 0; i < 2; ++i)
      if (input.hands[i].tracked) feel(visit, i, knock);
  } else if (!(near < leaves * clearance)) {
    visit.at_wall = false;
  }
}

/// A held trigger shows where it would lead, along a way that is free and straight; letting it go leads there.
void leap(Visit& visit, const HeadsetInput& input, const FlightSpace& cavity, double clearance) {
  constexpr double
      share = 0.85,
      least = 0.5;  // of the way to the wall, so that it is not before one's nose; clearances that are worth it
  for (std::size_t i = 0; i < 2; ++i) {
    const HandInput& hand = input.hands[i];
    const bool may = visit.chosen.travel == Travel::leap && visit.chosen.tool == HandTool::look && hand.tracked &&
                     !at_panel(visit, i);
    const bool let_go = visit.hands.leap_mm[i] && hand.trigger < released_below;
    const bool is_away =
        visit.hands.leap_mm[i] && glm::length(*visit.hands.leap_mm[i] - visit.eye_mm) > 0.5 * least * clearance;
    if (may && let_go && is_away && !visit.way) {
      visit.way = Visit::Way{visit.cavity, {}, visit.hands.leap_mm[i]};
      feel(visit, i, tap);
    }
    const bool aims = may && (visit.hands.leap_mm[i] ? !let_go : pulled(visit, input, i));
    visit.hands.leap_mm[i].reset();
    if (!aims || !visit.hands.pointed[i]) continue;
    const glm::dvec3 way = visit.hands.pointed[i]->point_mm - visit.eye_mm;
    const double length = glm::length(way);
    if (!(length > 0)) continue;
    const double free = share * free_way(cavity.walls, visit.eye_mm, way / length, length, clearance);
    visit.hands.leap_mm[i] = visit.eye_mm + std::max(free, 0.0) * way / length;
    if (free < least * clearance) visit.hands.leap_mm[i] = visit.eye_mm;  // shown as nowhere to go, and it stays aimed
  }
}

}  // namespace

double free_way(const Walls& walls, const glm::dvec3& from, const glm::dvec3& direction, double most,
                double clearance) {
  constexpr int most_steps = 200;
  constexpr double skin = 1e-3;  // clearances
  double went = 0;
  // Every step ends inside a ball that holds no wall, with the eye's own ball in it.
  for (int i = 0; i < most_steps && went < most; ++i) {
    const double step = walls.nearest(from + went * direction).distance - clearance;
    if (step < skin * clearance) break;
    went = std::min(most, went + step);
  }
  return went;
}

FlightRules flight_rules(const Stage& stage, const ComfortRules& rules) {
  const double mm = mm_per_metre(stage);
  FlightRules flight;
  flight.clearance = rules.clearance * mm;
  flight.speed_per_distance = rules.speed_per_distance;
  flight.least_speed = 0.1 * rules.most_speed * mm;
  flight.most_speed = rules.most_speed * mm;
  flight.upright = glm::dvec3(0);  // the head rights itself
  return flight;
}

void step_inside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                 double seconds) {
  if (visit.tour.ride)
    step_tour(visit, input, rules, seconds);
  else
    glide(visit, input, world, rules, seconds);
  const FlightSpace& cavity = world.cavities[*visit.cavity];
  const double clearance = rules.clearance * mm_per_metre(visit.stage);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool turns =
        i == 1 || visit.tour.ride || visit.chosen.travel == Travel::leap;  // else the left one goes sideways
    if (const int snap = snap_of(visit.hands.before[i], input.hands[i]); turns && snap != 0)
      visit.stage = turned_about(visit.stage, input.head.position, snap * glm::radians(rules.snap_turn_deg));
  }
  feel_wall(visit, input, cavity, clearance);
  point_at_model(visit, input, world);
  if (!visit.tour.ride) leap(visit, input, cavity, clearance);
  for (std::size_t i = 0; i < 2; ++i)
    if (visit.chosen.tool == HandTool::distance && !at_panel(visit, i) && pulled(visit, input, i) && use_tool(visit, i))
      feel(visit, i, tap);
}

}  // namespace odontoscope::visit_steps
