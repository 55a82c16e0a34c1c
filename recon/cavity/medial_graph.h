#pragma once
// The inner Voronoi diagram of a void: places far from all walls, and ways between neighbouring ones that stay in the
// void.

#include <cstdint>
#include <vector>

#include "recon/cavity/wall_tree.h"
#include "recon/core/progress.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::cavity {

struct MedialGraph {
  struct Node {
    Point3 at;
    double radius;  // distance to the wall's triangles, or up to 5 % less
    double volume;  // of the node's tetrahedron: what part of the void it stands for
  };
  struct Edge {
    std::uint32_t to;
    float length;
  };
  std::vector<Node> nodes;  // in an order that the wall alone decides
  std::vector<std::uint32_t>
      first_way;           // of each node, and one more: the ways of n are [first_way[n], first_way[n + 1])
  std::vector<Edge> ways;  // both directions
};

/// Nodes are the circumcentres in the void of the Delaunay tetrahedra of the wall's samples (its vertices, and points
/// of long edges); ways join those of tetrahedra with a common face, where the straight line between them leaves the
/// void at no place that was looked at.
MedialGraph medial_graph(const SurfaceMesh& wall, const WallTree& tree, const Progress& progress);

}  // namespace odontoscope::cavity
