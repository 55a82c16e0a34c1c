#include "recon/delaunay/survey.h"

#include <algorithm>

#include "recon/delaunay/slab_overlay.h"

namespace odontoscope::delaunay {
namespace {

std::uint32_t regions(const ConformedSlice& slice) { return static_cast<std::uint32_t>(slice.regions()); }

bool has_material(const ConformedSlice& lower, const ConformedSlice& upper) {
  return lower.regions() > 0 && upper.regions() > 0;
}

/// The links that hold before tracking, the user's among them.
KnownLinks known_regions(const SlabSurvey& survey, const Choices& choices, const ConformedSlice& lower,
                         const ConformedSlice& upper, const Place& place) {
  KnownLinks known = links_by(survey.material, Correspondence::medial);
  known.made = correspond(known.made, choices, regions(lower), regions(upper), place).links;
  known.apart = choices.apart;
  return known;
}

/// Holes that face an empty slice open into the outside there.
KnownLinks known_voids(const SlabSurvey& survey, const SliceVoids& lower, const SliceVoids& upper,
                       bool both_have_material) {
  if (both_have_material) return links_by(survey.voids, Correspondence::medial);
  KnownLinks known;
  for (std::uint32_t v = 0; v < lower.count(); ++v) known.made.push_back({v, outside, LinkCriterion::medial});
  for (std::uint32_t v = 1; v < upper.count(); ++v) known.made.push_back({outside, v, LinkCriterion::medial});
  return known;
}

/// Drops what is wider than `medial` and what was closed, and adds what was tracked.
void settle(std::vector<RegionLink>& links, const std::vector<TrackedLink>& tracked, const ShapePairs& closed) {
  std::erase_if(links, [&](const RegionLink& link) {
    return link.criterion > LinkCriterion::medial ||
           std::find(closed.begin(), closed.end(), std::pair{link.lower, link.upper}) != closed.end();
  });
  for (const TrackedLink& link : tracked) links.push_back({link.lower, link.upper, LinkCriterion::tracked});
}

}  // namespace

SlabSurvey survey_slab(const ConformedSlice& lower, const ConformedSlice& upper, const SliceVoids& lower_voids,
                       const SliceVoids& upper_voids, Correspondence criterion) {
  if (!has_material(lower, upper)) return {};
  if (!lower.conforming || !upper.conforming) return overlaid_slab(lower, upper, lower_voids, upper_voids);
  const Correspondence widest = criterion == Correspondence::tracked ? Correspondence::overlap : criterion;
  const SlabTetrahedra tetrahedra = walked_slab(lower.planar, upper.planar);
  return {witnessed_links(tetrahedra, lower.planar, upper.planar, widest),
          witnessed_void_links(tetrahedra, lower.planar, upper.planar, voids_in(lower.planar, lower, lower_voids),
                               voids_in(upper.planar, upper, upper_voids), widest)};
}

StackDoubts track_stack(const std::vector<ConformedSlice>& slices, const std::vector<SliceVoids>& voids,
                        const std::vector<Choices>& choices, const std::vector<Place>& places,
                        std::vector<SlabSurvey>& surveys) {
  std::vector<ShapeSlice> region, hollow;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    region.push_back(region_shapes(slices[k]));
    hollow.push_back(void_shapes(slices[k], voids[k]));
  }
  std::vector<KnownLinks> of_regions, of_voids;
  for (std::size_t k = 0; k < surveys.size(); ++k) {
    of_regions.push_back(known_regions(surveys[k], choices[k], slices[k], slices[k + 1], places[k]));
    of_voids.push_back(known_voids(surveys[k], voids[k], voids[k + 1], has_material(slices[k], slices[k + 1])));
  }
  Tracking material = track(region, of_regions), tunnels = track(hollow, of_voids);
  for (std::size_t k = 0; k < surveys.size(); ++k) {
    settle(surveys[k].material, material.links[k], material.closed[k]);
    settle(surveys[k].voids, tunnels.links[k], tunnels.closed[k]);
  }
  return {std::move(material.doubtful), std::move(tunnels.doubtful)};
}

}  // namespace odontoscope::delaunay
