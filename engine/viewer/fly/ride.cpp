// Rides along canals.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/navigate/thickness_colours.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/fly/on_wall.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double scrub_share = 0.02;  // of the track, with one key

}  // namespace

Track FlyMode::rideable_track(std::size_t cavity, std::size_t line) {
  const auto lines = rideable(state_.shown->flight->cavities[cavity].lines);
  if (line >= lines.size()) {
    notice(lines.empty() ? "No canals were found in this cavity." : "There are not so many canals here.");
    return {};
  }
  Track track = track_of(*lines[line], state_.shown->flight->rules.clearance);
  if (track.points.empty()) notice("That canal is too narrow to fly in.");
  return track;
}

void FlyMode::ride_canal(std::size_t cavity, std::size_t line) {
  Track track = rideable_track(cavity, line);
  if (track.points.empty()) return;
  if (!fly_.on || fly_.cavity != cavity)
    return dive(cavity, [this, line, track = std::move(track)] { start_ride(line, track); });
  at_.fade.darken_then([this, line, cavity, track = std::move(track)]() mutable {
    if (fly_.on && fly_.cavity == cavity) start_ride(line, std::move(track));
  });
}

void FlyMode::start_ride(std::size_t line, Track track) {
  Ride ride{.line = line, .track = std::move(track)};
  ride.along = ride.track.points.front().along;
  ride.playing = !state_.settings.comfort.reduced_motion;
  fly_.ride = std::move(ride);
  fly_.flight = flight_of(*fly_.ride, rules());
  fly_.trail = {fly_.flight.eye};
}

void FlyMode::begin_ride(std::size_t line) {
  if (!possible() || state_.shown->flight->cavities.empty()) {
    notice("There is no cavity in this model, so there are no canals to ride.");
    return;
  }
  ride_canal(fly_.on && fly_.cavity ? *fly_.cavity : 0, line);
}

/// Free flight from where the ride is.
void FlyMode::leave_ride() {
  const Walls& walls = this->walls();
  const double clearance = state_.shown->flight->rules.clearance;
  if (walls.nearest(fly_.flight.eye).distance < clearance) {
    // Between two of the line's points it may be a hair narrower than at them.
    const auto& points = fly_.ride->track.points;
    const Track::Point* best = nullptr;
    for (const Track::Point& point : points)
      if (walls.nearest(point.at).distance >= clearance &&
          (!best || std::abs(point.along - fly_.ride->along) < std::abs(best->along - fly_.ride->along)))
        best = &point;
    if (!best) return;
    fly_.flight.eye = best->at;
  }
  fly_.flight.velocity = glm::dvec3(0);
  fly_.flight.turning = glm::dvec2(0);
  fly_.ride.reset();
}

void FlyMode::advance_ride(const FlightWish& wish, double seconds) {
  if (wish.move != glm::dvec3(0)) {
    leave_ride();
    return;
  }
  const FlightRules rules = this->rules();
  const glm::dvec2 aim = glm::radians(rules.turn_deg_per_second) * glm::clamp(wish.turn, -1.0, 1.0);
  fly_.flight.turning += (1 - std::exp(-seconds / rules.settle_seconds)) * (aim - fly_.flight.turning);
  if (aim == glm::dvec2(0) && glm::length(fly_.flight.turning) < 1e-4) fly_.flight.turning = glm::dvec2(0);
  Ride& ride = *fly_.ride;
  ride.look += seconds * fly_.flight.turning;
  odontoscope::advance(ride, rules, seconds);
  if (!ride.playing && std::abs(ride.pace) < 1e-3) ride.pace = 0;
  const glm::dvec2 turning = fly_.flight.turning;
  fly_.flight = flight_of(ride, rules);
  fly_.flight.turning = turning;
}

bool FlyMode::perform_on_ride(Action action) {
  switch (action) {
    case Action::toggle_labels:
      fly_.habits.labels = !fly_.habits.labels;
      return true;
    case Action::toggle_depth:
      next_on_wall(state_.settings.comfort, tells_thickness(state_.shown->model));
      return true;
    case Action::toggle_where:
      fly_.habits.inset = !fly_.habits.inset;
      return true;
    case Action::turn_where:
      fly_.habits.inset_from = fly_.habits.inset_from == NamedView::buccal   ? NamedView::mesial
                               : fly_.habits.inset_from == NamedView::mesial ? NamedView::occlusal
                                                                             : NamedView::buccal;
      return true;
    case Action::next_canal: {
      if (!fly_.cavity) {
        begin_ride(0);
        return true;
      }
      const std::size_t count = rideable(state_.shown->flight->cavities[*fly_.cavity].lines).size();
      begin_ride(fly_.ride && count > 0 ? (fly_.ride->line + 1) % count : 0);
      return true;
    }
    case Action::ride_play:
      if (!fly_.ride) begin_ride(fly_.place ? fly_.place->line : 0);
      if (fly_.ride) control_ride(action);
      return true;
    case Action::ride_back:
    case Action::ride_farther:
    case Action::ride_nearer:
    case Action::ride_to_start:
    case Action::ride_to_end:
      if (fly_.ride) control_ride(action);
      return true;
    default:
      return false;
  }
}

/// Precondition: one rides.
void FlyMode::control_ride(Action action) {
  Ride& ride = *fly_.ride;
  const double from = ride.track.points.front().along, to = ride.track.points.back().along;
  switch (action) {
    case Action::ride_play:
      ride.playing = !ride.playing;
      if (ride.playing && !ride.back && ride.along >= to) ride.along = from;  // once more
      if (ride.playing && ride.back && ride.along <= from) ride.along = to;
      ride.look = ride.playing ? glm::dvec2(0) : ride.look;
      break;
    case Action::ride_back:
      turn_round(ride);
      break;
    case Action::ride_farther:
      ride.along = std::min(ride.along + scrub_share * (to - from), to);
      break;
    case Action::ride_nearer:
      ride.along = std::max(ride.along - scrub_share * (to - from), from);
      break;
    case Action::ride_to_start:
      ride.along = from;
      break;
    case Action::ride_to_end:
      ride.along = to;
      break;
    default:
      break;
  }
}

}  // namespace odontoscope
