#include "recon/compare/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

/// Where the side from a point below to one not below meets the plane; exactly that one if it lies on it.
Point2 crossing(const Point3& below, const Point3& above, double z) {
  if (above.z == z) return {above.x, above.y};
  if (below.z == z) return {below.x, below.y};
  const double share = (z - below.z) / (above.z - below.z);
  return {below.x + share * (above.x - below.x), below.y + share * (above.y - below.y)};
}

void cut(const SurfaceMesh& surface, const Triangle& t, double z, bool on_is_below,
         std::vector<SectionSegment>& segments) {
  std::array<Point2, 2> ends;
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    const Point3 &a = surface.points[t[i]], &b = surface.points[t[(i + 1) % 3]];
    const auto is_below = [&](const Point3& p) { return p.z < z || (on_is_below && p.z == z); };
    if (is_below(a) == is_below(b)) continue;
    ends[count++] = is_below(a) ? crossing(a, b, z) : crossing(b, a, z);
  }
  if (count == 2 && !(ends[0] == ends[1])) segments.push_back({ends[0], ends[1]});
}

bool is_inside(const std::vector<SectionSegment>& segments, const Point2& place) {
  constexpr int directions = 7;
  int odd = 0;
  for (int d = 0; d < directions; ++d) {
    const double angle = 0.1 + 2 * std::numbers::pi * d / directions;  // not along the grid
    const double cx = portable::cos(angle), cy = portable::sin(angle);
    bool inside = false;
    for (const SectionSegment& s : segments) {
      // In axes turned so that the ray runs along the first.
      const double ax = (s.from.x - place.x) * cx + (s.from.y - place.y) * cy,
                   ay = (s.from.y - place.y) * cx - (s.from.x - place.x) * cy;
      const double bx = (s.to.x - place.x) * cx + (s.to.y - place.y) * cy,
                   by = (s.to.y - place.y) * cx - (s.to.x - place.x) * cy;
      if ((ay <= 0) == (by <= 0)) continue;
      if (ax + (bx - ax) * (ay / (ay - by)) > 0) inside = !inside;
    }
    odd += inside;
  }
  return odd > directions / 2;
}

using Key = std::array<double, 4>;

/// The same for either direction.
Key key(const SectionSegment& s) {
  const std::array from{s.from.x, s.from.y}, to{s.to.x, s.to.y};
  return from < to ? Key{from[0], from[1], to[0], to[1]} : Key{to[0], to[1], from[0], from[1]};
}

std::vector<SectionSegment> outside(const std::vector<SectionSegment>& side, const std::vector<SectionSegment>& other) {
  std::vector<Key> shared;
  for (const SectionSegment& s : other) shared.push_back(key(s));
  std::sort(shared.begin(), shared.end());
  std::vector<SectionSegment> left;
  for (const SectionSegment& s : side) {
    const Point2 middle{0.5 * (s.from.x + s.to.x), 0.5 * (s.from.y + s.to.y)};
    if (std::binary_search(shared.begin(), shared.end(), key(s)) || !is_inside(other, middle)) left.push_back(s);
  }
  return left;
}

}  // namespace

PlaneSection outline(const PlaneSection& section) {
  return {outside(section.below, section.above), outside(section.above, section.below)};
}

std::vector<PlaneSection> sections(const SurfaceMesh& surface, const std::vector<double>& heights) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  std::vector<PlaneSection> result(heights.size());
  for (const Triangle& t : surface.triangles) {
    const auto [low, high] = std::minmax({surface.points[t[0]].z, surface.points[t[1]].z, surface.points[t[2]].z});
    const auto first =
        std::lower_bound(order.begin(), order.end(), low, [&](std::size_t i, double z) { return heights[i] < z; });
    for (auto i = first; i != order.end() && heights[*i] <= high; ++i) {
      cut(surface, t, heights[*i], false, result[*i].below);
      cut(surface, t, heights[*i], true, result[*i].above);
    }
  }
  return result;
}

bool is_material(const PlaneSection& section, const Point2& place) {
  return is_inside(section.below, place) || is_inside(section.above, place);
}

}  // namespace odontoscope
