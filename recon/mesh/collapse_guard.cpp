#include "recon/mesh/collapse_guard.h"

#include <algorithm>

namespace odontoscope {
namespace {

NumberedTriangle triangle_of(const HalfEdgeMesh& mesh, CollapseGuard::Face face) {
  NumberedTriangle triangle;
  std::size_t corner = 0;
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
    triangle.number[corner] = v;
    triangle.corner[corner++] = mesh.point(v);
  }
  return triangle;
}

std::vector<MovingBox> boxes_of(const HalfEdgeMesh& mesh) {
  std::vector<MovingBox> boxes(mesh.num_faces());
  for (const auto face : mesh.faces()) boxes[face.idx()] = box_of(triangle_of(mesh, face));
  return boxes;
}

}  // namespace

MovingBox box_of(const NumberedTriangle& triangle) {
  MovingBox box;
  for (const auto& p : triangle.corner) box.add(Point3{p.x(), p.y(), p.z()});
  return box;
}

CollapseGuard::CollapseGuard(const HalfEdgeMesh& mesh, const std::vector<std::uint32_t>& surface_of)
    : mesh_(mesh), surface_of_(surface_of), tree_(boxes_of(mesh)) {}

void CollapseGuard::moved(Vertex vertex) {
  for (const Face face : mesh_.faces_around_target(mesh_.halfedge(vertex))) {
    if (face != HalfEdgeMesh::null_face()) tree_.move(face.idx(), box_of(triangle_of(mesh_, face)));
  }
}

std::optional<CollapseRefusal> CollapseGuard::refusal(const CollapseStar& star, const Point& placed, bool may_turn) const {
  if (const auto own = star.refusal(placed, may_turn)) return own;
  if (cuts_others(star, placed)) return CollapseRefusal::cuts;
  return std::nullopt;
}

bool CollapseGuard::cuts_others(const CollapseStar& star, const Point& placed) const {
  for (std::size_t t = 0; t < star.triangles.size(); ++t) {
    const NumberedTriangle made = star.made(t, placed);
    const bool cut = tree_.any(box_of(made), [&](std::uint32_t number) {
      const NumberedTriangle other = triangle_of(mesh_, Face(number));
      const bool own = surface_of_[other.number[0]] == surface_of_[star.one];
      return own && std::none_of(other.number.begin(), other.number.end(), [&](PointIndex v) { return star.holds(v); }) && meet_elsewhere(made, other);
    });
    if (cut) return true;
  }
  return false;
}

}  // namespace odontoscope
