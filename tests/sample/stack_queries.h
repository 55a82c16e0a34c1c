#pragma once
// Questions that the tests ask a contour stack, answered without the library's own geometry.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

inline double area(const std::vector<Point2>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 &p = points[i], &q = points[(i + 1) % points.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / 2;
}

inline Point2 centroid(const std::vector<Point2>& points) {
  Point2 sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 &p = points[i], &q = points[(i + 1) % points.size()];
    const double cross = p.x * q.y - p.y * q.x;
    sum = {sum.x + (p.x + q.x) * cross, sum.y + (p.y + q.y) * cross};
  }
  return {sum.x / (6 * area(points)), sum.y / (6 * area(points))};
}

inline bool inside(Point2 at, const std::vector<Point2>& points) {
  bool odd = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 &p = points[i], &q = points[(i + 1) % points.size()];
    if ((p.y > at.y) != (q.y > at.y) && at.x < p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x)) odd = !odd;
  }
  return odd;
}

/// Inside an odd number of the structure's contours.
inline bool in_region(Point2 at, const Slice& slice, const std::string& structure) {
  bool odd = false;
  for (const Contour& contour : slice.contours)
    if (contour.structure == structure && inside(at, contour.points)) odd = !odd;
  return odd;
}

/// Contours of a structure that lie inside an even number (outer = true) or odd number (holes) of its others.
inline std::vector<const Contour*> contours(const Slice& slice, const std::string& structure, bool outer) {
  std::vector<const Contour*> found;
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    bool odd = false;
    for (const Contour& other : slice.contours)
      if (&other != &contour && other.structure == structure && inside(contour.points.front(), other.points))
        odd = !odd;
    if (odd != outer) found.push_back(&contour);
  }
  return found;
}

inline std::size_t count(const Slice& slice, const std::string& structure, bool outer = true) {
  return contours(slice, structure, outer).size();
}

inline const Slice& slice_at(const ContourStack& stack, double z) {
  const Slice* nearest = &stack.slices.front();
  for (const Slice& slice : stack.slices)
    if (std::abs(slice.z - z) < std::abs(nearest->z - z)) nearest = &slice;
  return *nearest;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double size() const { return high - low; }
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

struct Extents {
  Extent x, y, z;
};

/// Of all structures between two heights.
inline Extents extents(const ContourStack& stack, double low_z, double high_z) {
  Extents result;
  for (const Slice& slice : stack.slices) {
    if (slice.z < low_z || slice.z > high_z) continue;
    for (const Contour& contour : slice.contours) {
      for (const Point2& p : contour.points) {
        result.x.add(p.x);
        result.y.add(p.y);
        result.z.add(slice.z);
      }
    }
  }
  return result;
}

}  // namespace odontoscope::test
