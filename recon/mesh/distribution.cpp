#include "recon/mesh/distribution.h"

#include <algorithm>

#include "recon/core/limits.h"

namespace odontoscope {

Distribution distribution_of(std::vector<double>& values, double low, double high) {
  Distribution distribution;
  distribution.histogram.assign(limits::histogram_bins, 0);
  distribution.histogram_low = low;
  distribution.histogram_high = high;
  if (values.empty()) return distribution;

  const double bins_per_unit = static_cast<double>(limits::histogram_bins) / (high - low);
  const double last_bin = static_cast<double>(limits::histogram_bins - 1);
  double sum = 0;
  distribution.min = distribution.max = values.front();
  for (const double value : values) {
    sum += value;
    distribution.min = std::min(distribution.min, value);
    distribution.max = std::max(distribution.max, value);
    ++distribution.histogram[static_cast<std::size_t>(std::clamp((value - low) * bins_per_unit, 0.0, last_bin))];
  }
  distribution.mean = sum / static_cast<double>(values.size());

  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  distribution.median = *middle;
  if (values.size() % 2 == 0) distribution.median = (*middle + *std::max_element(values.begin(), middle)) / 2;
  return distribution;
}

}  // namespace odontoscope
