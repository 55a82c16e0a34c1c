#pragma once
// What each structure's solid has to be like between two given slices, as contours and links imply
// (recon/delaunay/topology.h).

#include <tbb/task_arena.h>

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"

namespace odontoscope::partition {

struct ImpliedTopology {
  std::vector<Topology> of_slab;
  std::vector<MadeLink> links;  // that were taken for granted; contours are numbered as in the stack
  std::vector<MadeVoidLink> void_links;
  std::vector<Doubt> doubts;  // choices that the slices do not settle
};

/// Of a structure of the stack. Where a region is linked to nothing, what closes over it counts as a plate.
ImpliedTopology implied_topology(const OrderedStack& stack, const std::string& structure, tbb::task_arena& arena,
                                 const Progress& progress);

}  // namespace odontoscope::partition
