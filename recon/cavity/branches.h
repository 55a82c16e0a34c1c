#pragma once
// The branches of a void: ways through its medial graph from the chamber to every end that is worth the name.

#include <optional>
#include <vector>

#include "recon/cavity/medial_graph.h"
#include "recon/mesh/vector.h"

namespace odontoscope::cavity {

struct Branch {
  std::vector<Point3> path;  // from the root to the end; a line through nodes that stays in the void
  double beyond = 0;         // length of its part that no branch before it covers, to the end's ball and over it
};

struct Branches {
  std::uint32_t root = 0;  // node: the chamber's centre
  double root_radius = 0;
  bool has_chamber = true;
  bool through = false;          // all branches lead from one end of a tube to the other, not from the root
  std::vector<Branch> branches;  // farthest reaching first, then the second ways round handles
  std::vector<std::vector<Point3>>
      isthmuses;  // from the root through what joins two branches, to where it meets the second
  std::vector<std::vector<Point3>> loops;  // round each handle that is wide enough; the last point is the first
};

/// `handles`: the void's genus; loops are looked for only if there are any. `axis` (any length) serves to choose the
/// upper end of a tube without a chamber.
Branches find_branches(const MedialGraph& graph, const SurfaceMesh& wall, long handles,
                       const std::optional<Direction>& axis);

}  // namespace odontoscope::cavity
