#include "engine/navigate/flight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

/// Longer times are flown in shares of this, so that speed follows the walls.
constexpr double longest_tick = 1.0 / 120;
/// Of the free ball's radius, what one step uses: the rest is room to be pushed back from a wall without leaving the
/// ball.
constexpr double step_share = 0.5;
/// Beyond the clearance, by so much of it: a push ends here, so that the next step begins free.
constexpr double skin = 1e-3;

glm::dvec3 about(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  return portable::cos(angle) * v + portable::sin(angle) * glm::cross(axis, v) +
         (1 - portable::cos(angle)) * glm::dot(axis, v) * axis;
}

/// Unit length and at right angles again: rounding must not add up over hours.
Flight squared_up(Flight flight) {
  flight.view_direction = glm::normalize(flight.view_direction);
  flight.up = glm::normalize(flight.up - glm::dot(flight.up, flight.view_direction) * flight.view_direction);
  return flight;
}

/// Rolls towards upright by at most `most` radians.
Flight righted(Flight flight, const glm::dvec3& upright, double most) {
  if (upright == glm::dvec3(0)) return flight;
  const glm::dvec3 wanted = upright - glm::dot(upright, flight.view_direction) * flight.view_direction;
  const double across = glm::length(wanted);  // 0: along or against upright, where every roll is as good
  constexpr double least = 1e-3;
  if (across < least) return flight;
  const double angle =
      portable::atan2(glm::dot(glm::cross(flight.up, wanted), flight.view_direction), glm::dot(flight.up, wanted));
  flight.up = about(flight.up, flight.view_direction, std::clamp(angle, -most * across, most * across));
  return flight;
}

/// Pushed off the walls to the clearance if that takes no more than `room` in all; otherwise nothing.
std::optional<glm::dvec3> pushed_off(glm::dvec3 place, const glm::dvec3& from, double room, const Walls& walls,
                                     double clearance) {
  constexpr int tries = 6;
  for (int i = 0; i < tries; ++i) {
    const Walls::Nearest wall = walls.nearest(place, clearance);
    if (!(wall.distance < clearance)) return place;
    if (wall.distance <= 0) return std::nullopt;
    place = wall.point + (clearance * (1 + skin) / wall.distance) * (place - wall.point);
    if (!(glm::length(place - from) < room)) return std::nullopt;
  }
  return std::nullopt;
}

Flight ticked(Flight flight, const FlightWish& wish, const Walls& walls, const FlightRules& rules, double seconds) {
  const double share = 1 - portable::exp(-seconds / rules.settle_seconds);
  const glm::dvec2 aim = glm::radians(rules.turn_deg_per_second) * glm::clamp(wish.turn, -1.0, 1.0);
  const glm::dvec2 angles = seconds * aim + rules.settle_seconds * share * (flight.turning - aim);
  flight.turning += share * (aim - flight.turning);
  if (angles != glm::dvec2(0)) flight = turned(flight, angles, rules);

  glm::dvec3 move = glm::clamp(wish.move, -1.0, 1.0);
  if (const double length = glm::length(move); length > 1) move /= length;
  const double far = walls.nearest(flight.eye).distance;
  const double speed =
      rules.speed_factor * std::clamp(rules.speed_per_distance * (std::isfinite(far) ? far : rules.most_speed),
                                      rules.least_speed, rules.most_speed);
  const glm::dvec3 wanted = speed * (move.x * glm::cross(flight.view_direction, flight.up) + move.y * flight.up +
                                     move.z * flight.view_direction);
  const glm::dvec3 by = seconds * wanted + rules.settle_seconds * share * (flight.velocity - wanted);
  flight.velocity += share * (wanted - flight.velocity);
  const glm::dvec3 to = slide_along_walls(flight.eye, by, walls, rules.clearance);
  // What the wall took is gone: no speed is stored up against it.
  const glm::dvec3 lost = by - (to - flight.eye);
  if (const double length = glm::length(lost); length > 1e-6 * glm::length(by)) {
    const glm::dvec3 against = lost / length;
    flight.velocity -= std::max(0.0, glm::dot(flight.velocity, against)) * against;
  }
  flight.eye = to;
  return flight;
}

}  // namespace

FlightRules rules_for(double model_radius_mm) {
  FlightRules rules;
  rules.clearance = 0.0025 * model_radius_mm;
  rules.least_speed = 0.03 * model_radius_mm;
  rules.most_speed = 3 * model_radius_mm;
  return rules;
}

Flight looking(const glm::dvec3& eye, const glm::dvec3& view_direction, const glm::dvec3& up) {
  Flight flight;
  flight.eye = eye;
  flight.view_direction = glm::normalize(view_direction);
  constexpr double least_sine = 0.05;
  glm::dvec3 upwards = up;
  if (glm::length(glm::cross(glm::normalize(up), flight.view_direction)) < least_sine) {
    const AnatomicalFrame tooth;
    upwards = std::abs(glm::dot(tooth.buccal, flight.view_direction)) < 0.9 ? tooth.buccal : tooth.occlusal;
  }
  flight.up = upwards;
  return squared_up(flight);
}

Flight turned(const Flight& flight, const glm::dvec2& angles, const FlightRules& rules) {
  Flight after = flight;
  after.view_direction = about(after.view_direction, after.up, -angles.x);
  const glm::dvec3 right = glm::normalize(glm::cross(after.view_direction, after.up));
  after.view_direction = about(after.view_direction, right, angles.y);
  after.up = about(after.up, right, angles.y);
  return squared_up(righted(squared_up(after), rules.upright, glm::length(angles)));
}

Flight flight_after(const Flight& flight, const FlightWish& wish, const Walls& walls, const FlightRules& rules,
                    double seconds) {
  if (!(seconds > 0)) return flight;
  const int ticks = std::max(1, static_cast<int>(std::ceil(std::min(seconds, 10.0) / longest_tick - 1e-9)));
  Flight after = flight;
  for (int i = 0; i < ticks; ++i) after = ticked(after, wish, walls, rules, std::min(seconds, 10.0) / ticks);
  return after;
}

glm::dvec3 slide_along_walls(const glm::dvec3& eye, const glm::dvec3& by, const Walls& walls, double clearance) {
  glm::dvec3 place = eye, left = by;
  constexpr int most_steps = 64;
  for (int step = 0; step < most_steps; ++step) {
    const double length = glm::length(left);
    if (!(length > 0)) break;
    const Walls::Nearest wall = walls.nearest(place);
    const double free = wall.distance;
    if (free - clearance >= length) return place + left;  // all of it within the ball that holds no wall
    if (!(free > 0)) break;
    // Half the free ball at once, then pushed back off what it came too near to. What does not come right is tried
    // shorter.
    std::optional<glm::dvec3> next;
    double went = 0;
    for (double share = step_share; !next && share > 0.01; share *= 0.25) {
      went = std::min(length, share * free);
      next = pushed_off(place + (went / length) * left, place, free, walls, clearance);
    }
    if (!next) break;
    place = *next;
    left -= (went / length) * left;
  }
  return place;
}

bool resting(const Flight& flight, const FlightRules& rules) {
  return glm::length(flight.velocity) < 1e-3 * rules.least_speed && glm::length(flight.turning) < 1e-4;
}

Camera camera_of(const Flight& flight, double field_of_view_deg, double ahead_mm) {
  Camera camera;
  camera.position = flight.eye;
  camera.target = flight.eye + ahead_mm * flight.view_direction;
  camera.up = flight.up;
  camera.field_of_view_deg = field_of_view_deg;
  return camera;
}

double safe_near_mm(double clearance_mm, double field_of_view_deg, double aspect) {
  const double slope = portable::tan(glm::radians(field_of_view_deg) / 2);
  constexpr double room = 0.95;  // for depths in single precision
  return room * clearance_mm / std::sqrt(1 + slope * slope * (1 + aspect * aspect));
}

}  // namespace odontoscope
