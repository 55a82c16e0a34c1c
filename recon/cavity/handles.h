#pragma once
// Handles of a void: where canals part and join again.

#include <vector>

#include "recon/cavity/linking.h"
#include "recon/cavity/medial_paths.h"

namespace odontoscope::cavity {

/// Two of the shortest paths from the root that part, go round the two sides of what stands between them, and meet.
struct Handle {
  NodeIndex fork = no_node;           // where they part
  std::vector<NodeIndex> one, other;  // from there on, without it, to where they meet: the last two are neighbours

  /// Closed: the last is the first.
  std::vector<NodeIndex> loop() const;
};

/// At most as many as the void's genus, the widest and shortest first, none of which is made up of those before it; of
/// those only the ones nowhere narrower than `radius`.
std::vector<Handle> handles_of(const MedialGraph& graph, const PathTree& tree, const Linking& linking, double radius);

}  // namespace odontoscope::cavity
