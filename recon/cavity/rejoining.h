#pragma once
// Canals that part and join again: each side of a handle gets a way of its own.

#include <vector>

#include "recon/cavity/handles.h"
#include "recon/cavity/medial_paths.h"

namespace odontoscope::cavity {

/// A way from the root to an end.
struct MedialCanal {
  std::vector<NodeIndex> path;
  double beyond = 0;  // see Branch
};

struct Rejoined {
  std::vector<MedialCanal> canals;
  std::vector<std::vector<NodeIndex>>
      isthmuses;  // from the root through what joins two canals that both go on, to where it meets the second
};

/// `canals` are those of the tree that the handles belong to. As few as possible lead on the other way round, or are
/// added, until each side of each handle that reaches beyond the chamber is on some canal's way. A handle on which no
/// canal goes on ends where its sides meet. `chamber`: for each node, whether it lies there; a handle that joins in the
/// chamber stands in it, and no canal goes round it.
Rejoined rejoined(const MedialGraph& graph, const PathTree& tree, std::vector<MedialCanal> canals,
                  const std::vector<Handle>& handles, const std::vector<char>& chamber);

}  // namespace odontoscope::cavity
