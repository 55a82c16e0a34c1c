#pragma once
// Contours of one or more structures to what one wants of them unasked: one partition where structures share walls or
// overlap, each by itself where they keep apart.

#include <string>

#include "recon/input/validate.h"
#include "recon/partition/reconstruct_partition.h"

namespace odontoscope {

struct MadeOfStructures {
  Reconstruction reconstruction;  // a partition if its `complex` is set
  std::string no_partition;       // why none came of it though structures meet; empty if it did, or they do not
};

/// Throws as reconstruct does. `options` are those of each structure by itself; a partition takes its way between
/// slices and its threads from them.
MadeOfStructures reconstruct_structures(const ValidStack& stack, const ReconstructOptions& options = {},
                                        const Progress& progress = {});
/// Validates it first.
MadeOfStructures reconstruct_structures(const ContourStack& stack, const ReconstructOptions& options = {},
                                        const Progress& progress = {});

}  // namespace odontoscope
