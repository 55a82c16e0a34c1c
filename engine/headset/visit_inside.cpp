// Inside a cavity: gliding, and walls that neither hand nor head gets through.

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
    const bool glides = visit.tool == HandTool::look && !at_panel(visit, i);
    way += (glides ? hand.trigger : 0) * hand.aim.ahead() + along(hand) * input.head.ahead();
    const bool strafes = i == 0 && std::abs(hand.stick.x) > stick_at_rest;   // the right stick turns
    if (strafes) way += hand.stick.x * (input.head.turn * glm::dvec3(1, 0, 0));
  }
  const double length = glm::length(way);
  return length > 1 ? way / length : way;
}

/// By triggers and sticks, and as the head itself goes.
void glide(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  const FlightSpace& cavity = world.cavities[*visit.cavity];
  const FlightRules flight_limits = flight_rules(visit.stage, rules);
  // Where the head itself went. A wall that it would go through is pushed along instead.
  const glm::dvec3 head_mm = to_model(visit.stage, input.head.position);
  Flight flight;
  flight.eye = slid(visit.eye_mm, head_mm - visit.eye_mm, cavity.walls, flight_limits.clearance);
  flight.sight = direction_to_model(visit.stage, input.head.ahead());
  flight.up = direction_to_model(visit.stage, input.head.up());
  flight.velocity = visit.velocity;
  const glm::dvec3 way = glm::conjugate(input.head.turn) * wanted_way(visit, input);
  flight = flown(flight, {.move = {way.x, way.y, -way.z}, .turn = {}}, cavity.walls, flight_limits, seconds);
  visit.eye_mm = flight.eye;
  visit.velocity = flight.velocity;
  visit.stage = moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));
}

}  // namespace

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

void step_inside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  if (visit.tour) step_tour(visit, input, rules, seconds);
  else glide(visit, input, world, rules, seconds);
  if (const int snap = snap_of(visit.before[1], input.hands[1]); snap != 0)
    visit.stage = turned_about(visit.stage, input.head.position, snap * glm::radians(rules.snap_turn_deg));
  point_at_model(visit, input, world);
  for (std::size_t i = 0; i < 2; ++i)
    if (visit.tool == HandTool::distance && !at_panel(visit, i) && pulled(visit, input, i)) use_tool(visit, i);
}

}  // namespace odontoscope::visit_steps
