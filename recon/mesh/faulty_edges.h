#pragma once
// The edges at which a surface is no oriented manifold.

#include <vector>

#include "recon/mesh/half_edges.h"

namespace odontoscope {

enum class EdgeFault {
  boundary,     // one triangle
  misoriented,  // two triangles that run along it the same way
  nonmanifold,  // more than two
};

struct FaultyEdge {
  EdgeFault fault = EdgeFault::boundary;
  HalfEdge half_edge = 0;  // one of its own
};

/// Each faulty edge once: boundary and misoriented ones in the order of their half-edges, then nonmanifold ones.
/// Preconditions as for edge_mates.
std::vector<FaultyEdge> faulty_edges(const SurfaceMesh& mesh);

}  // namespace odontoscope
