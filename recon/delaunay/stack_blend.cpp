#include "recon/delaunay/stack_blend.h"

namespace odontoscope::delaunay {
namespace {

std::size_t contour_of_void(const SliceVoids& voids, std::uint32_t number) {
  return number == outside ? between::outside : voids.hole_contour[number - 1];
}

}  // namespace

between::Outline outline_of(const ConformedSlice& slice) {
  between::Outline all;
  for (std::size_t c = 0; c < slice.contour_number.size(); ++c)
    all.emplace_back(slice.planar.points.begin() + slice.first_point[c],
                     slice.planar.points.begin() + slice.first_point[c + 1]);
  return all;
}

std::vector<between::StagedOutline> blend_slab(const std::vector<ConformedSlice>& slices,
                                               const std::vector<SliceVoids>& voids, std::size_t k,
                                               const std::vector<RegionLink>& material,
                                               const std::vector<RegionLink>& voids_linked,
                                               std::span<const double> shares, const between::BlendOptions& options) {
  const between::Outline lower = outline_of(slices[k]), upper = outline_of(slices[k + 1]);
  between::Outline before, after;
  between::Surroundings around;
  around.lower = &lower;
  around.upper = &upper;
  around.z_lower = slices[k].z;
  around.z_upper = slices[k + 1].z;
  if (k > 0 && slices[k - 1].regions() > 0) {
    before = outline_of(slices[k - 1]);
    around.before = &before;
    around.z_before = slices[k - 1].z;
  }
  if (k + 2 < slices.size() && slices[k + 2].regions() > 0) {
    after = outline_of(slices[k + 2]);
    around.after = &after;
    around.z_after = slices[k + 2].z;
  }
  for (const RegionLink& link : material)
    around.material.push_back({slices[k].outer_contour[link.lower], slices[k + 1].outer_contour[link.upper]});
  for (const RegionLink& link : voids_linked)
    around.voids.push_back({contour_of_void(voids[k], link.lower), contour_of_void(voids[k + 1], link.upper)});
  return between::blend_in_stages(around, shares, options);
}

std::vector<double> even_shares(std::size_t n) {
  std::vector<double> shares;
  for (std::size_t i = 1; i <= n; ++i) shares.push_back(static_cast<double>(i) / static_cast<double>(n + 1));
  return shares;
}

}  // namespace odontoscope::delaunay
