#include "recon/delaunay/slab.h"

#include <algorithm>

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/predicates.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::delaunay {
namespace {

/// The Voronoi cell of `site` that holds the circumcentre `triangle` of the other slice: greedy descent over Delaunay
/// neighbours, which cannot stop before the nearest site.
SlicePoint locate(const Planar& of, TriangleIndex triangle, const Planar& sites, Side side, SlicePoint start) {
  SlicePoint site = start;
  for (bool moved = true; moved;) {
    moved = false;
    for (const SpokeIndex s : sites.spokes_of(site)) {
      const SlicePoint other = sites.spokes[s].vertex;
      if (nearer_to_centre(of, triangle, sites.points[other], sites.points[site], side) < 0) {
        site = other;
        moved = true;
        break;
      }
    }
  }
  return site;
}

/// For each triangle of `of` the nearest point of `sites`.
Table<TriangleIndex, SlicePoint> apexes(const Planar& of, const Planar& sites, Side side) {
  Table<TriangleIndex, SlicePoint> apex(of.triangles.size(), none);
  constexpr TriangleIndex first(0);
  std::vector<TriangleIndex> stack{first};
  apex[first] = locate(of, first, sites, side, SlicePoint(0));
  while (!stack.empty()) {
    const TriangleIndex t = stack.back();
    stack.pop_back();
    for (const TriangleIndex other : of.triangles[t].nb) {
      if (other == none || apex[other] != none) continue;
      apex[other] = locate(of, other, sites, side, apex[t]);
      stack.push_back(other);
    }
  }
  return apex;
}

/// Is the circumcentre of `triangle` inside the region at contour point `p` of `wedge`? Precondition: p is its nearest
/// point.
bool inside_wedge(const Planar& of, TriangleIndex triangle, const Planar& wedge, SlicePoint p, Side side) {
  const Point2 before = wedge.points[wedge.previous[p]], at = wedge.points[p], after = wedge.points[wedge.next[p]];
  const bool left_in = centre_left_of(of, triangle, before, at, side) > 0;
  const bool left_out = centre_left_of(of, triangle, at, after, side) > 0;
  return turn(before, at, at, after) > 0 ? left_in && left_out : left_in || left_out;
}

/// A lower Delaunay edge a->b, whose Voronoi edge is walked from the left of a->b to its right.
struct LowerEdge {
  SlicePoint a, b;
  EdgeKind kind;
  bool left_inside;  // of a contour edge: is the region on the left of a->b?
};

/// `regions`: the slices have contours, of which it tells which side a dual point lies on.
template <bool regions>
class SlabWalk {
 public:
  SlabWalk(const Planar& lower, const Planar& upper) : lower_(lower), upper_(upper), numbers_(lower) {}

  SlabTetrahedra run() {
    const Table<TriangleIndex, SlicePoint> up = apexes(lower_, upper_, Side::upper);
    const Table<TriangleIndex, SlicePoint> down = apexes(upper_, lower_, Side::lower);
    result_.reserve(2 * (lower_.triangles.size() + upper_.triangles.size()));
    for (const TriangleIndex t : lower_.triangles.indices()) add_3_1(t, up[t]);
    for (const TriangleIndex t : upper_.triangles.indices()) add_1_3(t, down[t]);
    for (const TriangleIndex t : lower_.triangles.indices())
      for (int k = 0; k < 3; ++k) {
        const TriangleIndex other = lower_.triangles[t].nb[k];
        if (other == none || t < other) walk(t, k, up[t], other == none ? SlicePoint() : up[other]);
      }
    return std::move(result_);
  }

 private:
  void add_3_1(TriangleIndex t, SlicePoint apex) {
    SlabTetrahedron tet;
    const auto& v = lower_.triangles[t].v;
    tet.v = {numbers_.of_lower(v[0]), numbers_.of_lower(v[1]), numbers_.of_lower(v[2]), numbers_.of_upper(apex)};
    tet.triangle = t;
    tet.lower_count = 3;
    if constexpr (regions) {
      tet.dual_in_lower = lower_.inside(t);
      tet.dual_in_upper = inside_wedge(lower_, t, upper_, apex, Side::upper);
    }
    result_.push_back(tet);
  }

  void add_1_3(TriangleIndex t, SlicePoint apex) {
    SlabTetrahedron tet;
    const auto& v = upper_.triangles[t].v;
    tet.v = {numbers_.of_lower(apex), numbers_.of_upper(v[0]), numbers_.of_upper(v[1]), numbers_.of_upper(v[2])};
    tet.triangle = t;
    tet.lower_count = 1;
    if constexpr (regions) {
      tet.dual_in_upper = upper_.inside(t);
      tet.dual_in_lower = inside_wedge(upper_, t, lower_, apex, Side::lower);
    }
    result_.push_back(tet);
  }

  /// Follows the Voronoi edge between triangle `from` and its neighbour across edge k through the cells of the upper
  /// slice.
  void walk(TriangleIndex from, int k, SlicePoint start_cell, SlicePoint end_cell) {
    const PlanarTriangle& triangle = lower_.triangles[from];
    LowerEdge edge{triangle.v[(k + 1) % 3], triangle.v[(k + 2) % 3], EdgeKind::external, false};
    if constexpr (regions) {
      if (lower_.contour_edge(edge.a, edge.b)) {
        edge.kind = EdgeKind::contour;
        edge.left_inside = lower_.next[edge.a] == edge.b;
      } else if (lower_.inside(from)) {
        edge.kind = EdgeKind::internal;
      }
    }
    SlicePoint cell = start_cell;
    for (std::size_t steps = 0; cell != end_cell; ++steps) {
      const SpokeIndex spoke = exit_of(cell, edge);
      if (spoke == none) {
        if (end_cell != none) throw InternalError("a Voronoi edge left the slab before its end");
        return;
      }
      if (steps > upper_.points.size()) throw InternalError("a Voronoi edge went in circles");
      add_2_2(edge, cell, spoke);
      cell = upper_.spokes[spoke].vertex;
    }
  }

  /// Is the upper circumcentre nearer to b than to a?
  bool centre_near_b(TriangleIndex upper_triangle, const LowerEdge& edge) const {
    return nearer_to_centre(upper_, upper_triangle, lower_.points[edge.a], lower_.points[edge.b], Side::lower) > 0;
  }

  /// The spoke across whose Voronoi edge the bisector of a and b, coming from the left of a->b, leaves the cell: going
  /// round the cell counter-clockwise, where "nearer to a" turns into "nearer to b". none: it leaves through the hull's
  /// gap.
  SpokeIndex exit_of(SlicePoint cell, const LowerEdge& edge) const {
    const Indices<SpokeIndex> spokes = upper_.spokes_of(cell);
    const SpokeIndex first = spokes.front(), last = spokes.back();
    const bool on_hull = upper_.spokes[last].triangle == none;
    bool near_b = on_hull ? end_near_b(cell, first, edge) : centre_near_b(upper_.spokes[last].triangle, edge);
    for (const SpokeIndex s : spokes) {
      const bool then =
          on_hull && s == last ? end_near_b(cell, last, edge) : centre_near_b(upper_.spokes[s].triangle, edge);
      if (!near_b && then) return s;
      near_b = then;
    }
    return none;
  }

  /// The same for the far end of the Voronoi ray of the hull edge from `cell` along `spoke` (its first or last).
  bool end_near_b(SlicePoint cell, SpokeIndex spoke, const LowerEdge& edge) const {
    const bool is_last = upper_.spokes[spoke].triangle == none;
    const Point2 p = upper_.points[cell], q = upper_.points[upper_.spokes[spoke].vertex];
    const Point2 a = lower_.points[edge.a], b = lower_.points[edge.b];
    // The ray runs along q-p turned by a quarter, to its left for the last spoke and to its right for the first; its
    // scalar product with b-a is (q-p) x (b-a), or minus that.
    const int along = turn(p, q, a, b);
    if (along != 0) return (along > 0) == is_last;
    return centre_near_b(upper_.spokes[is_last ? SpokeIndex(spoke - 1) : spoke].triangle, edge);
  }

  void add_2_2(const LowerEdge& edge, SlicePoint cell, SpokeIndex spoke) {
    const SlicePoint other = upper_.spokes[spoke].vertex;
    SlabTetrahedron tet;
    tet.v = {numbers_.of_lower(edge.a), numbers_.of_lower(edge.b), numbers_.of_upper(cell), numbers_.of_upper(other)};
    tet.lower_count = 2;
    if constexpr (regions) {
      tet.lower_edge = edge.kind;
      tet.upper_edge = upper_.spokes[spoke].kind;
      tet.dual_in_lower =
          edge.kind == EdgeKind::internal || (edge.kind == EdgeKind::contour && dual_inside(edge, cell, other));
      tet.dual_in_upper = tet.upper_edge == EdgeKind::internal ||
                          (tet.upper_edge == EdgeKind::contour && dual_inside_upper(edge, cell, other, spoke));
    }
    result_.push_back(tet);
  }

  /// A contour edge is Gabriel, so its Voronoi edge passes from outside to inside at its midpoint m. The walk has
  /// crossed from `cell` to `other` before m exactly if m is nearer to `other`.
  bool dual_inside(const LowerEdge& edge, SlicePoint cell, SlicePoint other) const {
    const bool before_m = nearer_to_midpoint(lower_.points[edge.a], lower_.points[edge.b], upper_.points[cell],
                                             upper_.points[other], Side::upper) > 0;
    return before_m == edge.left_inside;
  }

  /// The crossing lies between the inner circumcentre and the midpoint exactly if the bisector of a and b separates
  /// them.
  bool dual_inside_upper(const LowerEdge& edge, SlicePoint cell, SlicePoint other, SpokeIndex spoke) const {
    const TriangleIndex inner =
        upper_.next[cell] == other ? upper_.spokes[spoke].triangle : upper_.right_of(cell, spoke);
    const bool midpoint_near_b = nearer_to_midpoint(upper_.points[cell], upper_.points[other], lower_.points[edge.a],
                                                    lower_.points[edge.b], Side::lower) > 0;
    return centre_near_b(inner, edge) != midpoint_near_b;
  }

  const Planar& lower_;
  const Planar& upper_;
  SlabNumbers numbers_;
  SlabTetrahedra result_;
};

}  // namespace

SlabTetrahedra walked_slab(const Planar& lower, const Planar& upper) { return SlabWalk<true>(lower, upper).run(); }

SlabTetrahedra bare_slab(const Planar& lower, const Planar& upper) {
  SlabTetrahedra tetrahedra = SlabWalk<false>(lower, upper).run();
  link_neighbours(tetrahedra);
  return tetrahedra;
}

SlabTetrahedra triangulate_slab(const Planar& lower, const Planar& upper) {
  SlabTetrahedra tetrahedra = walked_slab(lower, upper);
  link_neighbours(tetrahedra);
  return tetrahedra;
}

void link_neighbours(SlabTetrahedra& tetrahedra) {
  FaceTable table(tetrahedra.size() * 4);
  constexpr std::uint32_t taken = FaceTable::vacant - 1;
  for (const TetIndex t : tetrahedra.indices())
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto& v = tetrahedra[t].v;
      std::uint32_t& seen = table(v[outward_face[i][0]], v[outward_face[i][1]], v[outward_face[i][2]]);
      if (seen == taken) throw InternalError("three tetrahedra of a slab share a face");
      if (seen == FaceTable::vacant) {
        seen = 4 * t + i;
      } else {
        const TetIndex other(seen / 4);
        tetrahedra[t].nb[i] = other;
        tetrahedra[other].nb[seen % 4] = t;
        seen = taken;
      }
    }
}

}  // namespace odontoscope::delaunay
