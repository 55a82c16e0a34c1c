#pragma once
// Finds the places of a certified reconstruction that a person should look at. It judges a result and changes nothing.

#include <vector>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope::delaunay {

/// In the order of AttentionKind, then by structure, slice and place. Uses `made`'s solids, links and topology, all
/// complete. Preconditions: `ordered` and `options` are those that `made` was made from. A pair that the user forbids
/// is never reported as a gap. Distances are of plain doubles: a place to look at is no proof.
std::vector<Attention> places_to_look_at(const Reconstruction& made, const ContourStack& ordered,
                                         const ReconstructOptions& options);

}  // namespace odontoscope::delaunay
