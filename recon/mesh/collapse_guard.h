#pragma once
// Watches over the collapse of edges, so that a surface never cuts through itself on its way to fewer triangles. Inner
// part of simplify_surface.h: needs CGAL's headers.
//
// Before each collapse the triangles that it would make are held, by exact predicates, against all others of the same
// surface and against each other. So what comes out is embedded if what went in was, and a place that is too narrow for
// one collapse costs that collapse alone. Surfaces that are simplified together (structures of a tooth, which may touch
// or overlap) are not held against each other.

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/mesh/collapse_star.h"

namespace odontoscope {

class CollapseGuard {
 public:
  using Vertex = HalfEdgeMesh::Vertex_index;
  using Face = HalfEdgeMesh::Face_index;
  using Point = ExactKernel::Point_3;

  /// `surface_of[v]`: number of the surface that vertex v belongs to. Both must outlive the guard.
  CollapseGuard(const HalfEdgeMesh& mesh, const std::vector<std::uint32_t>& surface_of);

  /// Nothing if the star's edge may be collapsed into `placed`. May triangles turn over where nothing is cut?
  std::optional<CollapseRefusal> refusal(const CollapseStar& star, const Point& placed,
                                         CollapseStar::Turning turning) const;

  /// To be told of each collapse: of the faces that vanish, and of the vertex whose faces have changed.
  void vanished(Face face) { tree_.move(face.idx(), {}); }
  void moved(Vertex vertex);

 private:
  const HalfEdgeMesh& mesh_;
  const std::vector<std::uint32_t>& surface_of_;
  MovingBoxTree tree_;
};

}  // namespace odontoscope
