#include "recon/elements/interface_shape.h"

#include <algorithm>
#include <cmath>

namespace odontoscope::elements {
namespace {

InterfaceShape::Nearest as_distance(const SurfaceTree::Nearest& nearest) {
  return {nearest.at, std::sqrt(nearest.square)};
}

}  // namespace

JunctionKind junction_kind(const InterfaceWeb& web, PointIndex a, PointIndex b) {
  JunctionKind kind;
  for (const std::uint32_t f : web.faces_between(a, b)) kind.emplace_back(web.faces()[f].inner, web.faces()[f].outer);
  std::sort(kind.begin(), kind.end());
  return kind;
}

InterfaceShape::InterfaceShape(const InterfaceWeb& web) {
  std::map<LabelPair, std::vector<Corners>> faces;
  std::map<JunctionKind, std::vector<Corners>> lines;
  const auto& points = web.points();
  for (std::uint32_t f = 0; f < web.faces().size(); ++f) {
    if (!web.alive(f)) continue;
    const InterfaceTriangle& face = web.faces()[f];
    faces[{face.inner, face.outer}].push_back(
        {points[face.triangle[0]], points[face.triangle[1]], points[face.triangle[2]]});
  }
  for (PointIndex v = 0; v < points.size(); ++v) {
    for (const InterfaceWeb::Neighbour& n : web.ring(v))
      if (n.vertex > v && !n.on_surface())
        lines[junction_kind(web, v, n.vertex)].push_back({points[v], points[n.vertex], points[n.vertex]});
  }
  for (const auto& [labels, corners] : faces) faces_.emplace(labels, SurfaceTree(corners));
  for (const auto& [kind, corners] : lines) lines_.emplace(kind, SurfaceTree(corners));
}

InterfaceShape::Nearest InterfaceShape::on_faces(const LabelPair& labels, const Point3& from) const {
  return as_distance(faces_.at(labels).nearest(from));
}
InterfaceShape::Nearest InterfaceShape::on_lines(const JunctionKind& kind, const Point3& from) const {
  return as_distance(lines_.at(kind).nearest(from));
}

}  // namespace odontoscope::elements
