#pragma once
// Do the contours of one structure in one slice cross or touch, and how are they nested? Exact, in O(n log n).
//
// A plane sweep over the vertices in lexicographic order (M. I. Shamos, D. Hoey, "Geometric intersection problems",
// FOCS 1976), with one event for each vertex: it opens two edges, hands over from one edge to the next, or closes two.
// The sweep's list of edges is checked against the vertex at each event, so it stops at the first event that
// contradicts it. Signs come from exact predicates; only the place of a crossing that is told to the user is rounded.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope {

/// What keeps contours from bounding a region.
struct Breach {
  enum class Kind {
    repeated_point,  // two points of one contour are equal
    touch,           // a point lies on another point (of another contour) or inside an edge
    fold_back,       // two neighbouring edges run back on each other
    crossing,        // two edges cross in their interiors
  };
  Kind kind = Kind::crossing;
  /// The contour and point concerned, and what they meet there: a point, or the edge that starts at it.
  std::size_t contour = 0, point = 0;
  std::size_t other_contour = 0, other_point = 0;
  /// Where; for a crossing correct to rounding.
  Point2 at;
};

/// How a contour lies among the others that were swept with it.
struct Nesting {
  bool counter_clockwise = false;  // as its points are given
  std::size_t depth = 0;           // number of contours around it: even for an outer contour, odd for a hole
};

struct SweepResult {
  std::optional<Breach> breach;
  /// As `members` if there is no breach, else without meaning.
  std::vector<Nesting> nesting;
};

/// Sweeps the contours `contours[members[i]]`, which should be all those of one structure in a slice. Numbers in the
/// result are those of `contours`. Preconditions: coordinates finite; three or more points in each.
SweepResult sweep(const std::vector<Contour>& contours, std::span<const std::size_t> members);

/// Do all points lie on one line (or coincide)? Exact. Precondition: coordinates finite.
bool collinear(const std::vector<Point2>& points);

/// Exact orientation of a simple polygon. Preconditions: three or more points, no two equal, not all on one line.
bool counter_clockwise(const std::vector<Point2>& simple_polygon);

}  // namespace odontoscope
