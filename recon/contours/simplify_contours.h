#pragma once
// Fewer points for the same contours: greedy removal of the point whose loss changes its contour least, while the
// topology of the whole slice stays as it is.
//
// Dyken, Dæhlen and Sevaldrud, "Simultaneous curve simplification" (2009), with the distance to the replaced points as
// cost, which is also what CGAL's Polyline_simplification_2 does. A point may go if the triangle that it spans with its
// two neighbours holds no other point of the slice (exact orientation test) and its neighbours are not joined already:
// then no edge can lie in the new edge's way. So contours stay closed, simple and disjoint, nesting stays, and each
// keeps at least three points.
//
// All structures of a slice are treated at once. Where contours of different structures coincide (same points, same
// edges) they lose the same points and go on coinciding; a point where they part stays. Where they cross, or touch
// elsewhere than in points of both, each stays valid for itself but the crossing may move by up to the tolerance.

#include <cstddef>

#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

struct SimplifyContoursOptions {
  /// Largest distance between a contour and its simplification, either way, mm. 0 removes only points on straight
  /// lines.
  double tolerance = 0;
};

struct SimplifiedContours {
  /// Slices and contours as they were; each contour keeps its order and starts at its first point that is left.
  ContourStack stack;
  std::size_t points_before = 0;
  std::size_t points_after = 0;
  /// Measured Hausdorff distance between a contour and its simplification, the largest of all, mm; at most the
  /// tolerance.
  double largest_deviation = 0;
};

/// Precondition: `validate` passed. Slices run in parallel; the result depends neither on the number of threads nor on
/// which point a contour starts at. Stage "simplify". Throws UsageError for a tolerance that is negative or not finite.
SimplifiedContours simplify_contours(const ContourStack& stack, const SimplifyContoursOptions& options,
                                     const Progress& progress = {});

struct SimplifiedSlice {
  Slice slice;
  /// As in SimplifiedContours.
  double largest_deviation = 0;
};

/// The same for one slice, on the calling thread. Precondition: the tolerance is finite and not negative.
SimplifiedSlice simplify_slice(const Slice& slice, double tolerance);

}  // namespace odontoscope
