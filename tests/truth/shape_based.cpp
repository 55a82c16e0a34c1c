#include "shape_based.h"

#include <algorithm>
#include <cmath>

#include "recon/distance/field.h"
#include "recon/distance/grid.h"

namespace odontoscope::test {

ShapeBased::ShapeBased(const ContourStack& stack, const std::string& structure, const Raster& raster)
    : raster_(raster) {
  Grid grid{raster.x0, raster.y0, raster.step, raster.step, raster.columns, raster.rows, {}};
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    heights_.push_back(stack.slices[i].z);
    grid.layers.push_back({stack.slices[i].z, i});
  }
  values_ = sample_field(stack, structure, grid, {FieldKind::signed_distance}).values;
  fill_empty(stack, structure);
}

void ShapeBased::fill_empty(const ContourStack& stack, const std::string& structure) {
  const std::size_t slices = heights_.size();
  std::vector<double> depth(slices, 0);
  std::vector<bool> empty(slices);
  for (std::size_t i = 0; i < slices; ++i) {
    const std::vector<Contour>& contours = stack.slices[i].contours;
    empty[i] = std::none_of(contours.begin(), contours.end(), [&](const Contour& c) { return c.structure == structure; });
    if (!empty[i]) depth[i] = -*std::min_element(layer(i), layer(i) + raster_.size());
  }
  constexpr double nothing_near = 1;  // mm; between two slices that are both empty
  for (std::size_t i = 0; i < slices; ++i) {
    if (!empty[i]) continue;
    double outside = std::max(i > 0 ? depth[i - 1] : 0, i + 1 < slices ? depth[i + 1] : 0);
    if (outside <= 0) outside = nothing_near;
    std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>(i * raster_.size()), raster_.size(), outside);
  }
}

Mask ShapeBased::between(std::size_t slab, double t, Blend blend) const {
  Mask mask(raster_.size());
  const double *below = layer(slab), *above = layer(slab + 1);
  const double *before = slab > 0 ? layer(slab - 1) : nullptr, *after = slab + 2 < heights_.size() ? layer(slab + 2) : nullptr;
  const double height = heights_[slab + 1] - heights_[slab];
  const double with_before = before ? height / (heights_[slab + 1] - heights_[slab - 1]) : 1;
  const double with_after = after ? height / (heights_[slab + 2] - heights_[slab]) : 1;
  for (std::size_t p = 0; p < mask.size(); ++p) {
    double value = (1 - t) * below[p] + t * above[p];
    if (blend == Blend::cubic) {
      // Hermite: slopes over the slab's height, from the slices on both sides, or from one where there is no other.
      const double start = (above[p] - (before ? before[p] : below[p])) * with_before;
      const double end = ((after ? after[p] : above[p]) - below[p]) * with_after;
      value = (1 + 2 * t) * (1 - t) * (1 - t) * below[p] + t * t * (3 - 2 * t) * above[p] +
              t * (1 - t) * ((1 - t) * start - t * end);
    }
    mask[p] = value < 0;
  }
  return mask;
}

Topology ShapeBased::topology(Blend blend) const {
  Voxels voxels(raster_.columns, raster_.rows, 0);
  const auto add = [&](const Mask& mask) {
    voxels.values.insert(voxels.values.end(), mask.begin(), mask.end());
    ++voxels.layers;
  };
  for (std::size_t slab = 0; slab + 1 < heights_.size(); ++slab) {
    const auto layers = static_cast<int>(std::ceil((heights_[slab + 1] - heights_[slab]) / raster_.step - 1e-9));
    for (int i = 0; i < layers; ++i) add(between(slab, static_cast<double>(i) / layers, blend));
  }
  add(between(heights_.size() - 2, 1.0, blend));
  return topology_of(voxels, 1);
}

}  // namespace odontoscope::test
