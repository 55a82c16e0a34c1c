#pragma once
// Closed polygons of the plane: the last point joins the first. For places, areas and distances in doubles, about the
// first point, so that far from the origin nothing is lost; where a sign decides, the caller brings an exact predicate.

#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

using Polygon = std::vector<Point2>;

/// Positive if counter-clockwise; 0 for fewer than three points.
double signed_area(const Polygon& polygon);

/// Area, centroid and spread of what polygons enclose together: holes turn the other way.
class AreaMoments {
 public:
  /// Sums are taken about `base`, which should lie near.
  explicit AreaMoments(Point2 base) : base_(base) {}
  explicit AreaMoments(const Polygon& polygon) : base_(polygon.front()) { add(polygon); }
  void add(const Polygon& polygon);

  double signed_area() const { return twice_ / 2; }
  /// Not finite, or far off, where the area is nothing but rounding.
  Point2 centroid() const;
  /// Mean square distance from the centroid; as the centroid where there is no area.
  double mean_square() const;

 private:
  Point2 base_;
  double twice_ = 0, x_ = 0, y_ = 0, squares_ = 0;
};

/// Of what the polygon encloses; its first point if that is nothing.
Point2 centroid(const Polygon& polygon);

/// Does the polygon enclose the place? By the parity of the edges that a ray along x crosses, so that winding plays no
/// part. A corner as high as the place counts as below it, everywhere. `passes(a, b)` is asked of each edge that passes
/// the place's height: does the ray cross it?
template <class Passes>
bool encloses(const Polygon& polygon, Point2 place, Passes passes) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if ((a.y > place.y) != (b.y > place.y) && passes(a, b)) inside = !inside;
  }
  return inside;
}

/// In doubles: within rounding of an edge it may say either.
inline bool encloses(const Polygon& polygon, Point2 place) {
  return encloses(polygon, place, [place](const Point2& a, const Point2& b) {
    return place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x);
  });
}

/// How often the polygon turns round the place, counter-clockwise.
int winding(const Polygon& polygon, Point2 place);

/// The edge's place nearest to `p`: 0 at `a`, 1 at `b`; 0 if the two are one.
double nearest_share(const Point2& p, const Point2& a, const Point2& b);
double distance_to_edge(const Point2& p, const Point2& a, const Point2& b);
/// To the nearest edge.
double distance_to_border(const Point2& p, const Polygon& polygon);

}  // namespace odontoscope
