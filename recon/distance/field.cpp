#include "recon/distance/field.h"

#include <algorithm>
#include <limits>
#include <span>

#include "recon/core/parallel.h"
#include "recon/distance/slice_sampler.h"

namespace odontoscope {
namespace {

constexpr std::string_view field_stage = "distance field";

class FieldSampler {
 public:
  FieldSampler(const ContourStack& stack, const std::string& structure, const Grid& grid, FieldKind kind,
               const Progress& progress)
      : stack_(stack), structure_(structure), grid_(grid), kind_(kind), progress_(progress), signs_(grid.size(), 1) {}

  Field run() {
    Field field{structure_, std::vector<double>(grid_.size(), limits::empty_value)};
    constexpr double signs_share = 0.2;  // of the time, roughly
    for_each(grid_.layers.size(), field_stage, Share{0, signs_share}, progress_, [&](std::size_t k) {
      if (is_empty(k)) return;
      distance::sample_signs(slice(k), structure_, grid_, signs_of(k));
    });
    for_each(grid_.layers.size(), field_stage, Share{signs_share, 1}, progress_, [&](std::size_t k) {
      if (is_empty(k)) return;
      fill_layer(k, std::span(field.values).subspan(k * grid_.layer_size(), grid_.layer_size()));
    });
    return field;
  }

 private:
  const Slice& slice(std::size_t layer) const { return stack_.slices[*grid_.layers[layer].slice]; }
  bool is_empty(std::size_t layer) const {
    if (!grid_.layers[layer].slice) return true;
    const auto& contours = slice(layer).contours;
    return std::none_of(contours.begin(), contours.end(),
                        [this](const Contour& c) { return c.structure == structure_; });
  }
  std::span<std::int8_t> signs_of(std::size_t layer) {
    return std::span(signs_).subspan(layer * grid_.layer_size(), grid_.layer_size());
  }

  void fill_layer(std::size_t layer, std::span<double> values) {
    const std::span<const std::int8_t> signs = signs_of(layer);
    std::transform(signs.begin(), signs.end(), values.begin(),
                   [](std::int8_t sign) { return sign * limits::empty_value; });
    if (kind_ == FieldKind::sign) return;
    std::vector<std::uint8_t> wanted(values.size(), kind_ == FieldKind::signed_distance ? 1 : 0);
    if (kind_ == FieldKind::hybrid) {
      want_crossed_voxels(layer - 1, wanted);
      want_crossed_voxels(layer, wanted);
    }
    std::vector<double> distances(values.size());
    distance::sample_distances(slice(layer), structure_, grid_, wanted, distances);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!wanted[i]) continue;
      // Rounding must not put on the contour what the exact test did not.
      values[i] = signs[i] * std::max(distances[i], std::numeric_limits<double>::min());
    }
  }

  /// Marks the points that voxels between `lower` and the layer above it have in common with one of the two layers.
  void want_crossed_voxels(std::size_t lower, std::vector<std::uint8_t>& wanted) const {
    if (is_empty(lower) || is_empty(lower + 1)) return;
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row) {
      for (std::size_t column = 0; column + 1 < grid_.columns; ++column) {
        if (!is_crossed(column, row, lower)) continue;
        const std::size_t i = row * grid_.columns + column;
        wanted[i] = wanted[i + 1] = wanted[i + grid_.columns] = wanted[i + grid_.columns + 1] = 1;
      }
    }
  }

  bool is_crossed(std::size_t column, std::size_t row, std::size_t layer) const {
    const std::int8_t* first = &signs_[grid_.index(column, row, layer)];
    if (*first == 0) return true;
    for (const std::size_t up : {std::size_t{0}, grid_.layer_size()}) {
      for (const std::size_t on : {std::size_t{0}, grid_.columns}) {
        if (first[up + on] != *first || first[up + on + 1] != *first) return true;
      }
    }
    return false;
  }

  const ContourStack& stack_;
  const std::string& structure_;
  const Grid& grid_;
  const FieldKind kind_;
  const Progress& progress_;
  std::vector<std::int8_t> signs_;
};

}  // namespace

Field sample_field(const ContourStack& ordered_stack, const std::string& structure, const Grid& grid,
                   const FieldOptions& options, const Progress& progress) {
  return FieldSampler(ordered_stack, structure, grid, options.kind, progress).run();
}

}  // namespace odontoscope
