#include "recon/mesh/faulty_edges.h"

#include <algorithm>

namespace odontoscope {

std::vector<FaultyEdge> faulty_edges(const SurfaceMesh& mesh) {
  const EdgeMates edges = edge_mates(mesh);
  std::vector<FaultyEdge> faulty;
  for (HalfEdge h = 0; h < edges.mate.size(); ++h) {
    const HalfEdge mate = edges.mate[h];
    if (mate == EdgeMates::none)
      faulty.push_back({EdgeFault::boundary, h});
    else if (mate < EdgeMates::no_edge && h < mate && start(mesh, mate) == start(mesh, h))
      faulty.push_back({EdgeFault::misoriented, h});
  }
  const auto ends = [&](HalfEdge h) {
    return std::minmax({start(mesh, h), end(mesh, h)});
  };  // by value: the other minmax gives references
  for (std::size_t i = 0; i < edges.crowded.size(); ++i)
    if (i == 0 || ends(edges.crowded[i - 1]) != ends(edges.crowded[i]))
      faulty.push_back({EdgeFault::nonmanifold, edges.crowded[i]});
  return faulty;
}

}  // namespace odontoscope
