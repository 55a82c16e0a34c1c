#include "recon/partition/interpolate.h"

#include <algorithm>

#include "recon/core/error.h"
#include "recon/core/parallel.h"
#include "recon/partition/corners.h"
#include "recon/partition/face_contours.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

OrderedStack stack_of(const std::vector<Borders>& borders, const std::vector<double>& heights, const std::string& name,
                      const std::function<bool(Label)>& chosen, const OrderedStack& given) {
  OrderedStack stack;
  stack.original_slice = given.original_slice;
  stack.stack.source = given.stack.source;
  for (std::size_t k = 0; k < borders.size(); ++k) stack.stack.slices.push_back({heights[k], face_contours(borders[k], name, chosen)});
  return stack;
}

bool is_empty(const OrderedStack& stack) {
  return std::all_of(stack.stack.slices.begin(), stack.stack.slices.end(), [](const Slice& slice) { return slice.contours.empty(); });
}

/// The structure of this rank.
std::size_t of_rank(const Materials& materials, std::size_t rank) {
  return static_cast<std::size_t>(std::find(materials.rank.begin(), materials.rank.end(), rank) - materials.rank.begin());
}

}  // namespace

OrderedStack filled_by(const std::vector<Borders>& borders, const std::vector<double>& heights, const Materials& materials, std::size_t count,
                       const OrderedStack& given) {
  const auto chosen = [&](Label label) { return label != void_label && materials.rank[label - 1] < count; };
  return stack_of(borders, heights, materials.structures[of_rank(materials, count - 1)], chosen, given);
}

OrderedStack left_of(const std::vector<Borders>& borders, const std::vector<double>& heights, const Materials& materials, std::size_t structure,
                     const OrderedStack& given) {
  const auto chosen = [&](Label label) { return label == structure + 1; };
  return stack_of(borders, heights, materials.structures[structure], chosen, given);
}

std::vector<std::vector<InterpolatedBorders>> interpolate(const std::vector<Borders>& borders, const Materials& materials, const OrderedStack& given,
                                                          tbb::task_arena& arena, const Progress& progress) {
  const std::size_t slabs = borders.size() - 1, count = materials.structures.size();
  std::vector<double> heights;
  for (const Slice& slice : given.stack.slices) heights.push_back(slice.z);
  std::vector<delaunay::SurveyedStructure> filled(count);
  std::vector<bool> there(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const OrderedStack stack = filled_by(borders, heights, materials, i + 1, given);
    if (is_empty(stack)) continue;
    there[i] = true;
    filled[i] = delaunay::survey_stack({stack, materials.structures[of_rank(materials, i)], {}}, true, arena, progress);
  }
  std::vector<std::vector<InterpolatedBorders>> made(slabs);
  for_each(slabs, arena, "interpolate", progress, [&](std::size_t k) {
    std::size_t slices = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (there[i]) slices = std::max(slices, filled[i].blends[k].slices);
    if (slices == 0) return;
    const std::vector<double> shares = delaunay::even_shares(slices);
    std::vector<Slice> contours(slices);
    for (std::size_t i = 0; i < count; ++i) {
      if (!there[i] || (filled[i].slices[k].regions() == 0 && filled[i].slices[k + 1].regions() == 0)) continue;
      const auto outlines = delaunay::blend_slab(filled[i].slices, filled[i].voids, k, filled[i].links[k], filled[i].surveys[k].voids, shares,
                                                 filled[i].blends[k].options);
      for (std::size_t s = 0; s < slices; ++s)
        for (const auto& contour : outlines[s]) contours[s].contours.push_back({materials.structures[of_rank(materials, i)], contour});
    }
    Materials thin = materials;
    thin.gap = 0;
    thin.sliver = limits::sliver_share * (heights[k + 1] - heights[k]);
    for (std::size_t s = 0; s < slices; ++s) {
      contours[s].z = heights[k] + shares[s] * (heights[k + 1] - heights[k]);
      InterpolatedBorders one{contours[s].z, overlay(contours[s], thin)};
      part_corners(one.borders, materials);
      if (!one.borders.pieces.empty()) made[k].push_back(std::move(one));
    }
  });
  return made;
}

}  // namespace odontoscope::partition
