#include "engine/navigate/ride.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace odontoscope {

namespace {

/// Radii a second at usual speed.
constexpr double radii_per_second = 2.2;
/// Room over the clearance, so that who leaves the ride has some.
constexpr double least_room = 1.05;
/// The eye looks from so far behind to so far ahead, in radii of the canal: corners are looked into before they are turned.
constexpr double look_behind = 0.6, look_ahead = 2.0;

glm::dvec3 vec(const Point3& p) { return {p.x, p.y, p.z}; }

glm::dvec3 on_line(const std::vector<CentrePoint>& points, double along) {
  along = std::clamp(along, points.front().along, points.back().along);
  const auto after = std::lower_bound(points.begin(), points.end(), along, [](const CentrePoint& point, double value) { return point.along < value; });
  if (after == points.begin()) return vec(points.front().at);
  const CentrePoint &a = *(after - 1), &b = *after;
  const double part = b.along > a.along ? (along - a.along) / (b.along - a.along) : 0;
  return (1 - part) * vec(a.at) + part * vec(b.at);
}

/// The longest run of points wide enough, as [first, last].
std::pair<std::size_t, std::size_t> wide_enough(const std::vector<CentrePoint>& points, double clearance) {
  std::pair<std::size_t, std::size_t> best{1, 0};
  for (std::size_t i = 0; i < points.size();) {
    if (points[i].radius < least_room * clearance) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < points.size() && points[last + 1].radius >= least_room * clearance) ++last;
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

Track track_of(const CentreLine& line, double clearance, const glm::dvec3& upright) {
  Track track;
  const auto [first, last] = wide_enough(line.points, clearance);
  if (line.points.size() < 2 || first >= last) return track;
  track.orifice = line.points[std::min(line.orifice, line.points.size() - 1)].along;
  track.end = line.points.back().along + glm::length(vec(line.end) - vec(line.points.back().at));
  glm::dvec3 up = upright;
  for (std::size_t i = first; i <= last; ++i) {
    const CentrePoint& point = line.points[i];
    Track::Point made{vec(point.at), {}, {}, point.radius, point.along};
    glm::dvec3 towards = on_line(line.points, point.along + look_ahead * point.radius) - on_line(line.points, point.along - look_behind * point.radius);
    if (!(glm::length(towards) > 0)) towards = track.points.empty() ? glm::dvec3(0, 0, -1) : track.points.back().sight;
    const Flight stands = looking(made.at, towards, track.points.empty() ? upright : up);
    made.sight = stands.sight;
    // Carried on from the point before: what of its up is at right angles to the new sight.
    made.up = stands.up;
    up = made.up;
    track.points.push_back(made);
  }
  return track;
}

Track::Point place_on(const Track& track, double along) {
  const auto& points = track.points;
  along = std::clamp(along, points.front().along, points.back().along);
  const auto after = std::lower_bound(points.begin(), points.end(), along, [](const Track::Point& point, double value) { return point.along < value; });
  if (after == points.begin()) return points.front();
  const Track::Point &a = *(after - 1), &b = *after;
  const double part = b.along > a.along ? (along - a.along) / (b.along - a.along) : 0;
  const Flight stands = looking({}, (1 - part) * a.sight + part * b.sight, (1 - part) * a.up + part * b.up);
  return {(1 - part) * a.at + part * b.at, stands.sight, stands.up, (1 - part) * a.radius + part * b.radius, along};
}

Flight flight_on(const Track& track, double along) {
  const Track::Point place = place_on(track, along);
  return looking(place.at, place.sight, place.up);
}

void advance(Ride& ride, const FlightRules& rules, double seconds) {
  if (ride.track.points.empty() || !(seconds > 0)) return;
  constexpr double longest_tick = 1.0 / 120;
  const int ticks = std::max(1, static_cast<int>(std::ceil(std::min(seconds, 10.0) / longest_tick - 1e-9)));
  const double tick = std::min(seconds, 10.0) / ticks, share = 1 - std::exp(-tick / rules.settle_seconds);
  const double from = ride.track.points.front().along, to = ride.track.points.back().along;
  for (int i = 0; i < ticks; ++i) {
    const double radius = place_on(ride.track, ride.along).radius;
    const double usual = rules.haste * std::max(radii_per_second * radius, rules.least_speed);
    const double wanted = ride.playing ? (ride.back ? -usual : usual) : 0;
    ride.speed += share * (wanted - ride.speed);
    ride.along += tick * ride.speed;
    if (ride.along >= to || ride.along <= from) {
      const bool over = ride.speed != 0 && (ride.along >= to) == (ride.speed > 0);
      ride.along = std::clamp(ride.along, from, to);
      if (!over) continue;
      ride.playing = false;
      ride.speed = 0;
    }
  }
}

Flight flight_of(const Ride& ride, const FlightRules& rules) {
  FlightRules level = rules;
  level.upright = glm::dvec3(0);   // the line's own up is the horizon here
  return turned(flight_on(ride.track, ride.along), ride.look, level);
}

std::optional<CanalPlace> canal_place(const CentreLines& lines, const glm::dvec3& place) {
  std::optional<CanalPlace> best;
  // What leaves the chamber without an orifice, a horn, begins where the chamber's ball ends.
  const auto begins = [&](const CentreLine& line) {
    return line.orifice > 0 || !lines.has_chamber ? line.points[std::min(line.orifice, line.points.size() - 1)].along : lines.chamber_radius;
  };
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
      found.depth = found.along - begins(line);
      found.width = 2 * (line.points[i].radius + part * (line.points[i + 1].radius - line.points[i].radius));
      found.to_end = line.points.back().along + glm::length(vec(line.end) - vec(line.points.back().at)) - found.along;
      found.off = off;
      best = found;
    }
  }
  return best;
}

}  // namespace odontoscope
