#include "recon/partition/interpolate.h"

#include <algorithm>
#include <tuple>

#include "recon/core/limits.h"
#include "recon/partition/face_contours.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {

namespace {

bool has_none(const OrderedStack& stack) {
  return std::all_of(stack.stack.slices.begin(), stack.stack.slices.end(),
                     [](const Slice& slice) { return slice.contours.empty(); });
}

std::string filled_name(const std::string& structure) { return structure + "\1filled"; }  // no name has such a letter

}  // namespace

Interpolator::Interpolator(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given,
                           tbb::task_arena& arena, const Progress& progress)
    : borders_(borders), materials_(materials), given_(given) {
  for (const Slice& slice : given.stack.slices) heights_.push_back(slice.z);
  const std::size_t count = materials.structures.size();
  for (std::size_t rank = 0; rank < count; ++rank) {
    const auto outermost = static_cast<std::size_t>(std::find(materials.rank.begin(), materials.rank.end(), rank) -
                                                    materials.rank.begin());
    const OrderedStack stack = contours_of(materials.structures[outermost], [&](Label label) {
      return label != void_label && materials.rank[label - 1] <= rank;
    });
    if (has_none(stack)) continue;
    structures_.push_back(outermost);
    filled_.push_back(delaunay::survey_stack({stack, materials.structures[outermost], {}}, arena, progress));
  }
}

OrderedStack Interpolator::contours_of(const std::string& name, const std::function<bool(Label)>& chosen) const {
  OrderedStack stack;
  stack.original_slice = given_.original_slice;
  stack.stack.source = given_.stack.source;
  for (std::size_t k = 0; k < borders_.size(); ++k)
    stack.stack.slices.push_back({heights_[k], face_contours(borders_[k], name, chosen)});
  return stack;
}

void Interpolator::survey_own(tbb::task_arena& arena, const Progress& progress) {
  own_.resize(filled_.size());
  for (std::size_t i = 1; i < filled_.size(); ++i) {
    const std::string& name = materials_.structures[structures_[i]];
    const OrderedStack stack = contours_of(name, [&](Label label) { return label == structures_[i] + 1; });
    if (!has_none(stack)) own_[i] = delaunay::survey_stack({stack, name, {}}, arena, progress);
  }
}

std::vector<Interpolation> Interpolator::attempts(std::size_t k) const {
  double travel = 0;
  for (const delaunay::SurveyedStructure& one : filled_)
    travel = std::max(
        travel, between::need(delaunay::outline_of(one.slices[k]), delaunay::outline_of(one.slices[k + 1])).travel);
  std::vector<Interpolation> list{
      {1, {.strips = true}}, {3, {.strips = true}}, {1, {.strips = false}}, {3, {.strips = false}}};
  const double slope = travel / (heights_[k + 1] - heights_[k]);
  const bool gentle = slope < odontoscope::limits::steep;
  list.insert(gentle ? list.begin() : list.end(), Interpolation{});
  // The steps that a level roof or floor leaves are as high as the slices are apart.
  if (slope > limits::level) list.insert(list.begin(), Interpolation{3, {.strips = false}});
  if (slope > limits::very_level) list.insert(list.begin(), Interpolation{7, {.strips = false}});
  list.push_back({7, {.strips = false}});
  if (!deserves_more(k)) return list;
  for (const auto& [slices, strips, finer] :
       {std::tuple{5, true, 1}, {5, false, 1}, {1, true, 3}, {3, false, 3}, {15, false, 1}}) {
    Interpolation one{static_cast<std::size_t>(slices), {.strips = strips}, true};
    one.options.finer = static_cast<std::size_t>(finer);
    list.push_back(one);
  }
  for (const std::size_t slices : {3, 7})
    for (const bool strips : {true, false}) list.push_back({slices, {.strips = strips, .keep_links = true}, true});
  return list;
}

std::vector<Interpolation> Interpolator::own_attempts(std::size_t k) const {
  std::vector<Interpolation> list;
  for (const auto own : {Interpolation::Own::inner_first, Interpolation::Own::outer_first})
    for (const auto& [slices, strips] : {std::pair{1, true}, {3, true}, {1, false}, {3, false}, {7, false}})
      list.push_back({static_cast<std::size_t>(slices), {.strips = strips}, false, own});
  if (deserves_more(k))
    for (const auto own : {Interpolation::Own::inner_first, Interpolation::Own::outer_first})
      list.push_back({15, {.strips = false}, true, own});
  return list;
}

/// As for single structures: anatomy has few outlines of many points, and late attempts mend those.
bool Interpolator::deserves_more(std::size_t k) const {
  std::size_t most_points = 0;
  for (const delaunay::SurveyedStructure& one : filled_) {
    std::size_t contours = 0, points = 0, added = 0;
    for (const std::size_t slice : {k, k + 1}) {
      contours += one.slices[slice].contour_number.size();
      points += one.slices[slice].planar.points.size() - one.slices[slice].steiner_points;
      added += one.slices[slice].steiner_points;
    }
    if (contours > odontoscope::limits::few_contours || added > points) return false;
    most_points = std::max(most_points, points);
  }
  return most_points >= odontoscope::limits::fine_outlines;
}

void Interpolator::blend(const Surveyed& one, std::size_t k, const std::vector<double>& shares,
                         const between::BlendOptions& options, const std::string& name,
                         std::vector<Slice>& contours) const {
  if (one.slices[k].regions() == 0 && one.slices[k + 1].regions() == 0) return;
  const auto outlines =
      delaunay::blend_slab(one.slices, one.voids, k, one.links[k], one.surveys[k].voids, shares, options);
  for (std::size_t s = 0; s < outlines.size(); ++s)
    for (const auto& contour : outlines[s].outline) contours[s].contours.push_back({name, contour});
}

/// The structures, and after them what each fills.
Materials Interpolator::stand_ins(Interpolation::Own own) const {
  Materials all = materials_;
  if (own == Interpolation::Own::outer_first)
    for (std::uint32_t& rank : all.rank) rank = static_cast<std::uint32_t>(all.rank.size()) - 1 - rank;
  for (std::size_t i = 1; i < filled_.size(); ++i) {
    all.rank.push_back(static_cast<std::uint32_t>(all.structures.size()));
    all.structures.push_back(filled_name(materials_.structures[structures_[i]]));
    all.stand_ins.push_back({static_cast<Label>(structures_[i - 1] + 1), static_cast<Label>(structures_[i] + 1)});
  }
  return all;
}

std::vector<InterpolatedBorders> Interpolator::between(std::size_t k, const Interpolation& how) const {
  std::vector<InterpolatedBorders> made;
  if (how.slices == 0) return made;
  const double height = heights_[k + 1] - heights_[k];
  const std::vector<double> shares = delaunay::even_shares(how.slices);
  std::vector<Slice> contours(how.slices);
  for (std::size_t i = 0; i < filled_.size(); ++i) {
    const std::string& name = materials_.structures[structures_[i]];
    const bool hollow = how.own != Interpolation::Own::none && i > 0;
    blend(filled_[i], k, shares, how.options, hollow ? filled_name(name) : name, contours);
    if (hollow && own_[i]) blend(*own_[i], k, shares, how.options, name, contours);
  }
  Materials thin = how.own == Interpolation::Own::none ? materials_ : stand_ins(how.own);
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
