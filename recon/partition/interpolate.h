#pragma once
// Planar partitions between two given ones.
//
// Structures are ordered from the inside out. What the first one fills, what the first two fill, and so on are interpolated as solids of their own
// (recon/between), and a place belongs to the first of them that holds it. So interpolated neighbours never gape, and never overlap.

#include <tbb/task_arena.h>

#include <string>
#include <vector>

#include "recon/delaunay/solve_stack.h"
#include "recon/partition/overlay.h"

namespace odontoscope::partition {

/// The stack of contours round what `count` structures of least rank fill; the structure is called as the last of them.
OrderedStack filled_by(const std::vector<Borders>& borders, const std::vector<double>& heights, const Materials& materials, std::size_t count,
                       const OrderedStack& given);
/// Of one structure alone, as it is left by those that win over it.
OrderedStack left_of(const std::vector<Borders>& borders, const std::vector<double>& heights, const Materials& materials, std::size_t structure,
                     const OrderedStack& given);

struct InterpolatedBorders {
  double z = 0;
  Borders borders;
};

/// Of each slab, ascending; none where its two slices alone do.
std::vector<std::vector<InterpolatedBorders>> interpolate(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given,
                                                          tbb::task_arena& arena, const Progress& progress);

}  // namespace odontoscope::partition
