#pragma once
// What the slices of a stack can tell of the truth. An accessory canal that runs its whole course between two slices is
// in none of them: no reconstruction can have it, and none is to be blamed.
//
// The rule: in every slab the regions of its two slices are joined as they truly are, material and void: through the
// truth's own voxels between them; but not by a passage that neither slice shows: one that lies over nothing of its
// kind in either, and joins only what goes on without it. What is joined to nothing ends flat on its slice. The
// simplest solid with these links (docs/reconstruction.md, "Topology") has pieces, handles and bubbles; a structure is
// visible if they are the truth's. Where one piece joins several regions of each slice, any choice of links that keeps
// it whole is allowed.
//
// It asks the truth and the slices alone, never an engine.

#include <vector>

#include "measure.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// For each structure of the truth. `stack` is ordered. Voxels measure the truth's raster step, at most, along z too.
std::vector<bool> visible(const ContourStack& stack, const Truth& truth);

/// The same for one structure of masks by hand: `layers` of one slab after the other, first and last of each a slice.
bool visible(const Raster& raster, const std::vector<std::vector<Mask>>& slabs, const Topology& truth);

}  // namespace odontoscope::test
