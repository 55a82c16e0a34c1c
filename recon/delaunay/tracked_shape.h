#pragma once
// Sections of material or of void, as they are followed from slice to slice.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/delaunay/voids.h"

namespace odontoscope::delaunay {

inline constexpr std::size_t no_contour = std::numeric_limits<std::size_t>::max();

/// A region, or a void. `area` (mm2), `centroid` and `radius` (of the circle of that area) are those of its outline,
/// filled: a hole that comes or goes does not move the thing.
struct TrackedShape {
  std::vector<std::vector<Point2>> contours;  // the outline, counter-clockwise, then what is taken out of it, clockwise
  bool unbounded = false;                     // the outside: no outline, only what is taken out
  Point2 centroid;
  double area = 0, radius = 0;
  Point2 low, high;                  // the outline's box
  std::size_t contour = no_contour;  // the outline's number in the slice's list
};

struct ShapeSlice {
  double z = 0;
  std::vector<TrackedShape> shapes;
};

/// Shape r is region r.
ShapeSlice region_shapes(const ConformedSlice& slice);

/// Shape v is void v; shape 0 is the outside.
ShapeSlice void_shapes(const ConformedSlice& slice, const SliceVoids& voids);

/// Area of a shape without what is taken out of it. Precondition: bounded.
double net_area(const TrackedShape& shape);

/// Area, mm2, that `moved`, moved by `by`, has in common with `still`, to rounding. Precondition: `moved` is bounded.
/// The indicator of a polygon is the signed sum of those of what lies below its edges, so the area is a sum over
/// pairs of edges, and no case is special.
double overlap_area(const TrackedShape& moved, Point2 by, const TrackedShape& still);

/// That area over the net area of the smaller shape.
double overlap_share(const TrackedShape& a, const TrackedShape& b);

}  // namespace odontoscope::delaunay
