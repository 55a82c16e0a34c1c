#include "recon/delaunay/certify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/predicates.h"

namespace odontoscope::delaunay {
namespace {

[[noreturn]] void broken(const std::string& what) { throw InternalError("certificate: " + what); }

/// The spoke from a to b in a slice; null if the triangulation has no such edge.
const Spoke* edge(const Planar& planar, SlicePoint a, SlicePoint b) {
  for (const SpokeIndex s : planar.spokes_of(a))
    if (planar.spokes[s].vertex == b) return &planar.spokes[s];
  return nullptr;
}

/// Is (a, b, c), counter-clockwise, an internal triangle of the slice?
bool internal_triangle(const Planar& planar, SlicePoint a, SlicePoint b, SlicePoint c) {
  const Spoke* spoke = edge(planar, a, b);
  if (!spoke || !planar.inside(spoke->triangle)) return false;
  const auto& v = planar.triangles[spoke->triangle].v;
  return std::find(v.begin(), v.end(), c) != v.end() && std::find(v.begin(), v.end(), a) != v.end() &&
         std::find(v.begin(), v.end(), b) != v.end();
}

/// May these corners of a tetrahedron lie in the slice's plane together?
bool belongs(const Planar& planar, const std::vector<SlicePoint>& in_plane) {
  if (in_plane.size() < 2) return true;
  if (in_plane.size() == 2) {
    const Spoke* spoke = edge(planar, in_plane[0], in_plane[1]);
    return spoke && spoke->kind != EdgeKind::external;
  }
  return in_plane.size() == 3 && (internal_triangle(planar, in_plane[0], in_plane[1], in_plane[2]) ||
                                  internal_triangle(planar, in_plane[0], in_plane[2], in_plane[1]));
}

}  // namespace

void certify_slab(const SolvedStack& stack, const Numbering& numbering, const AssembledSlab& slab,
                  const TetraMesh& mesh, std::size_t k) {
  const ConformedSlice& lower = stack.slices[k];
  const ConformedSlice& upper = stack.slices[k + 1];
  const std::uint32_t low = numbering.slice_begin[k], high = numbering.slice_begin[k + 1];
  FaceTable table(slab.tetrahedra.size() * 4);
  constexpr std::uint32_t twice = FaceTable::vacant - 1;
  std::vector<SlicePoint> in_lower, in_upper;
  for (const Tetrahedron& tet : slab.tetrahedra) {
    if (orientation(mesh.points[tet[0]], mesh.points[tet[1]], mesh.points[tet[2]], mesh.points[tet[3]]) <= 0)
      broken(fmt::format("a tetrahedron between slices {} and {} is not positive", k, k + 1));
    in_lower.clear();
    in_upper.clear();
    for (const std::uint32_t v : tet) {
      const double z = mesh.points[v].z;
      if (!(z >= lower.z && z <= upper.z)) broken(fmt::format("a point leaves the slab above slice {}", k));
      if (z == lower.z) in_lower.emplace_back(v - low);
      if (z == upper.z) in_upper.emplace_back(v - high);
    }
    if (!belongs(lower.planar, in_lower) || !belongs(upper.planar, in_upper))
      broken(fmt::format("the solid touches the plane of slice {} or {} outside its regions", k, k + 1));
    for (int i = 0; i < 4; ++i) {
      const Triangle face{tet[outward_face[i][0]], tet[outward_face[i][1]], tet[outward_face[i][2]]};
      std::uint32_t& seen = table(face[0], face[1], face[2]);
      const std::uint32_t side = even_permutation(face) ? 1 : 0;
      if (seen == twice) broken(fmt::format("three tetrahedra share a face above slice {}", k));
      if (seen == side) broken(fmt::format("two tetrahedra lie on the same side of a face above slice {}", k));
      seen = seen == FaceTable::vacant ? side : twice;
    }
  }
}

void certify_slice(const SolvedStack& stack, const Numbering& numbering, const AssembledSlab* below,
                   const AssembledSlab* above, std::size_t k) {
  const Planar& planar = stack.slices[k].planar;
  const std::uint32_t first = numbering.slice_begin[k];
  Table<TriangleIndex, bool> covered(planar.triangles.size(), false);
  const auto cover = [&](const std::vector<Triangle>& faces, int& sides) {
    for (const Triangle& face : faces) {
      const SlicePoint a(face[0] - first), b(face[1] - first), c(face[2] - first);
      const Spoke* spoke = edge(planar, a, b);
      const Spoke* reverse = edge(planar, b, a);
      for (const Spoke* s : {spoke, reverse})
        if (s && s->triangle != none) {
          const auto& v = planar.triangles[s->triangle].v;
          if (std::find(v.begin(), v.end(), c) != v.end()) covered[s->triangle] = true;
        }
    }
    ++sides;
  };
  int sides = 0;
  if (below) cover(below->ceiling, sides);
  if (above) cover(above->floor, sides);
  for (const TriangleIndex t : planar.triangles.indices()) {
    const PlanarTriangle& triangle = planar.triangles[t];
    if (triangle.region == none) continue;
    if (!covered[t]) broken(fmt::format("a region of slice {} is not filled", k));
    for (int i = 0; i < 3; ++i) {
      const SlicePoint a = triangle.v[(i + 1) % 3], b = triangle.v[(i + 2) % 3];
      const bool inside_beyond = planar.inside(triangle.nb[i]);
      if (inside_beyond == planar.contour_edge(a, b))
        broken(fmt::format("the regions of slice {} do not end at its contours", k));
    }
  }
}

void certify_contours(const ConformedSlice& conformed, const Slice& given) {
  const auto& points = conformed.planar.points;
  for (std::size_t c = 0; c < conformed.contour_number.size(); ++c) {
    const auto& contour = given.contours[conformed.contour_number[c]].points;
    SlicePoint at = conformed.first_point[c];
    const SlicePoint end = conformed.first_point[c + 1];
    for (std::size_t p = 0; p < contour.size(); ++p, ++at) {
      if (at >= end || !(points[at] == contour[p])) broken("a point of a contour was lost or moved");
      const Point2 a = contour[p], b = contour[(p + 1) % contour.size()];
      const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
      // An added point is a mean of the ends of its given edge: two shares, two products and a sum are rounded.
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
      for (; at + 1 < end && !(p + 1 < contour.size() && points[SlicePoint(at + 1)] == b); ++at) {
        const Point2 s = points[SlicePoint(at + 1)];
        const double length = portable::hypot(b.x - a.x, b.y - a.y);
        const double off = std::abs((b.x - a.x) * (s.y - a.y) - (b.y - a.y) * (s.x - a.x)) / length;
        if (!(off <= rounding)) broken("a point was added beside its contour");
      }
    }
    if (at != end) broken("a contour has points that nobody put there");
  }
}

void certify_surface(const SurfaceReport& report, const std::string& structure) {
  if (!report.closed_oriented_manifold())
    broken(fmt::format(
        "the surface of {} is no closed oriented manifold ({} boundary, {} non-manifold, {} misoriented edges, {} "
        "non-manifold vertices, {} degenerate triangles)",
        structure, report.boundary_edges, report.nonmanifold_edges, report.misoriented_edges,
        report.nonmanifold_vertices, report.degenerate_triangles));
  for (const Shell& shell : report.shells)
    if (shell.kind == Shell::Kind::open) broken("the surface of " + structure + " has a shell without inside");
}

}  // namespace odontoscope::delaunay
