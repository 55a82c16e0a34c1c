#pragma once
// A slab solved through slices that are interpolated between its two (recon/between): thinner slabs, whose Delaunay
// triangulations follow the tooth where that of the two slices alone reaches across. Only the two given slices are kept
// exactly.

#include <optional>
#include <vector>

#include "recon/between/blend.h"
#include "recon/delaunay/solve_slab.h"

namespace odontoscope::delaunay {

struct Interpolated {
  double z = 0;
  between::Outline outline;
};

/// All pieces as one, whose added points are those of the interpolated slices and what lifting added. Empty if regions
/// of the two slices come out joined otherwise than `components` says, if an interpolated slice has many times their
/// contours, if it cannot be conformed or only by far more points than it has, or if two are too close. A region that
/// is linked to nothing may carry a piece that ends between the slices.
std::optional<SolvedSlab> solve_through(const SlabTask& task, const std::vector<Component>& components,
                                        const std::vector<Interpolated>& between, const Progress& progress);

/// Of a solved slab, counted.
Topology topology_of(const ConformedSlice& lower, const ConformedSlice& upper, const SolvedSlab& solved);

}  // namespace odontoscope::delaunay
