#pragma once
// A part of a picture.

#include <glm/vec2.hpp>

namespace odontoscope {

/// A rectangle of the picture in pixels from the upper left.
struct Area {
  double left = 0, top = 0, width = 0, height = 0;
  double aspect() const { return height > 0 ? width / height : 1; }
  bool holds(double x, double y) const { return x >= left && y >= top && x < left + width && y < top + height; }
  friend bool operator==(const Area&, const Area&) = default;
};

/// From pixels of the picture to places in the area, and back: from its middle, to the right and up, half of its height
/// is 1.
inline glm::dvec2 place_in(const Area& area, double x, double y) {
  const double half = area.height / 2;
  return {(x - area.left - area.width / 2) / half, (area.top + half - y) / half};
}
inline glm::dvec2 pixel_of(const Area& area, const glm::dvec2& place) {
  const double half = area.height / 2;
  return {area.left + area.width / 2 + half * place.x, area.top + half - half * place.y};
}

}  // namespace odontoscope
