#include "shape_based.h"

#include <algorithm>
#include <cmath>

#include "recon/distance/field.h"
#include "recon/distance/grid.h"
#include "recon/distance/marching_cubes.h"

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
  empty_.resize(slices);
  for (std::size_t i = 0; i < slices; ++i) {
    const std::vector<Contour>& contours = stack.slices[i].contours;
    empty_[i] =
        std::none_of(contours.begin(), contours.end(), [&](const Contour& c) { return c.structure == structure; });
    if (!empty_[i]) depth[i] = -*std::min_element(layer(i), layer(i) + raster_.size());
  }
  constexpr double nothing_near = 1;  // mm; between two empty slices, where any value beyond 0 does
  for (std::size_t i = 0; i < slices; ++i) {
    if (!empty_[i]) continue;
    double outside = std::max(i > 0 ? depth[i - 1] : 0, i + 1 < slices ? depth[i + 1] : 0);
    if (outside <= 0) outside = nothing_near;
    std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>(i * raster_.size()), raster_.size(), outside);
  }
}

void ShapeBased::blend_at(std::size_t slab, double t, Blend blend, double* values) const {
  const double *below = layer(slab), *above = layer(slab + 1);
  const double* before = slab > 0 && !empty_[slab - 1] ? layer(slab - 1) : nullptr;
  const double* after = slab + 2 < heights_.size() && !empty_[slab + 2] ? layer(slab + 2) : nullptr;
  if (empty_[slab] || empty_[slab + 1]) blend = Blend::linear;
  const double height = heights_[slab + 1] - heights_[slab];
  const double with_before = before ? height / (heights_[slab + 1] - heights_[slab - 1]) : 1;
  const double with_after = after ? height / (heights_[slab + 2] - heights_[slab]) : 1;
  for (std::size_t p = 0; p < raster_.size(); ++p) {
    double value = (1 - t) * below[p] + t * above[p];
    if (blend == Blend::cubic) {
      // Hermite: slopes over the slab's height, from the slices on both sides, or from one where there is no other.
      const double start = (above[p] - (before ? before[p] : below[p])) * with_before;
      const double end = ((after ? after[p] : above[p]) - below[p]) * with_after;
      value = (1 + 2 * t) * (1 - t) * (1 - t) * below[p] + t * t * (3 - 2 * t) * above[p] +
              t * (1 - t) * ((1 - t) * start - t * end);
    }
    values[p] = value;
  }
}

Mask ShapeBased::between(std::size_t slab, double share, Blend blend) const {
  std::vector<double> values(raster_.size());
  blend_at(slab, share, blend, values.data());
  Mask mask(values.size());
  std::transform(values.begin(), values.end(), mask.begin(), [](double value) { return value < 0; });
  return mask;
}

SurfaceMesh ShapeBased::surface(Blend blend) const {
  constexpr double end = 1e-3;  // mm beyond the outer slices: as good as flat
  Grid grid{raster_.x0, raster_.y0, raster_.step, raster_.step, raster_.columns, raster_.rows, {}};
  Field field;
  const auto add = [&](double z, std::size_t slab, double share) {
    grid.layers.push_back({z, std::nullopt});
    const std::size_t before = field.values.size();
    field.values.resize(before + raster_.size(), 1.0);
    if (slab + 1 < heights_.size()) blend_at(slab, share, blend, field.values.data() + before);
  };
  const std::size_t none = heights_.size();
  add(heights_.front() - end, none, 0);
  for (std::size_t slab = 0; slab + 1 < heights_.size(); ++slab) {
    const double height = heights_[slab + 1] - heights_[slab];
    const auto layers = static_cast<int>(std::ceil(height / (2 * raster_.step) - 1e-9));
    for (int i = 0; i < layers; ++i) add(heights_[slab] + height * i / layers, slab, static_cast<double>(i) / layers);
  }
  add(heights_.back(), heights_.size() - 2, 1);
  add(heights_.back() + end, none, 0);
  return march(grid, field, CaseTable::consistent).mesh;
}

}  // namespace odontoscope::test
