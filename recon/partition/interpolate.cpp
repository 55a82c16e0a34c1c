#include "recon/partition/interpolate.h"

#include <algorithm>

#include "recon/core/limits.h"
#include "recon/partition/face_contours.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {

Interpolator::Interpolator(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given, tbb::task_arena& arena,
                           const Progress& progress)
    : materials_(materials) {
  for (const Slice& slice : given.stack.slices) heights_.push_back(slice.z);
  const std::size_t count = materials.structures.size();
  for (std::size_t rank = 0; rank < count; ++rank) {
    const auto outermost = static_cast<std::size_t>(std::find(materials.rank.begin(), materials.rank.end(), rank) - materials.rank.begin());
    const std::string& name = materials.structures[outermost];
    const auto within = [&](Label label) { return label != void_label && materials.rank[label - 1] <= rank; };
    OrderedStack stack;
    stack.original_slice = given.original_slice;
    stack.stack.source = given.stack.source;
    bool empty = true;
    for (std::size_t k = 0; k < borders.size(); ++k) {
      stack.stack.slices.push_back({heights_[k], face_contours(borders[k], name, within)});
      empty = empty && stack.stack.slices.back().contours.empty();
    }
    if (empty) continue;
    structures_.push_back(outermost);
    filled_.push_back(delaunay::survey_stack({stack, name, {}}, arena, progress));
  }
}

std::vector<Interpolation> Interpolator::attempts(std::size_t k) const {
  double travel = 0;
  for (const delaunay::SurveyedStructure& one : filled_)
    travel = std::max(travel, between::need(delaunay::outline_of(one.slices[k]), delaunay::outline_of(one.slices[k + 1])).travel);
  std::vector<Interpolation> list{{1, {.strips = true}}, {3, {.strips = true}}, {1, {.strips = false}}, {3, {.strips = false}}};
  const bool gentle = travel < odontoscope::limits::steep * (heights_[k + 1] - heights_[k]);
  list.insert(gentle ? list.begin() : list.end(), Interpolation{});
  list.push_back({7, {.strips = false}});
  return list;
}

std::vector<InterpolatedBorders> Interpolator::between(std::size_t k, const Interpolation& how) const {
  std::vector<InterpolatedBorders> made;
  if (how.slices == 0) return made;
  const double height = heights_[k + 1] - heights_[k];
  const std::vector<double> shares = delaunay::even_shares(how.slices);
  std::vector<Slice> contours(how.slices);
  for (std::size_t i = 0; i < filled_.size(); ++i) {
    const delaunay::SurveyedStructure& one = filled_[i];
    if (one.slices[k].regions() == 0 && one.slices[k + 1].regions() == 0) continue;
    const auto outlines = delaunay::blend_slab(one.slices, one.voids, k, one.links[k], one.surveys[k].voids, shares, how.options);
    for (std::size_t s = 0; s < how.slices; ++s)
      for (const auto& contour : outlines[s]) contours[s].contours.push_back({materials_.structures[structures_[i]], contour});
  }
  Materials thin = materials_;
  thin.gap = 0;
  thin.sliver = limits::sliver_share * height;
  for (std::size_t s = 0; s < how.slices; ++s) {
    InterpolatedBorders one{heights_[k] + shares[s] * height, overlay(contours[s], thin)};
    const double below = made.empty() ? heights_[k] : made.back().z;
    if (!one.borders.pieces.empty() && below < one.z && one.z < heights_[k + 1]) made.push_back(std::move(one));
  }
  return made;
}

}  // namespace odontoscope::partition
