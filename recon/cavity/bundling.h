#pragma once
// Paths that lead side by side along one canal, made to share its nodes.

#include <vector>

#include "recon/cavity/handles.h"
#include "recon/cavity/medial_paths.h"
#include "recon/cavity/rejoining.h"

namespace odontoscope::cavity {

/// Many nodes of a medial graph lie in the middle of one round canal, and two of the tree's paths may lead down it side by side without having one in common. What follows asks
/// whether they go the same way, and compares nodes: so each path takes the nodes of the one before it that it keeps nearest to longest, as long as it is nearer than
/// limits::together of the radius (the ways between lie in both balls: nothing stands between). Paths that part in the chamber already stay as they are. Where handles part is
/// found anew.
void bundle(const MedialGraph& graph, const PathTree& tree, const std::vector<char>& chamber, std::vector<MedialCanal>& canals, std::vector<Handle>& handles);

}  // namespace odontoscope::cavity
