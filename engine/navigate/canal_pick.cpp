#include "engine/navigate/canal_pick.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/scene/glm_vector.h"

namespace odontoscope {

namespace {

constexpr double hairbreadth = 1e-4;  // over the distance

/// Of the line of sight, in mm from its origin.
struct Stretch {
  double from = 0, to = 0;
};

/// What the section left of it.
std::optional<Stretch> kept(Stretch stretch, const SightLine& sight, const std::optional<Section>& section) {
  if (!section) return stretch;
  const glm::dvec3 normal = glm::normalize(section->normal);
  const double slope = glm::dot(normal, sight.direction), before = glm::dot(normal, section->point_mm - sight.origin);
  if (slope < 0)
    stretch.from = std::max(stretch.from, before / slope);
  else if (slope > 0)
    stretch.to = std::min(stretch.to, before / slope);
  else if (before < 0)
    return std::nullopt;
  return stretch.from < stretch.to ? std::optional(stretch) : std::nullopt;
}

/// Where the line of sight runs in the void and is seen, nearest first.
std::vector<Stretch> seen_within(const Walls& walls, const SightLine& sight, const CanalPickOptions& options) {
  const std::vector<double> meetings = walls.meetings(sight.origin, sight.direction);
  std::vector<Stretch> seen;
  for (std::size_t i = meetings.size() % 2; i + 1 < meetings.size(); i += 2) {
    const auto stretch = kept({meetings[i], meetings[i + 1]}, sight, options.section);
    // The void's own wall hides nothing of it, nor what fills it and shares that wall, whose triangles are rounded
    // otherwise.
    const double hair = hairbreadth * (1 + std::abs(meetings[i]));
    if (stretch && stretch->from <= options.sight_mm + hair) seen.push_back(*stretch);
  }
  return seen;
}

struct Approach {
  double distance = std::numeric_limits<double>::infinity();  // between the two
  double along = 0;                                           // the sight, mm
  double part = 0;                                            // of the way from a to b
};

/// Where the stretch of sight and the straight line from a to b come nearest to each other.
Approach approach(const SightLine& sight, const Stretch& stretch, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 step = b - a, off = a - sight.origin;
  const double squared = glm::dot(step, step), slope = glm::dot(step, sight.direction);
  const double apart = squared - slope * slope;  // the sight's direction has length 1
  double part = apart > 1e-12 * squared
                    ? std::clamp((slope * glm::dot(off, sight.direction) - glm::dot(off, step)) / apart, 0.0, 1.0)
                    : 0;
  const double along = std::clamp(glm::dot(off + part * step, sight.direction), stretch.from, stretch.to);
  if (squared > 0) part = std::clamp(glm::dot(sight.origin + along * sight.direction - a, step) / squared, 0.0, 1.0);
  return {glm::length(a + part * step - (sight.origin + along * sight.direction)), along, part};
}

struct Candidate {
  double distance = std::numeric_limits<double>::infinity();
  CanalPick pick;
};

/// Looks at all lines of the void; `counts(approach, clearance)` says whether one is near enough.
template <class Counts>
void look_along(const FlightSpace& space, std::size_t cavity, const SightLine& sight, const Stretch& stretch,
                Counts counts, Candidate& best) {
  const auto lines = rideable(space.lines);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const auto& points = lines[l]->points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const glm::dvec3 a = vec(points[i].at), b = vec(points[i + 1].at);
      const Approach near = approach(sight, stretch, a, b);
      if (near.distance >= best.distance || !counts(near, points[i].radius)) continue;
      const double along = points[i].along + near.part * (points[i + 1].along - points[i].along);
      best = {
          near.distance,
          {cavity, l, space.lines.has_chamber && along < begins_at(space.lines, *lines[l]), a + near.part * (b - a)}};
    }
  }
}

}  // namespace

std::optional<CanalPick> pick_canal(const FlightSpaces& spaces, const SightLine& sight,
                                    const CanalPickOptions& options) {
  Candidate best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < spaces.cavities.size(); ++c) {
    for (const Stretch& stretch : seen_within(spaces.cavities[c].walls, sight, options)) {
      if (stretch.from >= nearest) break;  // behind another
      Candidate here;
      look_along(
          spaces.cavities[c], c, sight, stretch, [](const Approach&, double) { return true; }, here);
      if (!std::isfinite(here.distance)) continue;
      nearest = stretch.from;
      best = here;
      break;
    }
  }
  if (std::isfinite(best.distance)) return best.pick;
  const auto whole = kept({0, std::numeric_limits<double>::max()}, sight, options.section);
  if (!whole) return std::nullopt;
  for (std::size_t c = 0; c < spaces.cavities.size(); ++c)
    look_along(
        spaces.cavities[c], c, sight, *whole,
        [&](const Approach& near, double clearance) {
          return near.distance <= clearance + options.slack_mm &&
                 near.along - clearance - options.slack_mm <= options.sight_mm;
        },
        best);
  return std::isfinite(best.distance) ? std::optional(best.pick) : std::nullopt;
}

}  // namespace odontoscope
