#pragma once
// A finished reconstruction with fewer triangles: its surfaces replaced, its tetrahedra as they were.

#include <cstddef>
#include <optional>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/output/report_json.h"

namespace odontoscope {

struct ModelSimplification {
  /// One for each solid, in their order; empty if nothing was to be done.
  std::vector<StructureSimplification> structures;
  std::optional<SimplificationAim> aim;
};

/// Replaces the surfaces by ones with at most `triangles` in all: the cheapest collapse of all structures comes next,
/// so each keeps what its shape needs; what structures of a partition share is simplified once, and stays shared. Each
/// keeps its topology and does not cut through itself, and therefore may keep more; `aim` tells. Adds a stage
/// "simplify" to the times. Throws Cancelled; InternalError if a result is no closed oriented manifold.
ModelSimplification simplify_surfaces(Reconstruction& reconstruction, std::size_t triangles,
                                      const Progress& progress = {});

}  // namespace odontoscope
