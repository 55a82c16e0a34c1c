#include "engine/figures/slab_steps.h"

#include <algorithm>
#include <map>
#include <set>

#include "recon/core/error.h"
#include "recon/delaunay/carve.h"
#include "recon/delaunay/conform.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/lift.h"
#include "recon/delaunay/slab.h"
#include "recon/input/validate.h"

namespace odontoscope::figures {
namespace {

using delaunay::EdgeKind;
using delaunay::Fate;
using delaunay::SlabTetrahedra;
using delaunay::SlabTetrahedron;
using delaunay::TetIndex;

double volume(const std::vector<Point3>& p, const Tetrahedron& t) {
  const auto from = [&](int i) { return Point3{p[t[i]].x - p[t[0]].x, p[t[i]].y - p[t[0]].y, p[t[i]].z - p[t[0]].z}; };
  const Point3 a = from(1), b = from(2), c = from(3);
  return (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
}

/// Points of a slab without further ones have the same numbers as in a mesh of it.
Tetrahedron corners_of(const SlabTetrahedron& t) { return {t.v[0], t.v[1], t.v[2], t.v[3]}; }

std::vector<ReverseTetrahedron> reverse_among(const SlabTetrahedra& tetrahedra, const std::vector<Point3>& points) {
  std::vector<ReverseTetrahedron> found;
  for (const SlabTetrahedron& t : tetrahedra) {
    if (t.lower_count != 2 || t.lower_edge == EdgeKind::contour || t.upper_edge == EdgeKind::contour) continue;
    const Tetrahedron corners = corners_of(t);
    found.push_back(
        {corners, t.lower_edge == EdgeKind::internal, t.upper_edge == EdgeKind::internal, volume(points, corners)});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.volume > b.volume; });
  return found;
}

}  // namespace

std::vector<Point3> singular_edges(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra) {
  std::map<std::pair<PointIndex, PointIndex>, int> faces_at;
  delaunay::each_outer_face(tetrahedra, [&](const Triangle& face) {
    for (int i = 0; i < 3; ++i) ++faces_at[std::minmax(face[i], face[(i + 1) % 3])];
  });
  std::vector<Point3> ends;
  for (const auto& [edge, faces] : faces_at) {
    if (faces <= 2) continue;
    ends.push_back(points[edge.first]);
    ends.push_back(points[edge.second]);
  }
  return ends;
}

SurfaceMesh boundary_of(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra) {
  SurfaceMesh surface{points, {}};
  delaunay::each_outer_face(tetrahedra, [&](const Triangle& face) { surface.triangles.push_back(face); });
  return surface;
}

SlabSteps slab_steps(const ContourStack& stack) {
  validate(stack);
  const ContourStack sorted = ordered(stack).stack;
  if (sorted.slices.size() != 2) throw InternalError("a slab has two slices");
  const std::string structure = structures_of(sorted).front();
  const auto lower = delaunay::conform(sorted.slices[0], structure, 0, sorted.source, {});
  const auto upper = delaunay::conform(sorted.slices[1], structure, 1, sorted.source, {});
  const SlabTetrahedra tetrahedra = delaunay::triangulate_slab(lower.planar, upper.planar);

  SlabSteps steps;
  for (const Point2& p : lower.planar.points) steps.points.push_back({p.x, p.y, lower.z});
  for (const Point2& p : upper.planar.points) steps.points.push_back({p.x, p.y, upper.z});
  delaunay::Fates fate = delaunay::eliminate(tetrahedra, lower.planar, upper.planar);
  for (const TetIndex t : tetrahedra.indices()) {
    steps.delaunay.push_back(corners_of(tetrahedra[t]));
    if (fate[t] == Fate::kept) steps.kept.push_back(corners_of(tetrahedra[t]));
  }
  steps.reverse = reverse_among(tetrahedra, steps.points);
  steps.singular_edges = singular_edges(steps.points, steps.kept);

  const delaunay::Owners owner(tetrahedra.size(), 0);
  if (!delaunay::repair(tetrahedra, lower.planar, upper.planar, owner, fate))
    throw InternalError("a figure's slab cannot be repaired");
  for (const TetIndex t : tetrahedra.indices())
    if (fate[t] == Fate::restored) steps.restored.push_back(corners_of(tetrahedra[t]));
  delaunay::SlabSolid solid;
  if (!delaunay::lift(tetrahedra, fate, lower.planar, upper.planar, {lower.z, upper.z},
                      static_cast<std::uint32_t>(lower.planar.points.size()),
                      static_cast<std::uint32_t>(upper.planar.points.size()), solid))
    throw InternalError("a figure's slab cannot be lifted");
  const auto flat = static_cast<PointIndex>(steps.points.size());
  steps.lifted = solid.added;
  steps.points.insert(steps.points.end(), solid.added.begin(), solid.added.end());
  steps.solid.assign(solid.tetrahedra.begin(), solid.tetrahedra.end());
  for (const Tetrahedron& t : steps.solid)
    if (std::any_of(t.begin(), t.end(), [flat](PointIndex p) { return p >= flat; })) steps.split.push_back(t);
  return steps;
}

}  // namespace odontoscope::figures
