#include "recon/mesh/collapse_guard.h"

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

CollapseGuard::CollapseGuard(const HalfEdgeMesh& mesh, const std::vector<std::uint32_t>& surface_of)
    : mesh_(mesh), surface_of_(surface_of), tree_(boxes_of(mesh)) {}

void CollapseGuard::moved(Vertex vertex) {
  for (const Face face : mesh_.faces_around_target(mesh_.halfedge(vertex))) {
    if (face != HalfEdgeMesh::null_face()) tree_.move(face.idx(), box_of(triangle_of(mesh_, face)));
  }
}

std::optional<CollapseRefusal> CollapseGuard::refusal(const CollapseStar& star, const Point& placed,
                                                      CollapseStar::Turning turning) const {
  if (const auto own = star.refusal(placed, turning)) return own;
  const auto triangle = [&](std::uint32_t number) { return triangle_of(mesh_, Face(number)); };
  const auto same_surface = [&](const NumberedTriangle& other) {
    return surface_of_[other.number[0]] == surface_of_[star.one];
  };
  if (cuts_others(star, placed, tree_, triangle, same_surface)) return CollapseRefusal::cuts;
  return std::nullopt;
}

}  // namespace odontoscope
