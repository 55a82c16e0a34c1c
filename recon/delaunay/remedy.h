#pragma once
// What to advise where a region is linked to nothing: a link that was tried and joins it.

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/delaunay/solve_slab.h"

namespace odontoscope::delaunay {

/// A region of one of the task's two slices.
struct RegionOfSlab {
  bool in_lower = true;
  std::uint32_t number = 0;
};

/// The link of `region` with the nearest region of the other slice that can be built as the user's own word; none if no
/// near one can. `witnessed` are the links that `task` was made from.
std::optional<RegionLink> remedy(const SlabTask& task, const std::vector<RegionLink>& witnessed, RegionOfSlab region,
                                 const Progress& progress);

}  // namespace odontoscope::delaunay
