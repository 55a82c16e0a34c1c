#include "recon/compare/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

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

bool is_material(const PlaneSection& section, const Point2& place) {
  return is_inside(section.below, place) || is_inside(section.above, place);
}

}  // namespace odontoscope
