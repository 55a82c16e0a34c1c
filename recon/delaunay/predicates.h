#pragma once
// The exact decisions of the slab walk. Each is evaluated in rounded arithmetic with a proven error bound first and in
// exact arithmetic where that cannot decide.
//
// Ties are the rule on voxel data (cospherical points), so they are broken by one symbolic perturbation for a whole
// slab: the upper slice is thought to be moved sideways by (e, e^2), e infinitely small. That makes the overlay of the
// two Voronoi diagrams generic, whatever the input, and leaves each slice's own triangulation and the sign of every
// tetrahedron as they are: an upper and a lower edge that are parallel never cross in the overlay, so no flat
// tetrahedron can arise.

#include <cstdint>

#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

enum class Side { lower, upper };

/// Which of two sites of the slice `sites` is nearer to a point of the other slice, both moved as the perturbation
/// says? Negative: p; positive: q; never 0 for p != q.
int nearer_to_centre(const Planar& of, TriangleIndex triangle, Point2 p, Point2 q, Side sites);
int nearer_to_midpoint(Point2 a, Point2 b, Point2 p, Point2 q, Side sites);

/// Is the circumcentre (of the slice opposite to `wedge`) on the left of the directed line p->q of the slice `wedge`?
/// Never 0.
int centre_left_of(const Planar& of, TriangleIndex triangle, Point2 p, Point2 q, Side wedge);

/// Sign of the cross product (b-a) x (d-c), exactly.
int turn(Point2 a, Point2 b, Point2 c, Point2 d);

/// Sign of det(b-a, c-a, d-a), exactly: positive for a positive tetrahedron.
int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Circumcentre of the counter-clockwise triangle abc with its error bound.
Circumcentre circumcentre(Point2 a, Point2 b, Point2 c);

}  // namespace odontoscope::delaunay
