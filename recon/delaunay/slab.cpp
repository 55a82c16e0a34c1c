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
std::uint32_t locate(const Planar& of, std::uint32_t triangle, const Planar& sites, Side side, std::uint32_t start) {
  std::uint32_t site = start;
  for (bool moved = true; moved;) {
    moved = false;
    for (std::uint32_t s = sites.first_spoke[site]; s < sites.first_spoke[site + 1]; ++s) {
      const std::uint32_t other = sites.spokes[s].vertex;
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
std::vector<std::uint32_t> apexes(const Planar& of, const Planar& sites, Side side) {
  std::vector<std::uint32_t> apex(of.triangles.size(), none);
  std::vector<std::uint32_t> stack{0};
  apex[0] = locate(of, 0, sites, side, 0);
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (const std::uint32_t other : of.triangles[t].nb) {
      if (other == none || apex[other] != none) continue;
      apex[other] = locate(of, other, sites, side, apex[t]);
      stack.push_back(other);
    }
  }
  return apex;
}

/// Is the circumcentre of `triangle` inside the region at contour point `p` of `wedge`? Precondition: p is its nearest
/// point.
bool inside_wedge(const Planar& of, std::uint32_t triangle, const Planar& wedge, std::uint32_t p, Side side) {
  const Point2 before = wedge.points[wedge.previous[p]], at = wedge.points[p], after = wedge.points[wedge.next[p]];
  const bool left_in = centre_left_of(of, triangle, before, at, side) > 0;
  const bool left_out = centre_left_of(of, triangle, at, after, side) > 0;
  return turn(before, at, at, after) > 0 ? left_in && left_out : left_in || left_out;
}

/// A lower Delaunay edge a->b, whose Voronoi edge is walked from the left of a->b to its right.
struct LowerEdge {
  std::uint32_t a, b;
  EdgeKind kind;
  bool left_inside;  // of a contour edge: is the region on the left of a->b?
};

/// `regions`: the slices have contours, of which it tells which side a dual point lies on.
template <bool regions>
class SlabWalk {
 public:
  SlabWalk(const Planar& lower, const Planar& upper)
      : lower_(lower), upper_(upper), offset_(static_cast<std::uint32_t>(lower.points.size())) {}

  std::vector<SlabTetrahedron> run() {
    const std::vector<std::uint32_t> up = apexes(lower_, upper_, Side::upper);
    const std::vector<std::uint32_t> down = apexes(upper_, lower_, Side::lower);
    result_.reserve(2 * (lower_.triangles.size() + upper_.triangles.size()));
    for (std::uint32_t t = 0; t < lower_.triangles.size(); ++t) add_3_1(t, up[t]);
    for (std::uint32_t t = 0; t < upper_.triangles.size(); ++t) add_1_3(t, down[t]);
    for (std::uint32_t t = 0; t < lower_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t other = lower_.triangles[t].nb[k];
        if (other == none || t < other) walk(t, k, up[t], other == none ? none : up[other]);
      }
    return std::move(result_);
  }

 private:
  void add_3_1(std::uint32_t t, std::uint32_t apex) {
    SlabTetrahedron tet;
    const auto& v = lower_.triangles[t].v;
    tet.v = {v[0], v[1], v[2], offset_ + apex};
    tet.triangle = t;
    tet.lower_count = 3;
    if constexpr (regions) {
      tet.dual_in_lower = lower_.inside(t);
      tet.dual_in_upper = inside_wedge(lower_, t, upper_, apex, Side::upper);
    }
    result_.push_back(tet);
  }

  void add_1_3(std::uint32_t t, std::uint32_t apex) {
    SlabTetrahedron tet;
    const auto& v = upper_.triangles[t].v;
    tet.v = {apex, offset_ + v[0], offset_ + v[1], offset_ + v[2]};
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
  void walk(std::uint32_t from, int k, std::uint32_t start_cell, std::uint32_t end_cell) {
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
    std::uint32_t cell = start_cell;
    for (std::size_t steps = 0; cell != end_cell; ++steps) {
      const std::uint32_t spoke = exit_of(cell, edge);
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
  bool centre_near_b(std::uint32_t upper_triangle, const LowerEdge& edge) const {
    return nearer_to_centre(upper_, upper_triangle, lower_.points[edge.a], lower_.points[edge.b], Side::lower) > 0;
  }

  /// The spoke across whose Voronoi edge the bisector of a and b, coming from the left of a->b, leaves the cell: going
  /// round the cell counter-clockwise, where "nearer to a" turns into "nearer to b". none: it leaves through the hull's
  /// gap.
  std::uint32_t exit_of(std::uint32_t cell, const LowerEdge& edge) const {
    const std::uint32_t first = upper_.first_spoke[cell], last = upper_.first_spoke[cell + 1] - 1;
    const bool on_hull = upper_.spokes[last].triangle == none;
    bool near_b = on_hull ? end_near_b(cell, first, edge) : centre_near_b(upper_.spokes[last].triangle, edge);
    for (std::uint32_t s = first; s <= last; ++s) {
      const bool then =
          on_hull && s == last ? end_near_b(cell, last, edge) : centre_near_b(upper_.spokes[s].triangle, edge);
      if (!near_b && then) return s;
      near_b = then;
    }
    return none;
  }

  /// The same for the far end of the Voronoi ray of the hull edge from `cell` along `spoke` (its first or last).
  bool end_near_b(std::uint32_t cell, std::uint32_t spoke, const LowerEdge& edge) const {
    const bool is_last = upper_.spokes[spoke].triangle == none;
    const Point2 p = upper_.points[cell], q = upper_.points[upper_.spokes[spoke].vertex];
    const Point2 a = lower_.points[edge.a], b = lower_.points[edge.b];
    // The ray runs along q-p turned by a quarter, to its left for the last spoke and to its right for the first; its
    // scalar product with b-a is (q-p) x (b-a), or minus that.
    const int along = turn(p, q, a, b);
    if (along != 0) return (along > 0) == is_last;
    return centre_near_b(upper_.spokes[is_last ? spoke - 1 : spoke].triangle, edge);
  }

  void add_2_2(const LowerEdge& edge, std::uint32_t cell, std::uint32_t spoke) {
    const std::uint32_t other = upper_.spokes[spoke].vertex;
    SlabTetrahedron tet;
    tet.v = {edge.a, edge.b, offset_ + cell, offset_ + other};
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
  bool dual_inside(const LowerEdge& edge, std::uint32_t cell, std::uint32_t other) const {
    const bool before_m = nearer_to_midpoint(lower_.points[edge.a], lower_.points[edge.b], upper_.points[cell],
                                             upper_.points[other], Side::upper) > 0;
    return before_m == edge.left_inside;
  }

  /// The crossing lies between the inner circumcentre and the midpoint exactly if the bisector of a and b separates
  /// them.
  bool dual_inside_upper(const LowerEdge& edge, std::uint32_t cell, std::uint32_t other, std::uint32_t spoke) const {
    const std::uint32_t before = spoke == upper_.first_spoke[cell] ? upper_.first_spoke[cell + 1] - 1 : spoke - 1;
    // The triangle left of cell->other follows its spoke, the one on the right precedes it.
    const std::uint32_t inner = upper_.spokes[upper_.next[cell] == other ? spoke : before].triangle;
    const bool midpoint_near_b = nearer_to_midpoint(upper_.points[cell], upper_.points[other], lower_.points[edge.a],
                                                    lower_.points[edge.b], Side::lower) > 0;
    return centre_near_b(inner, edge) != midpoint_near_b;
  }

  const Planar& lower_;
  const Planar& upper_;
  std::uint32_t offset_;
  std::vector<SlabTetrahedron> result_;
};

}  // namespace

std::vector<SlabTetrahedron> walked_slab(const Planar& lower, const Planar& upper) {
  return SlabWalk<true>(lower, upper).run();
}

std::vector<SlabTetrahedron> bare_slab(const Planar& lower, const Planar& upper) {
  std::vector<SlabTetrahedron> tetrahedra = SlabWalk<false>(lower, upper).run();
  link_neighbours(tetrahedra);
  return tetrahedra;
}

std::vector<SlabTetrahedron> triangulate_slab(const Planar& lower, const Planar& upper) {
  std::vector<SlabTetrahedron> tetrahedra = walked_slab(lower, upper);
  link_neighbours(tetrahedra);
  return tetrahedra;
}

void link_neighbours(std::vector<SlabTetrahedron>& tetrahedra) {
  FaceTable table(tetrahedra.size() * 4);
  constexpr std::uint32_t taken = FaceTable::vacant - 1;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto& v = tetrahedra[t].v;
      std::uint32_t& seen = table(v[outward_face[i][0]], v[outward_face[i][1]], v[outward_face[i][2]]);
      if (seen == taken) throw InternalError("three tetrahedra of a slab share a face");
      if (seen == FaceTable::vacant) {
        seen = 4 * t + i;
      } else {
        tetrahedra[t].nb[i] = seen / 4;
        tetrahedra[seen / 4].nb[seen % 4] = t;
        seen = taken;
      }
    }
}

}  // namespace odontoscope::delaunay
