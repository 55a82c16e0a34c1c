#include "recon/volume/thresholds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

bool is_whole(const Volume& volume) {
  return std::all_of(volume.values.begin(), volume.values.end(), [](float v) { return v == std::floor(v); });
}

std::vector<std::uint64_t> counted(const Volume& volume, double low, double width, std::size_t bins) {
  std::vector<std::uint64_t> counts(bins);
  for (const float value : volume.values) {
    const double at = std::floor((static_cast<double>(value) - low) / width);
    ++counts[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(bins - 1)))];
  }
  return counts;
}

/// Where the given share of voxels lies below, to within a bin of `rough`.
double quantile(const Histogram& rough, double share, std::size_t voxels) {
  std::uint64_t below = 0;
  for (std::size_t bin = 0; bin < rough.counts.size(); ++bin) {
    below += rough.counts[bin];
    if (static_cast<double>(below) > share * static_cast<double>(voxels)) return rough.value(bin);
  }
  return rough.value(rough.counts.size());
}

/// Sums over the bins before each: of counts, and of counts times the bin's number.
struct Sums {
  std::vector<double> count{0}, first{0};
  explicit Sums(const Histogram& histogram) {
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
      const auto n = static_cast<double>(histogram.counts[bin]);
      count.push_back(count.back() + n);
      first.push_back(first.back() + n * static_cast<double>(bin));
    }
  }
  /// A class of bins [from, to): its share of the variance between classes, but for a constant.
  double gain(std::size_t from, std::size_t to) const {
    const double n = count[to] - count[from], s = first[to] - first[from];
    return n > 0 ? s * s / n : 0;
  }
};

std::string bar(double share) {
  constexpr double cells = 50;
  return std::string(static_cast<std::size_t>(std::lround(share * cells)), '#');
}

}  // namespace

Histogram histogram_of(const Volume& volume, ValueRange range) {
  const double low = range.lowest, high = range.highest;
  Histogram result{low, 1, {}, range};
  const auto fineness = static_cast<double>(limits::histogram_fineness);
  if (high - low < fineness && is_whole(volume)) {
    result.counts = counted(volume, low, 1, static_cast<std::size_t>(high - low) + 1);
    return result;
  }
  Histogram rough = result;
  constexpr std::size_t rough_bins = 1u << 16;
  rough.width = std::max((high - low) / static_cast<double>(rough_bins), std::numeric_limits<double>::min());
  rough.counts = counted(volume, low, rough.width, rough_bins);
  result.low = quantile(rough, limits::histogram_outliers, volume.values.size());
  const double top = quantile(rough, 1 - limits::histogram_outliers, volume.values.size()) + rough.width;
  result.width = (top - result.low) / fineness;
  if (is_whole(volume)) result.width = std::max(std::ceil(result.width), 1.0);
  result.counts = counted(volume, result.low, result.width, limits::histogram_fineness);
  return result;
}

std::vector<double> otsu_thresholds(const Histogram& histogram, std::size_t classes) {
  const std::size_t bins = histogram.counts.size();
  const auto filled = static_cast<std::size_t>(
      std::count_if(histogram.counts.begin(), histogram.counts.end(), [](std::uint64_t n) { return n > 0; }));
  classes = std::min(classes, filled);
  if (classes < 2) return {};
  const Sums sums(histogram);
  // best[k][to]: the greatest sum of gains of k classes over bins [0, to); from[k][to] where the last of them begins.
  std::vector<std::vector<double>> best(classes + 1, std::vector<double>(bins + 1, -1));
  std::vector<std::vector<std::size_t>> from(classes + 1, std::vector<std::size_t>(bins + 1, 0));
  for (std::size_t to = 0; to <= bins; ++to) best[1][to] = sums.gain(0, to);
  for (std::size_t k = 2; k <= classes; ++k) {
    for (std::size_t to = k; to <= bins; ++to) {
      for (std::size_t at = k - 1; at < to; ++at) {
        const double gain = best[k - 1][at] + sums.gain(at, to);
        if (gain <= best[k][to]) continue;
        best[k][to] = gain;
        from[k][to] = at;
      }
    }
  }
  std::vector<double> thresholds;
  for (std::size_t k = classes, to = bins; k >= 2; --k) {
    to = from[k][to];
    // Any value in a run of empty bins parts alike: the middle is the farthest from both.
    std::size_t first = to;
    while (first > 0 && histogram.counts[first - 1] == 0) --first;
    std::size_t last = to;
    while (last + 1 < bins && histogram.counts[last] == 0) ++last;
    thresholds.push_back((histogram.value(first) + histogram.value(last)) / 2);
  }
  std::reverse(thresholds.begin(), thresholds.end());
  return thresholds;
}

bool looks_like_labels(const Volume& volume) {
  std::set<float> seen;
  float last = 0;
  for (const float value : volume.values) {
    if (value == last && !seen.empty()) continue;
    last = value;
    if (value < 0 || value != std::floor(value)) return false;
    if (seen.insert(value).second && seen.size() > limits::few_labels) return false;
  }
  return seen.contains(0.0f) && seen.size() > 1;
}

std::vector<std::string> histogram_lines(const Histogram& histogram, const std::vector<double>& marks,
                                         std::size_t lines) {
  const std::size_t bins = histogram.counts.size(), together = (bins + lines - 1) / lines;
  std::vector<std::uint64_t> sums;
  for (std::size_t bin = 0; bin < bins; bin += together) {
    sums.push_back(0);
    for (std::size_t n = bin; n < std::min(bin + together, bins); ++n) sums.back() += histogram.counts[n];
  }
  const double most = static_cast<double>(*std::max_element(sums.begin(), sums.end()));
  std::vector<std::string> result;
  for (std::size_t line = 0; line < sums.size(); ++line) {
    const double from = histogram.value(line * together), to = histogram.value((line + 1) * together);
    std::string marked;
    for (const double mark : marks)
      if (mark >= from && mark < to) marked += fmt::format("  < {:.4g}", mark);
    // By the root: the air around a tooth would make every other bar vanish.
    result.push_back(
        fmt::format("{:>10.4g} |{:<50}|{}", from, bar(std::sqrt(static_cast<double>(sums[line]) / most)), marked));
  }
  return result;
}

}  // namespace odontoscope
