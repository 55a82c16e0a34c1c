#pragma once
// Slabs to be blended, and what is true of them, found in ways of the tests' own.

#include <cstddef>
#include <functional>
#include <vector>

#include "recon/between/blend.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {

using between::Outline;

/// A hole: the ring turned round.
Ring hole(Ring ring);
/// All contours moved.
Outline moved(Outline outline, Point2 by);
/// The outline of one structure, outer contours counter-clockwise, holes clockwise.
Outline outline_of(const Slice& slice, const std::string& structure);

/// For each point of a lattice of `columns` x `columns` over the box the innermost contour that it lies in, or
/// `outside`.
struct Picture {
  Point2 low;
  double step = 0;
  int columns = 0;
  std::vector<std::size_t> innermost;
};
Picture picture(const Outline& outline, Point2 low, double side, int columns);

/// Material at a point: an odd number of contours around it.
bool covers(const Outline& outline, Point2 at);

/// Every two regions, and every two voids, that share a point of a lattice are linked.
struct Links {
  std::vector<between::ContourLink> material, voids;
};
Links overlap_links(const Outline& lower, const Outline& upper);

/// Distance to the nearest contour, negative in material: every edge is looked at.
double distance(const Outline& outline, Point2 at);

double area(const Outline& outline);

/// Area in which the outline and a shape (true inside) differ, counted on a lattice of points.
double area_in_wrong(const Outline& outline, const std::function<bool(Point2)>& shape, Point2 low, double side,
                     int columns);

std::size_t points_in(const Outline& outline);

}  // namespace odontoscope::test
