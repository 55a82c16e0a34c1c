#include "recon/volume/contour_levels.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <set>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/polygon.h"
#include "recon/volume/lattice.h"

namespace odontoscope {
namespace {

void check_options(const std::vector<LevelTracer>& tracers, const TraceOptions& options) {
  if (!(options.min_area >= 0) || !std::isfinite(options.min_area)) {
    throw UsageError(fmt::format("the smallest area {} is not a finite number of at least 0", options.min_area),
                     "give an area in square millimetres (--min-area A)");
  }
  if (tracers.empty()) {
    throw UsageError("no level is given to take contours at", "give --iso T[=NAME] or --label N[=NAME]");
  }
  std::set<std::string> names;
  for (const LevelTracer& tracer : tracers) {
    if (!names.insert(tracer.structure).second) {
      throw UsageError(fmt::format("two levels are both named \"{}\"", tracer.structure),
                       "give each its own name, as in --iso 120=dentine --iso 195=enamel");
    }
  }
}

void count(const DroppedContour& dropped, DroppedCounts& counts) {
  ++(dropped.is_hole ? counts.holes : counts.islands);
  counts.largest_area = std::max(counts.largest_area, dropped.area);
  counts.looked_at = counts.looked_at && !dropped.points.empty();
}

struct TracedSlice {
  std::vector<Contour> contours;
  std::vector<DroppedContour> dropped;
  std::vector<LevelReport> levels;
  bool too_many = false;
};

/// Counts points over all slices and says when to give up, so that memory stays bounded on noise.
class PointBudget {
 public:
  bool take(std::size_t points) { return used_.fetch_add(points) + points <= limits::points; }
  /// May one more contour be kept that is dropped, to be looked at?
  bool keep_dropped() { return dropped_.fetch_add(1) < limits::dropped_contours; }
  bool exceeded() const { return used_.load() > limits::points; }

 private:
  std::atomic<std::size_t> used_{0}, dropped_{0};
};

TracedSlice trace_slice(std::size_t k, const std::vector<LevelTracer>& tracers, const TraceOptions& options,
                        PointBudget& budget) {
  TracedSlice result;
  for (std::size_t level = 0; level < tracers.size(); ++level) {
    const LevelTracer& tracer = tracers[level];
    LevelReport report;
    report.structure = tracer.structure;
    tracer.trace(k, [&](std::vector<Point2>&& points) {
      const double area = signed_area(points);
      if (std::abs(area) < options.min_area) {
        ++report.dropped;
        // Of noise so much is dropped that only its number is kept.
        DroppedContour dropped{level, std::abs(area), area < 0, {}};
        if (budget.keep_dropped()) dropped.points = std::move(points);
        count(dropped, report.small);
        if (!dropped.points.empty()) result.dropped.push_back(std::move(dropped));
        return true;
      }
      if (!budget.take(points.size())) return false;
      if (result.contours.size() == limits::contours_per_slice) {
        result.too_many = true;
        return false;
      }
      ++report.contours;
      report.points += points.size();
      result.contours.push_back({tracer.structure, std::move(points)});
      return true;
    });
    result.levels.push_back(std::move(report));
  }
  return result;
}

double height(const Volume& volume, std::size_t k) { return Lattice(volume).z(k); }

void check_counts(const Volume& volume, const std::vector<TracedSlice>& slices, const PointBudget& budget) {
  Place place;
  place.file = volume.source;
  if (budget.exceeded()) {
    throw InputError("too-many-points", place, fmt::format("the contours have more than {} points", limits::points),
                     "crop the volume, smooth it, or drop small contours (--min-area A)");
  }
  for (std::size_t k = 0; k < slices.size(); ++k) {
    if (!slices[k].too_many) continue;
    place.slice = k;
    place.z = height(volume, k);
    throw InputError("too-many-contours", place,
                     fmt::format("the slice has more than {} contours", limits::contours_per_slice),
                     "smooth the volume, choose another iso value, or drop small contours (--min-area A)");
  }
}

std::vector<LevelReport> summed(const std::vector<LevelTracer>& tracers, const std::vector<TracedSlice>& slices) {
  std::vector<LevelReport> levels;
  for (std::size_t n = 0; n < tracers.size(); ++n) {
    LevelReport level;
    level.structure = tracers[n].structure;
    for (const TracedSlice& slice : slices) {
      level.contours += slice.levels[n].contours;
      level.points += slice.levels[n].points;
      level.dropped += slice.levels[n].dropped;
      level.small.holes += slice.levels[n].small.holes;
      level.small.islands += slice.levels[n].small.islands;
      level.small.largest_area = std::max(level.small.largest_area, slice.levels[n].small.largest_area);
      level.small.looked_at = level.small.looked_at && slice.levels[n].small.looked_at;
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

void look_at_small(const Volume& volume, const std::vector<TracedSlice>& slices, std::vector<LevelReport>& levels) {
  std::vector<TracedLevels> traced;
  for (const TracedSlice& slice : slices) traced.push_back({&slice.contours, &slice.dropped});
  for (std::size_t n = 0; n < levels.size(); ++n) {
    if (levels[n].dropped > 0) find_runs(traced, n, levels[n].structure, levels[n].small);
    levels[n].pieces = count_pieces(traced, levels[n].structure, {volume.spacing[0], volume.spacing[1]});
  }
}

void check_levels(const Volume& volume, const std::vector<LevelTracer>& tracers, const std::vector<LevelReport>& levels,
                  const TraceOptions& options) {
  for (std::size_t n = 0; n < levels.size(); ++n) {
    if (levels[n].contours > 0) continue;
    Place place;
    place.file = volume.source;
    throw InputError("min-area-drops-all", place,
                     fmt::format("all {} contours of {} enclose less than {} mm^2", levels[n].dropped,
                                 tracers[n].in_words, options.min_area),
                     "give a smaller --min-area");
  }
}

ContourStack stacked(const Volume& volume, std::vector<TracedSlice>& slices) {
  std::size_t first = 0;
  while (slices[first].contours.empty()) ++first;
  std::size_t last = slices.size() - 1;
  while (slices[last].contours.empty()) --last;
  if (first == last) {
    Place place;
    place.file = volume.source;
    place.slice = first;
    place.z = height(volume, first);
    throw InputError("single-slice", place, "all contours lie in this one slice",
                     "choose a level that two slices reach");
  }
  ContourStack stack;
  stack.source = volume.source;
  for (std::size_t k = first; k <= last; ++k)
    stack.slices.push_back({height(volume, k), std::move(slices[k].contours)});
  return stack;
}

}  // namespace

TracedContours trace_levels(const Volume& volume, const std::vector<LevelTracer>& tracers, const TraceOptions& options,
                            const Progress& progress) {
  check_options(tracers, options);
  std::vector<TracedSlice> slices(volume.size[2]);
  PointBudget budget;
  std::mutex telling;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, slices.size(), [&](std::size_t k) {
    progress.check();
    if (budget.exceeded()) return;
    slices[k] = trace_slice(k, tracers, options, budget);
    const std::scoped_lock lock(telling);
    progress.tell("contours", static_cast<double>(++done) / static_cast<double>(slices.size()));
  });
  check_counts(volume, slices, budget);
  TracedContours result;
  result.levels = summed(tracers, slices);
  check_levels(volume, tracers, result.levels, options);
  look_at_small(volume, slices, result.levels);
  result.stack = stacked(volume, slices);
  return result;
}

}  // namespace odontoscope
