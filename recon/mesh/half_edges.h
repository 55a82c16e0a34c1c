#pragma once
// Which triangles of an indexed mesh meet in which edges, for any mesh, manifold or not.
//
// Half-edge 3t+k runs from corner k of triangle t to corner k+1; it belongs to the undirected edge of its two vertices.
// The corner that it starts from has the same number.

#include <cstdint>
#include <limits>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

using HalfEdge = std::uint32_t;

struct EdgeMates {
  static constexpr HalfEdge none = std::numeric_limits<HalfEdge>::max();  // the edge has one triangle
  static constexpr HalfEdge many = none - 1;                              // the edge has more than two
  static constexpr HalfEdge no_edge = none - 2;                           // the triangle names a vertex twice
  /// For each half-edge the one other half-edge of its edge, or one of the above.
  std::vector<HalfEdge> mate;
  std::size_t boundary_edges = 0, nonmanifold_edges = 0, misoriented_edges = 0;
  /// Half-edges of edges with more than two triangles, grouped by edge; a group ends where the vertices change.
  std::vector<HalfEdge> crowded;
};

inline HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
inline PointIndex start(const SurfaceMesh& mesh, HalfEdge h) { return mesh.triangles[h / 3][h % 3]; }
inline PointIndex end(const SurfaceMesh& mesh, HalfEdge h) { return start(mesh, next(h)); }

/// Triangles that name a vertex twice have no part in it: their mates are `no_edge`.
/// Precondition: indices in range, fewer than 2^32 / 3 - 1 triangles. Linear time but for crowded vertices.
EdgeMates edge_mates(const SurfaceMesh& mesh);

/// True if the triangle names a vertex twice.
inline bool repeats_a_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace odontoscope
