#pragma once
// In which faces of the two slices the dual point of each tetrahedron of a slab lies.

#include <vector>

#include "recon/delaunay/slab.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

/// A triangle of each slice that lies in the same face as the dual point; none: outside the hull.
struct DualTriangles {
  delaunay::TriangleIndex lower, upper;
};

/// `tetrahedra` from delaunay::bare_slab of the two slices' triangulations. Exact where borders are Gabriel; where they
/// are only Delaunay, it may be one on the other side of a gap.
Table<delaunay::TetIndex, DualTriangles> dual_triangles(const delaunay::SlabTetrahedra& tetrahedra,
                                                        const PartitionSlice& lower, const PartitionSlice& upper);

/// The triangles and labels on both sides of the edge from a to b, seen from +z.
struct EdgeSides {
  delaunay::TriangleIndex left_triangle, right_triangle;
  Label left = void_label, right = void_label;
  bool border() const { return left != right; }
  bool has(Label label) const { return left == label || right == label; }
  /// On the side of this label. Precondition: has(label).
  delaunay::TriangleIndex triangle(Label label) const { return left == label ? left_triangle : right_triangle; }
};
EdgeSides sides_of(const PartitionSlice& slice, delaunay::SlicePoint a, delaunay::SlicePoint b);

}  // namespace odontoscope::partition
