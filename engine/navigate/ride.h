#pragma once
// A ride along a centre line: where it leads, how the eye stands there, and where an eye that flies freely is in terms
// of the lines.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "engine/navigate/flight.h"
#include "recon/cavity/centre_lines.h"

namespace odontoscope {

/// Those that one can ride: canals, then horns, then the other branches.
std::vector<const CentreLine*> rideable(const CentreLines& lines);
/// Where along a line the chamber ends: at its orifice; what leaves the chamber without one, a horn, begins where the
/// chamber's ball ends. 0 without a chamber and an orifice.
double begins_at(const CentreLines& lines, const CentreLine& line);

/// The part of a line's tour (see tour.h) that the flying ball fits through, as a table that can be entered by time and
/// by length.
struct Track {
  struct Point {
    glm::dvec3 at{0}, view_direction{0}, up{0};
    double radius = 0, along = 0;  // clearance; mm from the line's start
    double seconds = 0;            // of the tour at usual speed
  };
  std::vector<Point> points;  // at least two, or none: nowhere wide enough
  double orifice = 0;         // along, where the canal leaves the chamber; 0: it does not
  double end = 0;             // along, where the line meets the wall
};
Track track_of(const CentreLine& line, double clearance);

/// Between the points, in proportion; `along` is held to the track. Precondition: it has points.
Track::Point place_on(const Track& track, double along);
Flight flight_on(const Track& track, double along);

/// How far a ride came.
struct Ride {
  std::size_t line = 0;  // of rideable()
  Track track;
  double along = 0;  // mm
  double pace = 0;   // seconds of the tour a second: 1 usual, negative back
  bool playing = false, back = false;
  glm::dvec2 look{0};  // turned away from the line's direction by hand: radians to the right and upwards
};
/// The other way, at once.
inline void turn_round(Ride& ride) {
  ride.back = !ride.back;
  ride.playing = true;
}
/// `seconds` later; it stops gently, and at the track's ends.
void advance(Ride& ride, const FlightRules& rules, double seconds);
/// The eye on it, turned as the hand wants.
Flight flight_of(const Ride& ride, const FlightRules& rules);

/// Where a place is, told by the nearest line.
struct CanalPlace {
  std::size_t line = 0;  // of rideable()
  double along = 0;      // mm
  double depth = 0;      // past the orifice; negative: still in the chamber
  double width = 0;      // across the void there: twice the line's clearance
  double to_end = 0;     // along the line to where it meets the wall
  double off = 0;        // from the line
};
std::optional<CanalPlace> canal_place(const CentreLines& lines, const glm::dvec3& place);

}  // namespace odontoscope
