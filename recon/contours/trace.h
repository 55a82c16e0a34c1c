#pragma once
// Marching squares as a walk along each contour, for one slice. Used by volume/, between/ and sample/.
//
// The grid is the slice's pixel centres with a ring of virtual pixels around them that are always outside. A contour
// crosses every grid edge between an inside and an outside pixel exactly once, strictly between the two, and runs
// straight through every cell. Two chords of one cell never join interleaved edges, so they cannot meet; hence all
// contours are closed, simple and pairwise disjoint, also after rounding, as long as `crossing` stays strictly between
// its grid vertices.
//
// Lorensen and Cline, "Marching cubes" (1987), in two dimensions; the ambiguous cell (two inside pixels across its
// diagonal) is left to the field: one answer a cell, so that both walks through it agree.

#include <cstddef>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope::trace {

/// Grid vertex; (0, 0) is the first pixel, -1 and the size are the virtual ring.
struct Vertex {
  std::ptrdiff_t i = 0, j = 0;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// One of the four ways along the grid.
struct Step {
  std::ptrdiff_t i = 0, j = 0;
  friend bool operator==(const Step&, const Step&) = default;
};
inline constexpr Step up{0, 1};
constexpr Step turned_right(Step s) { return {s.j, -s.i}; }
constexpr Step turned_left(Step s) { return {-s.j, s.i}; }
constexpr Vertex operator+(Vertex v, Step s) { return {v.i + s.i, v.j + s.j}; }

/// Where a walk stands: on the grid edge from `inside` to the vertex on its right, about to enter the cell ahead.
struct Stand {
  Vertex inside;
  Step ahead;
  Vertex outside() const { return inside + turned_right(ahead); }
  friend bool operator==(const Stand&, const Stand&) = default;
};

/// Field: bool inside(Vertex); bool joined(Vertex a, Vertex b, Vertex c, Vertex d), asked for a cell with a and b
/// inside, across the diagonal, and c and d outside: are a and b one region there?
template <class Field>
Stand next(const Field& field, const Stand& stand) {
  const Vertex near_right = stand.outside();
  const Vertex far_left = stand.inside + stand.ahead;
  const Vertex far_right = near_right + stand.ahead;
  const bool left = field.inside(far_left);
  const bool right = field.inside(far_right);
  const bool turn_right = right && (left || field.joined(stand.inside, far_right, near_right, far_left));
  if (turn_right) return {far_right, turned_right(stand.ahead)};
  if (left) return {far_left, stand.ahead};
  return {stand.inside, turned_left(stand.ahead)};
}

/// Calls `take(std::vector<Crossing>&&)` for every contour of the slice, inside on its left (outer contours
/// counter-clockwise, holes clockwise), in the order of their lowest, then leftmost rising crossing, which is also
/// their first point. Stops early when `take` returns false. Field also has Crossing crossing(Vertex inside, Vertex
/// outside), a Point2 strictly between the two or a number that stands for one; and may have void bend(const Stand&,
/// std::vector<Crossing>& points), which appends points that a contour has in the cell ahead, between its two
/// crossings, where it does not run straight.
template <class Field, class Take>
void contours(const Field& field, std::size_t width, std::size_t height, const Take& take) {
  std::vector<bool> visited(width * height, false);  // rising crossings to the right of each pixel
  const auto rows = static_cast<std::ptrdiff_t>(height);
  const auto columns = static_cast<std::ptrdiff_t>(width);
  const auto number = [columns](Vertex v) { return static_cast<std::size_t>(v.j * columns + v.i); };
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
      const Stand start{{i, j}, up};
      if (!field.inside(start.inside) || field.inside(start.outside()) || visited[number(start.inside)]) continue;
      std::vector<decltype(field.crossing(start.inside, start.outside()))> points;
      Stand stand = start;
      do {
        if (stand.ahead == up) visited[number(stand.inside)] = true;
        points.push_back(field.crossing(stand.inside, stand.outside()));
        if constexpr (requires { field.bend(stand, points); }) field.bend(stand, points);
        stand = next(field, stand);
      } while (!(stand == start));
      if (!take(std::move(points))) return;
    }
  }
}

}  // namespace odontoscope::trace
