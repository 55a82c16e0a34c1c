#include "recon/elements/interface_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/mesh/nearest_on_triangle.h"

namespace odontoscope::elements {

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
  for (const auto& [labels, corners] : faces) faces_.emplace(labels, Places(corners));
  for (const auto& [kind, corners] : lines) lines_.emplace(kind, Places(corners));
}

InterfaceShape::Nearest InterfaceShape::on_faces(const LabelPair& labels, const Point3& from) const {
  return faces_.at(labels).nearest(from);
}
InterfaceShape::Nearest InterfaceShape::on_lines(const JunctionKind& kind, const Point3& from) const {
  return lines_.at(kind).nearest(from);
}

InterfaceShape::Places::Places(const std::vector<Corners>& corners) {
  std::vector<BoxTree<std::array<double, 3>>::Bounds> bounds;
  for (const Corners& t : corners) bounds.push_back(box_round(t));
  tree_ = BoxTree<std::array<double, 3>>(bounds);
  for (const std::uint32_t t : tree_.order())
    faces_.push_back({corners[t][0], corners[t][1] - corners[t][0], corners[t][2] - corners[t][0]});
}

InterfaceShape::Nearest InterfaceShape::Places::nearest(const Point3& from) const {
  double best = std::numeric_limits<double>::infinity();
  Point3 at;
  tree_.nearest_first(std::array{from.x, from.y, from.z}, best, 0.0, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t i = first; i < end; ++i) {
      const Face& face = faces_[i];
      const OnTriangle on = nearest_on_triangle(face.ab, face.ac, from - face.a);
      const Direction along = on.s * face.ab + on.t * face.ac;
      const Point3 place{face.a.x + along.x, face.a.y + along.y, face.a.z + along.z};
      const Direction off = from - place;
      if (const double square = dot(off, off); square < best) best = square, at = place;
    }
  });
  return {at, std::sqrt(best)};
}

}  // namespace odontoscope::elements
