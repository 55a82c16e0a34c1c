#pragma once
// An eye that flies between walls: values in, values out, the same path at any frame rate.
//
// The eye is the middle of a ball of radius `clearance` that never touches a wall. It cannot tunnel: every single step
// ends inside the ball round the eye that holds no wall, so the way there crosses none, however fast the flight and
// however long the frame.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/navigate/walls.h"
#include "engine/scene/camera.h"

namespace odontoscope {

struct FlightRules {
  double clearance = 0.03;                    // mm: the stated distance, never nearer to a wall
  double speed_per_distance = 2;              // 1/s: as fast as the nearest wall is far, times this
  double least_speed = 0.3, most_speed = 60;  // mm/s
  double speed_factor = 1;                    // what the person makes of it; a speed limit
  double settle_seconds = 0.12;               // in which a start or stop is two thirds done
  double turn_deg_per_second = 80;            // a key or stick held fully
  /// While it turns the eye rights itself so that this points up in the picture, as far as it looks across it; zero:
  /// never.
  glm::dvec3 upright{0, 0, 1};
};

/// Rules for a model of that radius: clearance and speeds as parts of it, since a file's unit may be anything.
FlightRules rules_for(double model_radius_mm);

struct Flight {
  glm::dvec3 eye{0};
  glm::dvec3 view_direction{0, 1, 0}, up{0, 0, 1};  // unit length, at right angles
  glm::dvec3 velocity{0};                           // mm/s
  glm::dvec2 turning{0};                            // rad/s: to the right, upwards
  friend bool operator==(const Flight&, const Flight&) = default;
};

/// What is held down: each from -1 to 1.
struct FlightWish {
  glm::dvec3 move{0};  // right, up, ahead, as the picture has them
  glm::dvec2 turn{0};  // right, up
};

/// An eye that looks along `view_direction`, its picture's up as near to `up` as that allows.
Flight looking(const glm::dvec3& eye, const glm::dvec3& view_direction, const glm::dvec3& up = {0, 0, 1});

/// The hand's turn, at once: radians to the right and upwards. Where the eye looks along or against `upright` nothing
/// rolls.
Flight turned(const Flight& flight, const glm::dvec2& angles, const FlightRules& rules);

/// `seconds` later. Preconditions: finite; the eye at least `clearance` from every wall, and then it is so afterwards.
Flight flight_after(const Flight& flight, const FlightWish& wish, const Walls& walls, const FlightRules& rules,
                    double seconds);

/// The ball's middle after it went `by`, sliding along walls. Precondition as above.
glm::dvec3 slide_along_walls(const glm::dvec3& eye, const glm::dvec3& by, const Walls& walls, double clearance);

/// At rest, or so slow that nobody sees it.
bool resting(const Flight& flight, const FlightRules& rules);

/// What the eye sees; its target lies `ahead_mm` ahead.
Camera camera_of(const Flight& flight, double field_of_view_deg, double ahead_mm);

/// The farthest near plane whose corners stay within the ball that holds no wall. `aspect` is width over height.
double safe_near_mm(double clearance_mm, double field_of_view_deg, double aspect);

}  // namespace odontoscope
