#pragma once
// Our surfaces as CGAL's half-edge meshes and back. For the .cpp files of this room only: CGAL's headers are slow to
// compile.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "recon/core/error.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HalfEdgeMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// Vertices and faces keep their numbers. Precondition: edge-manifold and consistently oriented.
inline HalfEdgeMesh to_half_edges(const SurfaceMesh& mesh) {
  HalfEdgeMesh converted;
  const auto vertices = static_cast<HalfEdgeMesh::size_type>(mesh.points.size());
  const auto faces = static_cast<HalfEdgeMesh::size_type>(mesh.triangles.size());
  converted.reserve(vertices, 3 * faces / 2, faces);
  for (const Point3& p : mesh.points) converted.add_vertex({p.x, p.y, p.z});
  for (const auto& [a, b, c] : mesh.triangles) {
    using Vertex = HalfEdgeMesh::Vertex_index;
    if (converted.add_face(Vertex(a), Vertex(b), Vertex(c)) == HalfEdgeMesh::null_face()) {
      throw InternalError("a surface that is no oriented manifold was taken for one");
    }
  }
  return converted;
}

}  // namespace odontoscope
