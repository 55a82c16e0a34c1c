#include "engine/scene/volume_preview.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "recon/volume/thresholds.h"

namespace odontoscope {
namespace {

constexpr ValueGridLimits preview_size{.most_values = 16u << 20, .longest_side = 512};
constexpr std::size_t most_bars = 128;

Box all_of(const Volume& volume) {
  const glm::dvec3 low(volume.origin.x, volume.origin.y, volume.origin.z);
  glm::dvec3 high = low;
  for (int axis = 0; axis < 3; ++axis)
    high[axis] += static_cast<double>(volume.size[static_cast<std::size_t>(axis)] - 1) *
                  volume.spacing[static_cast<std::size_t>(axis)];
  return {low, high};
}

std::vector<float> bars_of(const Histogram& histogram) {
  const std::size_t count = std::min(most_bars, histogram.counts.size());
  std::vector<double> sums(count, 0);
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
    sums[bin * count / histogram.counts.size()] += static_cast<double>(histogram.counts[bin]);
  double most = 1;
  for (double& sum : sums) {
    sum = std::log1p(sum);
    most = std::max(most, sum);
  }
  std::vector<float> bars;
  for (const double sum : sums) bars.push_back(static_cast<float>(sum / most));
  return bars;
}

std::vector<VolumePreview::Label> labels_of(const Volume& volume) {
  std::map<std::int64_t, VolumePreview::Label> labels;
  for (const float value : volume.values) ++labels[static_cast<std::int64_t>(value)].voxels;
  for (const LabelOverlap& overlap : volume.overlaps) {
    const std::size_t shared = labels[overlap.value].voxels;
    for (const std::int64_t label : overlap.labels) labels[label].voxels += shared;
    labels.erase(overlap.value);
  }
  for (const VolumeLabel& named : volume.labels)
    if (const auto found = labels.find(named.value); found != labels.end()) found->second.name = named.name;
  std::vector<VolumePreview::Label> all;
  for (auto& [value, label] : labels) {
    label.value = value;
    if (value != 0) all.push_back(std::move(label));
  }
  return all;
}

/// Rows of the grid run upwards.
glm::dvec2 in_picture(const ValueGrid& values, double i, double j) {
  return {i + 0.5, static_cast<double>(values.size[1]) - 0.5 - j};
}

}  // namespace

VolumePreview volume_preview(const Volume& volume) {
  VolumePreview preview;
  for (std::size_t n = 0; n < 3; ++n) {
    preview.size[n] = volume.size_before[n] > 0 ? volume.size_before[n] : volume.size[n];
    preview.spacing_mm[n] = volume.spacing[n] / static_cast<double>(volume.merged[n]);
  }
  preview.values = value_grid(volume, all_of(volume), preview_size);
  const Histogram histogram = histogram_of(volume, validate_volume(volume));
  preview.low = histogram.low;
  preview.high = histogram.value(histogram.counts.size());
  preview.bars = bars_of(histogram);
  for (const std::size_t classes : {2, 3}) {
    const std::vector<double> thresholds = otsu_thresholds(histogram, classes);
    if (thresholds.size() + 1 != classes) continue;
    for (const double threshold : thresholds)
      if (std::find(preview.thresholds.begin(), preview.thresholds.end(), threshold) == preview.thresholds.end())
        preview.thresholds.push_back(threshold);
  }
  if (looks_like_labels(volume)) preview.labels = labels_of(volume);
  return preview;
}

SlicePicture slice_picture(const ValueGrid& values, std::size_t k, const ValueWindow& window) {
  SlicePicture picture{values.size[0], values.size[1], {}};
  picture.grey.reserve(picture.width * picture.height);
  const double scale = 255 / std::max(window.high - window.low, 1e-30);
  for (std::size_t row = 0; row < picture.height; ++row) {
    const float* line = values.values.data() + (k * picture.height + picture.height - 1 - row) * picture.width;
    for (std::size_t i = 0; i < picture.width; ++i)
      picture.grey.push_back(
          static_cast<std::uint8_t>(std::clamp((static_cast<double>(line[i]) - window.low) * scale, 0.0, 255.0)));
  }
  return picture;
}

std::vector<std::array<glm::dvec2, 2>> slice_outline(const ValueGrid& values, std::size_t k, double iso) {
  std::vector<std::array<glm::dvec2, 2>> pieces;
  const auto value = [&](std::size_t i, std::size_t j) {
    return static_cast<double>(values.values[(k * values.size[1] + j) * values.size[0] + i]);
  };
  for (std::size_t j = 0; j + 1 < values.size[1]; ++j)
    for (std::size_t i = 0; i + 1 < values.size[0]; ++i) {
      // Around the cell, counter-clockwise; crossings in that order, of which a saddle has four.
      const std::array<std::array<std::size_t, 2>, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      std::vector<glm::dvec2> crossings;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto &from = corners[c], &to = corners[(c + 1) % 4];
        const double a = value(from[0], from[1]), b = value(to[0], to[1]);
        if ((a >= iso) == (b >= iso)) continue;
        const double share = (iso - a) / (b - a);
        const auto between = [share](std::size_t one, std::size_t other) {
          return static_cast<double>(one) + share * (static_cast<double>(other) - static_cast<double>(one));
        };
        crossings.push_back(in_picture(values, between(from[0], to[0]), between(from[1], to[1])));
      }
      if (crossings.size() == 4) {
        // The middle decides which two corners are joined.
        const bool joined = value(i, j) + value(i + 1, j) + value(i + 1, j + 1) + value(i, j + 1) >= 4 * iso;
        if (joined != (value(i, j) >= iso)) std::rotate(crossings.begin(), crossings.begin() + 1, crossings.end());
      }
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) pieces.push_back({crossings[c], crossings[c + 1]});
    }
  return pieces;
}

std::vector<std::array<glm::dvec2, 2>> label_outline(const ValueGrid& values, std::size_t k,
                                                     const std::set<std::int64_t>& labels) {
  std::vector<std::array<glm::dvec2, 2>> pieces;
  const std::size_t pixels = values.size[0] * values.size[1];
  ValueGrid mask;
  mask.size = {values.size[0], values.size[1], 1};
  for (const std::int64_t label : labels) {
    mask.values.assign(pixels, 0);
    for (std::size_t n = 0; n < pixels; ++n)
      mask.values[n] = values.values[k * pixels + n] == static_cast<float>(label) ? 1.0f : 0.0f;
    const auto one = slice_outline(mask, 0, 0.5);
    pieces.insert(pieces.end(), one.begin(), one.end());
  }
  return pieces;
}

std::size_t fullest_slice(const ValueGrid& values, double iso) {
  const std::size_t pixels = values.size[0] * values.size[1];
  const std::size_t middle = values.size[2] / 2;
  std::size_t best = middle, most = 0;
  for (std::size_t k = 0; k < values.size[2]; ++k) {
    const auto begin = values.values.begin() + static_cast<std::ptrdiff_t>(k * pixels);
    const auto full =
        static_cast<std::size_t>(std::count_if(begin, begin + static_cast<std::ptrdiff_t>(pixels),
                                               [iso](float value) { return static_cast<double>(value) >= iso; }));
    const auto off = [middle](std::size_t slice) { return slice > middle ? slice - middle : middle - slice; };
    if (full > most || (full == most && off(k) < off(best))) most = full, best = k;
  }
  return best;
}

}  // namespace odontoscope
