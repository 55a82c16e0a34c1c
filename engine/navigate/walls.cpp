#include "engine/navigate/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/scene/glm_vector.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope {

namespace {

/// Never false where the segment meets the box: slabs with room for rounding.
bool may_meet(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& from, const glm::dvec3& to) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double pad = 1e-12 * (std::abs(from[axis]) + std::abs(to[axis]) + std::abs(low[axis]) + std::abs(high[axis]));
    const double step = to[axis] - from[axis];
    if (std::abs(step) <= pad) {
      if (std::max(from[axis], to[axis]) < low[axis] - pad || std::min(from[axis], to[axis]) > high[axis] + pad)
        return false;
      continue;
    }
    const double a = (low[axis] - pad - from[axis]) / step, b = (high[axis] + pad - from[axis]) / step;
    enter = std::max(enter, std::min(a, b) - 1e-12);
    leave = std::min(leave, std::max(a, b) + 1e-12);
    if (enter > leave) return false;
  }
  return true;
}

bool meets_box_of(const Corners& t, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 a = vec(t[0]), b = vec(t[1]), c = vec(t[2]);
  return may_meet(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), from, to);
}

/// +1: the segment passes through the triangle's inside; 0: not at all; -1: it touches an edge, a corner or the plane.
int passes(const Corners& t, const Point3& from, const Point3& to) {
  const int start = orientation(t[0], t[1], t[2], from), end = orientation(t[0], t[1], t[2], to);
  if (start * end > 0) return 0;
  const int ab = orientation(from, to, t[0], t[1]), bc = orientation(from, to, t[1], t[2]),
            ca = orientation(from, to, t[2], t[0]);
  const bool some_left = ab > 0 || bc > 0 || ca > 0, some_right = ab < 0 || bc < 0 || ca < 0;
  if (some_left && some_right) return 0;
  return start != 0 && end != 0 && ab != 0 && bc != 0 && ca != 0 ? 1 : -1;
}

/// Where along from + t * direction; negative if it misses.
double meeting(const Corners& t, const glm::dvec3& from, const glm::dvec3& direction) {
  const glm::dvec3 a = vec(t[0]), u = vec(t[1]) - a, v = vec(t[2]) - a, across = glm::cross(direction, v);
  const double whole = glm::dot(u, across);
  if (whole == 0) return -1;
  const glm::dvec3 w = from - a, q = glm::cross(w, u);
  const double s = glm::dot(w, across) / whole, r = glm::dot(direction, q) / whole;
  return s >= -1e-12 && r >= -1e-12 && s + r <= 1 + 1e-12 ? glm::dot(v, q) / whole : -1;
}

/// Directions evenly over the sphere.
glm::dvec3 fibonacci(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, round = std::sqrt(std::max(0.0, 1 - z * z)),
               angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
  return {round * portable::cos(angle), round * portable::sin(angle), z};
}

}  // namespace

Walls::Walls(const SurfaceMesh& surface) : Walls(std::vector<const SurfaceMesh*>{&surface}) {}

Walls::Walls(const std::vector<const SurfaceMesh*>& surfaces) {
  std::vector<Corners> given;
  for (const SurfaceMesh* surface : surfaces)
    for (const auto& [a, b, c] : surface->triangles)
      given.push_back({surface->points[a], surface->points[b], surface->points[c]});
  tree_ = SurfaceTree(given);
  if (tree_.empty()) return;
  const auto [low, high] = tree_.bounds();
  bounds_ = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

Walls::Nearest Walls::nearest(const glm::dvec3& place, double most) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool far = !(most < std::sqrt(std::numeric_limits<double>::max()));
  const SurfaceTree::Nearest found = tree_.nearest(point(place), far ? infinity : most * most);
  return found.found() ? Nearest{std::sqrt(found.square), vec(found.at)} : Nearest{};
}

template <class Visit>
void Walls::along(const glm::dvec3& from, const glm::dvec3& to, Visit visit) const {
  using Low = std::array<double, 3>;
  const glm::dvec3 way = to - from;
  tree_.along(
      {way.x, way.y, way.z},
      [&](const Low& low, const Low& high) {
        return may_meet({low[0], low[1], low[2]}, {high[0], high[1], high[2]}, from, to);
      },
      visit);
}

namespace {

/// As long as any wall can be away.
double beyond(const Box& bounds, const glm::dvec3& eye) {
  return 2 * (glm::length(bounds.high - bounds.low) + glm::length(bounds.centre() - eye)) + 1;
}

}  // namespace

double Walls::free_distance(const glm::dvec3& eye, const glm::dvec3& direction, double most) const {
  double first = std::numeric_limits<double>::infinity();
  along(eye, eye + std::min(most, beyond(bounds_, eye)) * direction, [&](const Corners& t) {
    const double at = meeting(t, eye, direction);
    if (at >= 0 && at <= most) first = std::min(first, at);
    return true;
  });
  return first;
}

std::vector<double> Walls::meetings(const glm::dvec3& eye, const glm::dvec3& direction) const {
  std::vector<double> all;
  along(eye, eye + beyond(bounds_, eye) * direction, [&](const Corners& t) {
    if (const double at = meeting(t, eye, direction); at >= 0) all.push_back(at);
    return true;
  });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a <= 1e-9 * b; }), all.end());
  return all;
}

Walls::Side Walls::locate(const glm::dvec3& place) const {
  if (empty()) return Side::outside;
  constexpr int lines = 16;
  for (int line = 0; line < lines; ++line) {
    const glm::dvec3 far = place + beyond(bounds_, place) * fibonacci(line, lines);
    bool clear = true, inside = false;
    along(place, far, [&](const Corners& t) {
      const int how = passes(t, point(place), point(far));
      clear = how >= 0;
      inside = inside != (how > 0);
      return clear;
    });
    if (clear) return inside ? Side::inside : Side::outside;
  }
  return Side::on_wall;
}

bool Walls::crosses(const glm::dvec3& from, const glm::dvec3& to) const {
  bool touched = false;
  along(from, to, [&](const Corners& t) {
    touched = passes(t, point(from), point(to)) != 0 && meets_box_of(t, from, to);
    return !touched;
  });
  return touched;
}

std::optional<LargestClearance> place_of_largest_clearance(const Walls& walls, int places) {
  if (walls.empty()) return std::nullopt;
  const Box& bounds = walls.bounds();
  const glm::dvec3 extent = glm::max(bounds.high - bounds.low, glm::dvec3(1e-9));
  const double step = portable::cbrt(extent.x * extent.y * extent.z / std::max(places, 1));
  const glm::ivec3 count = glm::clamp(glm::ivec3(glm::ceil(extent / step)), 3, 256);
  std::optional<LargestClearance> best;
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y)
      for (int x = 0; x < count.x; ++x) {
        const glm::dvec3 at = bounds.low + (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(count) * extent;
        const double clearance = walls.nearest(at).distance;
        if ((!best || clearance > best->clearance) && walls.locate(at) == Walls::Side::inside)
          best = LargestClearance{at, clearance};
      }
  if (!best) return best;
  // Then uphill. A step shorter than the clearance cannot leave through a wall.
  for (double reach = 0.5 * best->clearance; reach > 1e-4 * best->clearance;) {
    const LargestClearance before = *best;
    for (int i = 0; i < 14; ++i) {
      const glm::dvec3 at = before.at + reach * fibonacci(i, 14);
      if (const double clearance = walls.nearest(at).distance; clearance > best->clearance)
        best = LargestClearance{at, clearance};
    }
    if (best->at == before.at)
      reach *= 0.5;
    else
      reach = std::min(reach, 0.5 * before.clearance);
  }
  return best;
}

glm::dvec3 longest_free_direction(const Walls& walls, const glm::dvec3& eye, int count) {
  glm::dvec3 best = fibonacci(0, count);
  double farthest = -1;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 direction = fibonacci(i, count);
    const double free = walls.free_distance(eye, direction);
    if (free > farthest && std::isfinite(free)) {
      farthest = free;
      best = direction;
    }
  }
  return best;
}

}  // namespace odontoscope
