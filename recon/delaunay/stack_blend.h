#pragma once
// Slices interpolated between two of a stack, by what is known of its regions, voids and links (recon/between).

#include <span>
#include <vector>

#include "recon/between/blend.h"
#include "recon/delaunay/conform.h"
#include "recon/delaunay/survey.h"
#include "recon/delaunay/voids.h"

namespace odontoscope::delaunay {

/// The contours of a slice, numbered as there.
between::Outline outline_of(const ConformedSlice& slice);

/// Of the slab between slices k and k + 1, at these shares of its height. `material` and `voids_linked` are its links.
std::vector<between::StagedOutline> blend_slab(const std::vector<ConformedSlice>& slices,
                                               const std::vector<SliceVoids>& voids, std::size_t k,
                                               const std::vector<RegionLink>& material,
                                               const std::vector<RegionLink>& voids_linked,
                                               std::span<const double> shares, const between::BlendOptions& options);

/// 1/(n+1), ..., n/(n+1).
std::vector<double> even_shares(std::size_t n);

}  // namespace odontoscope::delaunay
