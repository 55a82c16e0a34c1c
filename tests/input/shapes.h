#pragma once
// Named shapes and stacks for the tests of this room.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::shapes {

using Points = std::vector<Point2>;

inline Contour of(std::string structure, Points points) { return {std::move(structure), std::move(points)}; }
inline Contour tooth(Points points) { return of("tooth", std::move(points)); }

/// Axis-parallel, counter-clockwise.
inline Points square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

inline Points circle(double x, double y, double radius, std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return points;
}

inline Points reversed(Points points) { return {points.rbegin(), points.rend()}; }

/// The contours in the middle one of three slices; a plain square above and below.
inline ContourStack between_squares(std::vector<Contour> contours) {
  return {{{0, {tooth(square(0, 0, 1))}}, {1, std::move(contours)}, {2, {tooth(square(0, 0, 1))}}}, "test.json"};
}

}  // namespace odontoscope::shapes
