#include "recon/delaunay/assemble.h"

#include <tbb/parallel_invoke.h>

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"

namespace odontoscope::delaunay {

Numbering::Numbering(const SolvedStack& stack) {
  std::uint64_t at = 0;
  const auto mark = [&at](std::vector<std::uint32_t>& begin) {
    if (at >= none) throw InternalError("more points than 32-bit numbers can count");
    begin.push_back(static_cast<std::uint32_t>(at));
  };
  mark(slice_begin);
  for (const ConformedSlice& slice : stack.slices) {
    at += slice.planar.points.size();
    mark(slice_begin);
  }
  mark(added_begin);
  for (const auto& pieces : stack.slabs) {
    for (const SlabSolid& piece : pieces) at += piece.added.size();
    mark(added_begin);
  }
}

std::vector<Tetrahedron> assembled_tetrahedra(const SolvedStack& stack, const Numbering& numbering, std::size_t slab) {
  std::vector<Tetrahedron> tetrahedra;
  const std::uint32_t lower = numbering.slice_begin[slab], end = numbering.slice_begin[slab + 2];
  std::uint32_t added = numbering.added_begin[slab];
  std::size_t count = 0;
  for (const SlabSolid& piece : stack.slabs[slab]) count += piece.tetrahedra.size();
  tetrahedra.reserve(count);
  for (const SlabSolid& piece : stack.slabs[slab]) {
    const std::uint32_t on_slices = end - lower;  // lower and upper points follow each other in both numberings
    for (const auto& tet : piece.tetrahedra) {
      Tetrahedron numbered{};
      for (int i = 0; i < 4; ++i) numbered[i] = tet[i] < on_slices ? lower + tet[i] : added + (tet[i] - on_slices);
      tetrahedra.push_back(numbered);
    }
    added += static_cast<std::uint32_t>(piece.added.size());
  }
  return tetrahedra;
}

AssembledSlab assemble_slab(const SolvedStack& stack, const Numbering& numbering, std::size_t slab) {
  AssembledSlab result;
  result.tetrahedra = assembled_tetrahedra(stack, numbering, slab);
  const std::uint32_t lower = numbering.slice_begin[slab], upper = numbering.slice_begin[slab + 1];
  const std::uint32_t end = numbering.slice_begin[slab + 2];
  each_outer_face(result.tetrahedra, [&](const Triangle& face) {
    const auto all = [&face](std::uint32_t from, std::uint32_t to) {
      return face[0] >= from && face[0] < to && face[1] >= from && face[1] < to && face[2] >= from && face[2] < to;
    };
    (all(lower, upper) ? result.floor : all(upper, end) ? result.ceiling : result.sides).push_back(face);
  });
  return result;
}

namespace {

/// The faces of two sides of a slice that have no partner on the other.
void add_unmatched(const std::vector<Triangle>& below, const std::vector<Triangle>& above,
                   std::vector<Triangle>& surface) {
  FaceTable table(below.size() + above.size());
  constexpr std::uint32_t matched = FaceTable::vacant - 1;
  for (std::uint32_t t = 0; t < below.size(); ++t) table(below[t][0], below[t][1], below[t][2]) = t;
  std::vector<Triangle> only_above;
  for (const Triangle& t : above) {
    std::uint32_t& seen = table(t[0], t[1], t[2]);
    if (seen == FaceTable::vacant)
      only_above.push_back(t);
    else
      seen = matched;
  }
  for (const Triangle& t : below)
    if (table(t[0], t[1], t[2]) != matched) surface.push_back(t);
  surface.insert(surface.end(), only_above.begin(), only_above.end());
}

TetraMesh joined_tetrahedra(const SolvedStack& stack, const Numbering& numbering,
                            const std::vector<AssembledSlab>& slabs, Label label) {
  TetraMesh mesh;
  mesh.points.reserve(numbering.points());
  for (const ConformedSlice& slice : stack.slices)
    for (const Point2 p : slice.planar.points) mesh.points.push_back({p.x, p.y, slice.z});
  for (const auto& pieces : stack.slabs)
    for (const SlabSolid& piece : pieces) mesh.points.insert(mesh.points.end(), piece.added.begin(), piece.added.end());
  std::size_t count = 0;
  for (const AssembledSlab& slab : slabs) count += slab.tetrahedra.size();
  mesh.tetrahedra.reserve(count);
  for (const AssembledSlab& slab : slabs)
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), slab.tetrahedra.begin(), slab.tetrahedra.end());
  mesh.labels.assign(count, label);
  return mesh;
}

/// The surface's triangles, in the assembled numbering.
std::vector<Triangle> joined_surface(const std::vector<AssembledSlab>& slabs) {
  std::size_t count = 0;
  for (const AssembledSlab& slab : slabs) count += slab.sides.size();
  std::vector<Triangle> surface;
  surface.reserve(count);
  const std::vector<Triangle> nothing;
  for (std::size_t k = 0; k <= slabs.size(); ++k) {
    add_unmatched(k > 0 ? slabs[k - 1].ceiling : nothing, k < slabs.size() ? slabs[k].floor : nothing, surface);
    if (k < slabs.size()) surface.insert(surface.end(), slabs[k].sides.begin(), slabs[k].sides.end());
  }
  return surface;
}

/// The points that the triangles use, in the same order.
SurfaceMesh compacted(std::vector<Triangle> triangles, const std::vector<Point3>& points) {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> number(points.size(), none);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (number[v] != none) {
      number[v] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.push_back(points[v]);
    }
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = number[v];
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace

Assembly assemble(const SolvedStack& stack, const Numbering& numbering, const std::vector<AssembledSlab>& slabs,
                  Label label) {
  Assembly result;
  std::vector<Triangle> triangles;
  tbb::parallel_invoke([&] { result.tetrahedra = joined_tetrahedra(stack, numbering, slabs, label); },
                       [&] { triangles = joined_surface(slabs); });
  result.surface = compacted(std::move(triangles), result.tetrahedra.points);
  return result;
}

}  // namespace odontoscope::delaunay
