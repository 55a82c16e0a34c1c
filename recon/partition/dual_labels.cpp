#include "recon/partition/dual_labels.h"

#include "recon/core/error.h"
#include "recon/delaunay/predicates.h"

namespace odontoscope::partition {
namespace {

using delaunay::EdgeKind;
using delaunay::none;
using delaunay::Planar;
using delaunay::Side;
using delaunay::SlabNumbers;
using delaunay::SlabTetrahedra;
using delaunay::SlabTetrahedron;
using delaunay::SlicePoint;
using delaunay::SpokeIndex;
using delaunay::TetIndex;
using delaunay::TriangleIndex;

SpokeIndex spoke_to(const Planar& planar, SlicePoint a, SlicePoint b) {
  for (const SpokeIndex s : planar.spokes_of(a))
    if (planar.spokes[s].vertex == b) return s;
  throw InternalError("a slab has an edge that its slice lacks");
}

/// A triangle of the sector at p in which the circumcentre of a triangle of the other slice lies. Precondition: p is
/// its nearest point, so that no border but those at p comes between.
TriangleIndex sector_triangle(const Planar& of, TriangleIndex triangle, const PartitionSlice& slice, SlicePoint p,
                              Side side) {
  const Planar& planar = slice.planar;
  std::vector<SpokeIndex> borders;
  for (const SpokeIndex s : planar.spokes_of(p))
    if (planar.spokes[s].kind == EdgeKind::contour) borders.push_back(s);
  if (borders.empty()) return planar.spokes[planar.first_spoke[p]].triangle;
  const Point2 at = planar.points[p];
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const Point2 q = planar.points[planar.spokes[borders[i]].vertex];
    const Point2 r = planar.points[planar.spokes[borders[(i + 1) % borders.size()]].vertex];
    const bool left = delaunay::centre_left_of(of, triangle, at, q, side) > 0;
    const bool right = delaunay::centre_left_of(of, triangle, at, r, side) < 0;
    if (delaunay::turn(at, q, at, r) > 0 ? left && right : left || right) return planar.spokes[borders[i]].triangle;
  }
  return planar.spokes[borders.back()].triangle;
}

/// Of a 2-2: along the Voronoi edge of ab the side changes at its midpoint, and the walk has crossed from c to d before
/// that exactly if the midpoint is nearer to d.
TriangleIndex lower_triangle(const SlabTetrahedron& tet, const PartitionSlice& lower, const Planar& upper) {
  const SlabNumbers numbers(lower.planar);
  const SlicePoint a = numbers.own(tet.v[0]), b = numbers.own(tet.v[1]);
  const EdgeSides sides = sides_of(lower, a, b);
  if (!sides.border()) return sides.left_triangle;
  const bool before =
      delaunay::nearer_to_midpoint(lower.planar.points[a], lower.planar.points[b], upper.points[numbers.own(tet.v[2])],
                                   upper.points[numbers.own(tet.v[3])], Side::upper) > 0;
  return before ? sides.left_triangle : sides.right_triangle;
}

/// The crossing lies between the circumcentre on one side of cd and the midpoint exactly if the bisector of a and b
/// separates them.
TriangleIndex upper_triangle(const SlabTetrahedron& tet, const Planar& lower, const PartitionSlice& upper) {
  const SlabNumbers numbers(lower);
  const SlicePoint c = numbers.own(tet.v[2]), d = numbers.own(tet.v[3]);
  const SpokeIndex spoke = spoke_to(upper.planar, c, d);
  const TriangleIndex left = upper.planar.spokes[spoke].triangle, right = upper.planar.right_of(c, spoke);
  if (upper.label(left) == upper.label(right)) return left;
  const Point2 a = lower.points[numbers.own(tet.v[0])], b = lower.points[numbers.own(tet.v[1])];
  const bool midpoint_near_b =
      delaunay::nearer_to_midpoint(upper.planar.points[c], upper.planar.points[d], a, b, Side::lower) > 0;
  const TriangleIndex asked = left != none ? left : right;
  const bool beside_asked = (delaunay::nearer_to_centre(upper.planar, asked, a, b, Side::lower) > 0) != midpoint_near_b;
  return beside_asked == (asked == left) ? left : right;
}

}  // namespace

EdgeSides sides_of(const PartitionSlice& slice, SlicePoint a, SlicePoint b) {
  const SpokeIndex spoke = spoke_to(slice.planar, a, b);
  const TriangleIndex left = slice.planar.spokes[spoke].triangle, right = slice.planar.right_of(a, spoke);
  return {left, right, slice.label(left), slice.label(right)};
}

Table<TetIndex, DualTriangles> dual_triangles(const SlabTetrahedra& tetrahedra, const PartitionSlice& lower,
                                              const PartitionSlice& upper) {
  const SlabNumbers numbers(lower.planar);
  Table<TetIndex, DualTriangles> duals(tetrahedra.size());
  for (const TetIndex t : tetrahedra.indices()) {
    const SlabTetrahedron& tet = tetrahedra[t];
    if (tet.lower_count == 3) {
      duals[t] = {tet.triangle, sector_triangle(lower.planar, tet.triangle, upper, numbers.own(tet.v[3]), Side::upper)};
    } else if (tet.lower_count == 1) {
      duals[t] = {sector_triangle(upper.planar, tet.triangle, lower, numbers.own(tet.v[0]), Side::lower), tet.triangle};
    } else {
      duals[t] = {lower_triangle(tet, lower, upper.planar), upper_triangle(tet, lower.planar, upper)};
    }
  }
  return duals;
}

}  // namespace odontoscope::partition
