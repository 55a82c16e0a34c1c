#include "engine/navigate/ride.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/navigate/tour.h"
#include "engine/scene/glm_vector.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

/// Room over the clearance: between the line's points the eye may be a little nearer to the wall than at them.
constexpr double least_ride_room = 1.06;
constexpr double least_ride_width = 0.1;  // clearances
/// Between two points of the table.
constexpr double table_seconds = 1.0 / 60;

/// The longest run of points wide enough, as [first, last].
std::pair<std::size_t, std::size_t> wide_enough(const std::vector<Track::Point>& points, double clearance) {
  std::pair<std::size_t, std::size_t> best{1, 0};
  for (std::size_t i = 0; i < points.size();) {
    if (points[i].radius < least_ride_room * clearance) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < points.size() && points[last + 1].radius >= least_ride_room * clearance) ++last;
    if (best.first > best.second || last - i > best.second - best.first) best = {i, last};
    i = last + 1;
  }
  return best;
}

}  // namespace

std::vector<const CentreLine*> rideable(const CentreLines& lines) {
  std::vector<const CentreLine*> all;
  for (const auto* some : {&lines.canals, &lines.horns, &lines.others})
    for (const CentreLine& line : *some)
      if (line.points.size() >= 2) all.push_back(&line);
  return all;
}

Track track_of(const CentreLine& line, double clearance) {
  Track track;
  if (line.points.size() < 2) return track;
  // A tour wants some width everywhere; where a line leads through a crack the track is cut off below.
  CentreLine passable = line;
  for (CentrePoint& point : passable.points) point.radius = std::max(point.radius, least_ride_width * clearance);
  const Tour tour(passable);
  std::vector<Track::Point> all;
  const auto count = static_cast<std::size_t>(std::ceil(tour.seconds() / table_seconds));
  for (std::size_t i = 0; i <= count; ++i) {
    const double seconds = std::min(table_seconds * static_cast<double>(i), tour.seconds());
    const TourInstant instant = tour.at(seconds);
    if (!all.empty() && !(instant.along > all.back().along)) continue;
    all.push_back({instant.camera.position, glm::normalize(instant.camera.target - instant.camera.position),
                   instant.camera.up, instant.clearance, instant.along, seconds});
  }
  const auto [first, last] = wide_enough(all, clearance);
  if (first >= last) return track;
  track.points.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                      all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  track.orifice = line.points[std::min(line.orifice, line.points.size() - 1)].along;
  track.end = line.points.back().along + glm::length(vec(line.end) - vec(line.points.back().at));
  return track;
}

namespace {

/// Between the points of the table, where `value` says.
Track::Point place_by(const Track& track, double Track::Point::*member, double value) {
  const auto& points = track.points;
  value = std::clamp(value, points.front().*member, points.back().*member);
  const auto after = std::lower_bound(points.begin(), points.end(), value,
                                      [&](const Track::Point& point, double wanted) { return point.*member < wanted; });
  if (after == points.begin()) return points.front();
  const Track::Point &a = *(after - 1), &b = *after;
  const double part = (value - a.*member) / (b.*member - a.*member);
  const auto mixed = [&](const auto& x, const auto& y) { return (1 - part) * x + part * y; };
  const Flight stands = looking({}, mixed(a.view_direction, b.view_direction), mixed(a.up, b.up));
  return {mixed(a.at, b.at),         stands.view_direction,   stands.up,
          mixed(a.radius, b.radius), mixed(a.along, b.along), mixed(a.seconds, b.seconds)};
}

}  // namespace

Track::Point place_on(const Track& track, double along) { return place_by(track, &Track::Point::along, along); }

Flight flight_on(const Track& track, double along) {
  const Track::Point place = place_on(track, along);
  return looking(place.at, place.view_direction, place.up);
}

void advance(Ride& ride, const FlightRules& rules, double seconds) {
  if (ride.track.points.empty() || !(seconds > 0)) return;
  const double wanted = !ride.playing ? 0 : ride.back ? -rules.speed_factor : rules.speed_factor;
  // The pace nears what is wanted exponentially; so it comes as far in many short frames as in one long one.
  const double share = 1 - portable::exp(-seconds / rules.settle_seconds);
  const double by = seconds * wanted + rules.settle_seconds * share * (ride.pace - wanted);
  ride.pace += share * (wanted - ride.pace);
  const double from = ride.track.points.front().seconds, to = ride.track.points.back().seconds;
  const double time = place_on(ride.track, ride.along).seconds + by;
  ride.along = place_by(ride.track, &Track::Point::seconds, time).along;
  if ((time >= to && ride.pace > 0) || (time <= from && ride.pace < 0)) {
    ride.playing = false;
    ride.pace = 0;
  }
}

Flight flight_of(const Ride& ride, const FlightRules& rules) {
  FlightRules level = rules;
  level.upright = glm::dvec3(0);  // the line's own up is the horizon here
  return turned(flight_on(ride.track, ride.along), ride.look, level);
}

double begins_at(const CentreLines& lines, const CentreLine& line) {
  return line.orifice > 0 || !lines.has_chamber ? line.points[std::min(line.orifice, line.points.size() - 1)].along
                                                : lines.chamber_radius;
}

std::optional<CanalPlace> canal_place(const CentreLines& lines, const glm::dvec3& place) {
  std::optional<CanalPlace> best;
  double nearest = std::numeric_limits<double>::infinity();
  const auto all = rideable(lines);
  for (std::size_t l = 0; l < all.size(); ++l) {
    const CentreLine& line = *all[l];
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const glm::dvec3 a = vec(line.points[i].at), step = vec(line.points[i + 1].at) - a;
      const double squared = glm::dot(step, step);
      const double part = squared > 0 ? std::clamp(glm::dot(place - a, step) / squared, 0.0, 1.0) : 0;
      const double off = glm::length(a + part * step - place);
      if (off >= nearest) continue;
      nearest = off;
      CanalPlace found;
      found.line = l;
      found.along = line.points[i].along + part * (line.points[i + 1].along - line.points[i].along);
      found.depth = found.along - begins_at(lines, line);
      found.width = 2 * (line.points[i].radius + part * (line.points[i + 1].radius - line.points[i].radius));
      found.to_end = line.points.back().along + glm::length(vec(line.end) - vec(line.points.back().at)) - found.along;
      found.off = off;
      best = found;
    }
  }
  return best;
}

}  // namespace odontoscope
