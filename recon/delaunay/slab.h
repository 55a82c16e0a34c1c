#pragma once
// The 3D Delaunay triangulation of a slab, walked from the plane triangulations of its two slices.
//
// A sphere through points of both planes is centred above a point c of the overlay of the two Voronoi diagrams, and it
// is empty exactly if its circle in each plane is. So the tetrahedra are the vertices of that overlay (their dual
// points):
//   3-1: the circumcentre of a lower triangle, its apex the nearest upper point;  1-3: the other way round;
//   2-2: a crossing of a lower with an upper Voronoi edge.
// The combinatorics do not depend on the slab's height. Boissonnat, "Shape reconstruction from planar cross sections"
// (1988), has the duality; the exact walk with one symbolic perturbation is ours (predicates.h).

#include <array>
#include <cstdint>
#include <vector>

#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

/// Points of a slab: those of the lower slice count from 0, those of the upper from lower.points.size().
using SlabPoint = Index<struct SlabPointKind>;
using TetIndex = Index<struct SlabTetrahedronKind>;

struct SlabTetrahedron {
  std::array<SlabPoint, 4> v;    // positive; lower points first
  std::array<TetIndex, 4> nb;    // across the face opposite v[i]; none on the hull and in the slices
  TriangleIndex triangle;        // of a 3-1 or 1-3: its in-plane triangle, in its slice's triangulation
  std::uint8_t lower_count = 0;  // 3, 2 or 1
  EdgeKind lower_edge = EdgeKind::external, upper_edge = EdgeKind::external;  // of a 2-2
  bool dual_in_lower = false, dual_in_upper = false;  // does the dual point lie in a region of that slice?
};

using SlabTetrahedra = Table<TetIndex, SlabTetrahedron>;

/// How a slab numbers the points of its slices.
struct SlabNumbers {
  std::uint32_t in_lower = 0;  // points of the lower slice

  explicit SlabNumbers(const Planar& lower) : in_lower(static_cast<std::uint32_t>(lower.points.size())) {}
  bool is_lower(SlabPoint v) const { return v < in_lower; }
  SlabPoint of_lower(SlicePoint p) const { return SlabPoint(p); }
  SlabPoint of_upper(SlicePoint p) const { return SlabPoint(in_lower + p); }
  /// The number in its own slice.
  SlicePoint own(SlabPoint v) const { return SlicePoint(is_lower(v) ? v : v - in_lower); }
};

/// Precondition: both triangulations are non-empty, with Gabriel contour edges (with Delaunay ones `dual_in_lower` and
/// `dual_in_upper` may be wrong beside narrow gaps, all else holds). Linear in the size of input and output on
/// well-spread points. The order of the result depends on the input alone.
SlabTetrahedra triangulate_slab(const Planar& lower, const Planar& upper);

/// The same, without neighbours: enough to see which regions lie over each other.
SlabTetrahedra walked_slab(const Planar& lower, const Planar& upper);

/// The same of points without contours: nothing is told of regions (edge kinds and `dual_in_...` are left as they are).
/// With neighbours. Of a 2-2 with corners (a, b, c, d) the Voronoi edge of ab, walked from the left of a->b to its
/// right, passes from the cell of c to that of d.
SlabTetrahedra bare_slab(const Planar& lower, const Planar& upper);

/// For each face of `tetrahedra` the tetrahedron beyond it (none: only one has it). Throws InternalError if three share
/// a face.
void link_neighbours(SlabTetrahedra& tetrahedra);

}  // namespace odontoscope::delaunay
