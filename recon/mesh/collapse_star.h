#pragma once
// The triangles round an edge that is about to be collapsed, and what speaks against a place for the vertex that it
// becomes. Inner part of collapse_guard.h and collapse_interfaces.h: needs CGAL's headers.

#include <algorithm>
#include <optional>
#include <vector>

#include "recon/mesh/moving_box_tree.h"
#include "recon/mesh/triangle_pairs.h"

namespace odontoscope {

enum class CollapseRefusal {
  far,     // the new vertex, or one of the old, would lie farther off the surface than the edge is long
  turned,  // a triangle would turn over
  flat,    // a triangle would have no area
  cuts,    // a triangle would cut or touch another
};

struct CollapseStar {
  using Point = ExactKernel::Point_3;

  PointIndex one = 0, other = 0;  // the edge's vertices; what they become keeps the number of the first
  Point one_at, other_at;
  /// Triangles that stay, as they are now; the corner in the middle is the one that moves.
  std::vector<NumberedTriangle> triangles;

  /// Triangle t with its middle corner moved.
  NumberedTriangle made(std::size_t t, const Point& placed) const;
  bool holds(PointIndex v) const { return v == one || v == other; }

  /// May a triangle come to face far elsewhere?
  enum class Turning { refused, allowed };
  /// What the star's own triangles have against it, measured in doubles but for `flat` and `cuts`.
  std::optional<CollapseRefusal> refusal(const Point& placed, Turning turning) const;

 private:
  bool strays(const Point& placed) const;
  bool turns(const Point& placed) const;
  bool flattens(const Point& placed) const;
  bool cuts_itself(const Point& placed) const;
};

/// Of its three corners.
MovingBox box_of(const NumberedTriangle& triangle);

/// Would a triangle of the star, with its vertex at `placed`, cut or touch one of the others? `tree` holds the boxes of
/// all triangles by number; `triangle(number)` gives one, `counts(triangle)` whether it is to be held against the
/// star's.
template <class TriangleOf, class Counts>
bool cuts_others(const CollapseStar& star, const CollapseStar::Point& placed, const MovingBoxTree& tree,
                 TriangleOf triangle, Counts counts) {
  for (std::size_t t = 0; t < star.triangles.size(); ++t) {
    const NumberedTriangle made = star.made(t, placed);
    const bool cut = tree.any(box_of(made), [&](std::uint32_t number) {
      const NumberedTriangle other = triangle(number);
      const bool own =
          std::any_of(other.number.begin(), other.number.end(), [&](PointIndex v) { return star.holds(v); });
      return !own && counts(other) && meet_elsewhere(made, other);
    });
    if (cut) return true;
  }
  return false;
}

}  // namespace odontoscope
