#include "engine/measure/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>

namespace odontoscope {

namespace {

/// Crossings nearer than this part of the model's coordinates are the triangle itself and its neighbours, met again by
/// rounding.
constexpr double own_triangle = 1e-6;
/// Of along_normal_mm: how near the largest ball is found.
constexpr double ball_tolerance = 5e-4;

struct Ball {
  double place = 0, radius = 0;  // metres from the point along the line
};

/// The largest distance to the surface on the line. Distances change no faster than one walks, so between two places
/// with distances a and b no place is farther from the surface than (a + b + gap) / 2: the most promising gap is halved
/// until none is (Piyavskii 1972).
template <class DistanceAt>
Ball largest_ball(double length, DistanceAt distance_at) {
  struct Gap {
    double low, high, at_low, at_high;
    double most() const { return 0.5 * (at_low + at_high + high - low); }
    bool operator<(const Gap& other) const { return most() < other.most(); }
  };
  std::priority_queue<Gap> gaps;
  Ball best;
  gaps.push({0, length, 0, 0});
  while (!gaps.empty() && gaps.top().most() > best.radius + ball_tolerance * length) {
    const Gap gap = gaps.top();
    gaps.pop();
    // Where the two cones from its ends meet.
    const double middle = 0.5 * (gap.low + gap.high + gap.at_high - gap.at_low);
    const double radius = distance_at(middle);
    if (radius > best.radius) best = {middle, radius};
    gaps.push({gap.low, middle, gap.at_low, radius});
    gaps.push({middle, gap.high, radius, gap.at_high});
  }
  return best;
}

}  // namespace

std::optional<WallThickness> wall_thickness(const Pickable& pickable, const Hit& hit) {
  if (!hit.triangle) return std::nullopt;
  const auto own_part = static_cast<std::uint32_t>(hit.part);
  const auto own = static_cast<std::uint32_t>(*hit.triangle);
  const std::string& solid = pickable.parts[hit.part].solid;
  const auto bounds_it = [&](std::uint32_t part) { return pickable.parts[part].solid == solid; };
  const glm::dvec3 start = metres_per_mm * (hit.point_mm - pickable.origin_mm);
  const glm::dvec3 inwards = -pickable.tree.smooth_normal(own_part, own, start);
  if (inwards == glm::dvec3(0)) return std::nullopt;

  const double largest = std::max({std::abs(start.x), std::abs(start.y), std::abs(start.z)});
  const TreeRay ray{start, inwards, own_triangle * largest};
  // The far wall is met from behind. Fronts on the way would be a surface that overlaps itself.
  const auto far_wall = pickable.tree.nearest(ray, [&](const Crossing& c) {
    return !c.front && bounds_it(c.part) && !(c.part == own_part && c.triangle == own);
  });
  if (!far_wall) return std::nullopt;

  const Ball ball = largest_ball(far_wall->distance, [&](double place) {
    const auto nearest = pickable.tree.nearest_point(start + place * inwards, bounds_it);
    return nearest ? nearest->distance : 0.0;
  });
  const auto in_mm = [&](double place) { return pickable.origin_mm + (start + place * inwards) / metres_per_mm; };
  return WallThickness{far_wall->distance / metres_per_mm, in_mm(far_wall->distance), 2 * ball.radius / metres_per_mm,
                       in_mm(ball.place)};
}

double distance_between_mm(const Hit& a, const Hit& b) { return glm::distance(a.point_mm, b.point_mm); }

}  // namespace odontoscope
