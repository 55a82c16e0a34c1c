#pragma once
// Which regions and which voids of a whole stack belong together: each slab's witnesses, then, for
// Correspondence::tracked, what hangs free is followed over several slices (track.h).

#include <cstdint>
#include <vector>

#include "recon/delaunay/correspond.h"
#include "recon/delaunay/track.h"
#include "recon/delaunay/voids.h"

namespace odontoscope::delaunay {

/// Links of a slab. A pair that must stay apart may be among those of material; correspond() leaves it out.
struct SlabSurvey {
  std::vector<RegionLink> material, voids;  // by criterion, then by pair; tracked ones last
};

/// Of one slab. Nothing where one of its slices is empty. Where one is not conforming, all links are `medial`
/// (slab_overlay.h).
SlabSurvey survey_slab(const ConformedSlice& lower, const ConformedSlice& upper, const SliceVoids& lower_voids,
                       const SliceVoids& upper_voids, Correspondence criterion);

/// Choices that the slices do not settle; of voids numbers are those of SliceVoids.
struct StackDoubts {
  std::vector<DoubtfulLink> material, voids;
};

/// `surveys`, one for each slab, hold links up to `overlap`, as survey_slab gives them for `tracked`; on return those
/// up to `medial` and the tracked ones. Throws InputError link-contradiction as correspond() does; `places` name the
/// slabs.
StackDoubts track_stack(const std::vector<ConformedSlice>& slices, const std::vector<SliceVoids>& voids,
                        const std::vector<Choices>& choices, const std::vector<Place>& places,
                        std::vector<SlabSurvey>& surveys);

}  // namespace odontoscope::delaunay
