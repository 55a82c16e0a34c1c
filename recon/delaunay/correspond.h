#pragma once
// Step 3, correspondence: which regions of the two slices of a slab belong together.

#include <cstdint>
#include <utility>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/delaunay/slab.h"

namespace odontoscope::delaunay {

struct RegionLink {
  std::uint32_t lower = 0, upper = 0;  // regions
  LinkCriterion criterion = LinkCriterion::medial;
};

/// The user's word on one slab, in region numbers.
struct Choices {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined, apart;  // (lower, upper)
};

/// Regions of one slab that are reconstructed as one piece.
struct Component {
  std::vector<std::uint32_t> lower, upper;  // ascending
};

/// Pairs of regions with a witness among the tetrahedra, each with the strictest criterion that has one, in the order
/// reverse, medial, overlap, then by region. Criteria wider than `widest` are not looked at.
std::vector<RegionLink> witnessed_links(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper,
                                        Correspondence widest);

struct Correspondences {
  std::vector<RegionLink> links;      // those that were made, by lower, upper
  std::vector<Component> components;  // by lowest region; those with regions in both slices only
};

/// The user's links first, then the witnessed ones, skipping each that would put a pair that must stay apart into one
/// component. Throws InputError link-contradiction if the user's own links do that. `place` names the slab in messages.
Correspondences correspond(const std::vector<RegionLink>& witnessed, const Choices& choices,
                           std::uint32_t lower_regions, std::uint32_t upper_regions, const Place& place);

/// Does the component hold both ends of a pair that must stay apart?
bool joins_apart(const Component& component, const Choices& choices);

}  // namespace odontoscope::delaunay
