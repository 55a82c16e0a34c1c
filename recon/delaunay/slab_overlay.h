#pragma once
// Which regions and which voids of two slices lie over each other where the slab between them cannot be walked
// (conform.h, constrained): by the middles of triangles.

#include "recon/delaunay/survey.h"

namespace odontoscope::delaunay {

/// Pairs of which a triangle of one has its middle in the other, all as `medial`; the outside with the outside as
/// `reverse`. Exact but for the rounding of the middles. Preconditions: both slices have regions.
SlabSurvey overlaid_slab(const ConformedSlice& lower, const ConformedSlice& upper, const SliceVoids& lower_voids,
                         const SliceVoids& upper_voids);

}  // namespace odontoscope::delaunay
