// A tour along a canal: the place moves as a ride of navigate/ride.h does, and the view is turned by nobody but the
// head.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/visit_steps.h"
#include "engine/scene/glm_vector.h"

namespace odontoscope::visit_steps {

namespace {

/// The canal's usual clearance: half of its points have more.
double usual_radius(const CentreLine& line) {
  std::vector<double> radii;
  for (std::size_t i = std::min(line.orifice, line.points.size() - 2); i < line.points.size(); ++i)
    radii.push_back(line.points[i].radius);
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
  return radii[radii.size() / 2];
}

/// Turned so that `way`, a direction of the model, leads ahead of the head and somewhat down.
glm::dquat laid(const glm::dquat& turn, const glm::dvec3& way, const Pose& head, double down_deg) {
  const glm::dvec3 vertical(0, 1, 0), ahead = heading_of(head) * glm::dvec3(0, 0, -1);
  glm::dvec3 now = turn * way;
  // First about the vertical, as far as it has a heading; then tipped.
  constexpr double steep = 1e-6;
  const double round = std::hypot(now.x, now.z) > steep ? std::atan2(ahead.x, ahead.z) - std::atan2(now.x, now.z) : 0;
  const glm::dquat about = glm::angleAxis(round, vertical);
  now = about * now;
  const glm::dvec3 right = glm::cross(ahead, vertical);
  const double rise = std::atan2(now.y, glm::dot(now, ahead));
  return glm::normalize(glm::angleAxis(-glm::radians(down_deg) - rise, right) * about * turn);
}

/// mm a second of the tour's own time: the most within `reach` mm of where it is now.
double speed_near(const Ride& tour, double reach) {
  const auto& points = tour.track.points;
  double most = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].along >= tour.along - reach && points[i - 1].along <= tour.along + reach)
      most = std::max(most, glm::length(points[i].at - points[i - 1].at) / (points[i].seconds - points[i - 1].seconds));
  return most;
}

/// For the next `seconds`: the limit of speed holds on all of the way that they lead over.
FlightRules tour_rules(const Visit& visit, const ComfortRules& rules, double seconds) {
  FlightRules flight = flight_rules(visit.stage, rules);
  flight.speed_factor =
      std::min(visit.tour.speed_factor,
               flight.most_speed / std::max(speed_near(*visit.tour.ride, flight.most_speed * seconds), 1e-9));
  return flight;
}

}  // namespace

void begin_tour(Visit& visit, const FlightSpace& cavity, std::size_t number, const HeadsetInput& input,
                const VisitWorld& world, const ComfortRules& rules) {
  const auto lines = rideable(cavity.lines);
  if (number >= lines.size()) return;
  const CentreLine& line = *lines[number];
  Stage stage = before(input.head, world.model, rules.tour_room / (metres_per_mm * usual_radius(line)));
  Ride tour{.line = number, .track = track_of(line, rules.clearance * mm_per_metre(stage))};
  if (tour.track.points.empty()) return;
  const Track::Point &first = tour.track.points.front(), &last = tour.track.points.back();
  stage.turn = laid(stage.turn, glm::normalize(last.at - first.at), input.head, rules.tour_down_deg);
  tour.along = first.along;
  tour.playing = true;
  visit.eye_mm = first.at;
  visit.tour.off_mm = glm::dvec3(0);
  visit.stage = moved(stage, input.head.position - to_room(stage, visit.eye_mm));
  visit.tour.ride = std::move(tour);
}

void play(Ride& tour) {
  const bool at_end = tour.along >= tour.track.points.back().along,
             at_start = tour.along <= tour.track.points.front().along;
  if (!tour.playing && ((at_end && !tour.back) || (at_start && tour.back))) tour.back = !tour.back;
  tour.playing = !tour.playing;
}

void step_tour(Visit& visit, const HeadsetInput& input, const ComfortRules& rules, double seconds) {
  Ride& tour = *visit.tour.ride;
  for (std::size_t i = 0; i < 2; ++i) {
    if (at_panel(visit, i)) continue;
    if (visit.chosen.tool == HandTool::look && pulled(visit, input, i)) play(tour);
    const double now = input.hands[i].stick.y, was = visit.hands.before[i].stick.y;
    if (std::abs(now) > pressed_above && std::abs(was) <= pressed_above) {
      tour.back = now < 0;
      tour.playing = true;
    }
  }
  const bool played = tour.playing;
  const FlightRules limits = tour_rules(visit, rules, seconds);
  const glm::dvec3 before_mm = place_on(tour.track, tour.along).at;
  tour.pace = std::clamp(tour.pace, -limits.speed_factor,
                         limits.speed_factor);  // where it widens the limit comes before gentleness
  advance(tour, limits, seconds);
  if (played && !tour.playing)  // it has arrived
    for (std::size_t i = 0; i < 2; ++i) feel(visit, i, tap);
  const Track::Point place = place_on(tour.track, tour.along);
  // The head leans within the ball about the line that holds no wall.
  glm::dvec3 off = visit.tour.off_mm + to_model(visit.stage, input.head.position) - visit.eye_mm;
  constexpr double skin = 1.03;  // between two points of the track the ball may be a little smaller
  const double most = std::max(0.0, place.radius - skin * limits.clearance), length = glm::length(off);
  if (length > most) off *= most / length;
  visit.tour.off_mm = off;
  visit.eye_mm = place.at + off;
  visit.velocity = seconds > 0 ? (place.at - before_mm) / seconds : glm::dvec3(0);
  visit.stage = moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));
}

}  // namespace odontoscope::visit_steps
