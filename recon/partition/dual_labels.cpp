#include "recon/partition/dual_labels.h"

#include "recon/core/error.h"
#include "recon/delaunay/predicates.h"

namespace odontoscope::partition {
namespace {

using delaunay::EdgeKind;
using delaunay::none;
using delaunay::Planar;
using delaunay::Side;
using delaunay::SlabTetrahedron;

std::uint32_t spoke_to(const Planar& planar, std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t s = planar.first_spoke[a]; s < planar.first_spoke[a + 1]; ++s)
    if (planar.spokes[s].vertex == b) return s;
  throw InternalError("a slab has an edge that its slice lacks");
}

/// The triangle on the right of the spoke of `a`.
std::uint32_t right_of(const Planar& planar, std::uint32_t a, std::uint32_t spoke) {
  const std::uint32_t first = planar.first_spoke[a], end = planar.first_spoke[a + 1];
  return planar.spokes[spoke == first ? end - 1 : spoke - 1].triangle;
}

/// A triangle of the sector at p in which the circumcentre of a triangle of the other slice lies. Precondition: p is
/// its nearest point, so that no border but those at p comes between.
std::uint32_t sector_triangle(const Planar& of, std::uint32_t triangle, const PartitionSlice& slice, std::uint32_t p,
                              Side side) {
  const Planar& planar = slice.planar;
  std::vector<std::uint32_t> borders;
  for (std::uint32_t s = planar.first_spoke[p]; s < planar.first_spoke[p + 1]; ++s)
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
std::uint32_t lower_triangle(const SlabTetrahedron& tet, const PartitionSlice& lower, const Planar& upper) {
  const auto count = static_cast<std::uint32_t>(lower.planar.points.size());
  const EdgeSides sides = sides_of(lower, tet.v[0], tet.v[1]);
  if (!sides.border()) return sides.left_triangle;
  const bool before =
      delaunay::nearer_to_midpoint(lower.planar.points[tet.v[0]], lower.planar.points[tet.v[1]],
                                   upper.points[tet.v[2] - count], upper.points[tet.v[3] - count], Side::upper) > 0;
  return before ? sides.left_triangle : sides.right_triangle;
}

/// The crossing lies between the circumcentre on one side of cd and the midpoint exactly if the bisector of a and b
/// separates them.
std::uint32_t upper_triangle(const SlabTetrahedron& tet, const Planar& lower, const PartitionSlice& upper) {
  const auto count = static_cast<std::uint32_t>(lower.points.size());
  const std::uint32_t c = tet.v[2] - count, d = tet.v[3] - count;
  const std::uint32_t spoke = spoke_to(upper.planar, c, d);
  const std::uint32_t left = upper.planar.spokes[spoke].triangle, right = right_of(upper.planar, c, spoke);
  if (upper.label(left) == upper.label(right)) return left;
  const Point2 a = lower.points[tet.v[0]], b = lower.points[tet.v[1]];
  const bool midpoint_near_b =
      delaunay::nearer_to_midpoint(upper.planar.points[c], upper.planar.points[d], a, b, Side::lower) > 0;
  const std::uint32_t asked = left != none ? left : right;
  const bool beside_asked = (delaunay::nearer_to_centre(upper.planar, asked, a, b, Side::lower) > 0) != midpoint_near_b;
  return beside_asked == (asked == left) ? left : right;
}

}  // namespace

EdgeSides sides_of(const PartitionSlice& slice, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t spoke = spoke_to(slice.planar, a, b);
  const std::uint32_t left = slice.planar.spokes[spoke].triangle, right = right_of(slice.planar, a, spoke);
  return {left, right, slice.label(left), slice.label(right)};
}

std::vector<DualTriangles> dual_triangles(const std::vector<SlabTetrahedron>& tetrahedra, const PartitionSlice& lower,
                                          const PartitionSlice& upper) {
  const auto count = static_cast<std::uint32_t>(lower.planar.points.size());
  std::vector<DualTriangles> duals(tetrahedra.size());
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    const SlabTetrahedron& tet = tetrahedra[t];
    if (tet.lower_count == 3) {
      duals[t] = {tet.triangle, sector_triangle(lower.planar, tet.triangle, upper, tet.v[3] - count, Side::upper)};
    } else if (tet.lower_count == 1) {
      duals[t] = {sector_triangle(upper.planar, tet.triangle, lower, tet.v[0], Side::lower), tet.triangle};
    } else {
      duals[t] = {lower_triangle(tet, lower, upper.planar), upper_triangle(tet, lower.planar, upper)};
    }
  }
  return duals;
}

}  // namespace odontoscope::partition
