#pragma once
// What each structure's solid is like between two given slices, beside what its contours and links imply (recon/delaunay/topology.h).

#include <tbb/task_arena.h>

#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"

namespace odontoscope::partition {

/// Of a structure whose contours, as the partition left them, are in `effective`. Tetrahedra of slab k: [first[k], first[k+1]) of the complex. Where a
/// region is linked to nothing, what closes over it counts as a plate. Fills `links` and `void_links` with what was taken for granted.
std::vector<SlabTopology> count_topology(const OrderedStack& effective, const std::string& structure, Label label, const LabelledComplex& complex,
                                         const std::vector<std::size_t>& first, std::vector<MadeLink>& links, std::vector<MadeVoidLink>& void_links,
                                         tbb::task_arena& arena, const Progress& progress);

}  // namespace odontoscope::partition
