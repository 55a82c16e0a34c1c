#include "recon/volume/small_contours.h"

#include <algorithm>
#include <limits>

#include "recon/core/limits.h"
#include "recon/core/polygon.h"

namespace odontoscope {
namespace {

struct Box {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

/// A contour of one structure, whoever holds its points.
struct Outline {
  const std::vector<Point2>* points = nullptr;
  Box box;
  bool is_hole = false, is_dropped = false;
};

Box box_of(const std::vector<Point2>& points) {
  Box box;
  for (const Point2& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool near(const Box& a, const Box& b, Point2 reach) {
  return a.low.x < b.high.x + reach.x && b.low.x < a.high.x + reach.x && a.low.y < b.high.y + reach.y &&
         b.low.y < a.high.y + reach.y;
}

/// Of one kind, with a corner of one inside the other: what only crosses with all corners outside is thinner than a
/// contour of pixels gets.
bool overlap(const Outline& a, const Outline& b) {
  if (a.is_hole != b.is_hole || !near(a.box, b.box, {0, 0})) return false;
  const auto any_in = [](const Outline& these, const Outline& that) {
    return std::any_of(these.points->begin(), these.points->end(),
                       [&](const Point2& p) { return encloses(*that.points, p); });
  };
  return any_in(a, b) || any_in(b, a);
}

std::vector<Outline> outlines_of(const TracedLevels& slice, const std::string& structure,
                                 std::optional<std::size_t> level) {
  std::vector<Outline> result;
  for (const Contour& contour : *slice.kept) {
    if (contour.structure == structure)
      result.push_back({&contour.points, box_of(contour.points), signed_area(contour.points) < 0, false});
  }
  if (!level) return result;
  for (const DroppedContour& dropped : *slice.dropped) {
    if (dropped.level == *level) result.push_back({&dropped.points, box_of(dropped.points), dropped.is_hole, true});
  }
  return result;
}

struct Run {
  std::size_t length = 1, first_slice = 0;
  Point2 at;
};

Point2 middle(const Box& box) { return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2}; }

/// Runs that end in each outline of a slice, from those that end in the slice before. Marks in `goes_on` what overlaps.
std::vector<Run> runs_in(std::size_t k, const std::vector<Outline>& here, const std::vector<Outline>& before,
                         const std::vector<Run>& runs_before, std::vector<bool>& goes_on,
                         std::vector<bool>& before_goes_on) {
  std::vector<Run> runs;
  for (std::size_t n = 0; n < here.size(); ++n) {
    Run run{1, k, middle(here[n].box)};
    for (std::size_t m = 0; m < before.size(); ++m) {
      if (!(here[n].is_dropped || before[m].is_dropped) || !overlap(here[n], before[m])) continue;
      goes_on[n] = before_goes_on[m] = true;
      if (here[n].is_dropped && before[m].is_dropped && runs_before[m].length + 1 > run.length)
        run = {runs_before[m].length + 1, runs_before[m].first_slice, runs_before[m].at};
    }
    runs.push_back(run);
  }
  return runs;
}

std::size_t dropped_that_go_on(const std::vector<Outline>& outlines, const std::vector<bool>& goes_on) {
  std::size_t count = 0;
  for (std::size_t n = 0; n < outlines.size(); ++n) count += outlines[n].is_dropped && goes_on[n] ? 1 : 0;
  return count;
}

}  // namespace

void find_runs(const std::vector<TracedLevels>& slices, std::size_t level, const std::string& structure,
               DroppedCounts& counts) {
  if (!counts.looked_at) return;
  std::vector<Outline> before;
  std::vector<Run> runs_before;
  std::vector<bool> before_goes_on;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    std::vector<Outline> here = outlines_of(slices[k], structure, level);
    if (here.size() * before.size() > limits::small_contour_pairs) {
      counts.looked_at = false;
      return;
    }
    std::vector<bool> goes_on(here.size(), false);
    std::vector<Run> runs = runs_in(k, here, before, runs_before, goes_on, before_goes_on);
    counts.going_on += dropped_that_go_on(before, before_goes_on);
    for (std::size_t n = 0; n < here.size(); ++n) {
      if (!here[n].is_dropped || runs[n].length <= counts.longest_run) continue;
      counts.longest_run = runs[n].length;
      counts.run_slice = runs[n].first_slice;
      counts.run_at = runs[n].at;
    }
    before = std::move(here);
    runs_before = std::move(runs);
    before_goes_on = std::move(goes_on);
  }
  counts.going_on += dropped_that_go_on(before, before_goes_on);
}

std::size_t count_pieces(const std::vector<TracedLevels>& slices, const std::string& structure, Point2 reach) {
  std::vector<std::vector<Outline>> outlines;
  for (const TracedLevels& slice : slices) outlines.push_back(outlines_of(slice, structure, std::nullopt));
  std::vector<std::vector<bool>> lonely;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    lonely.emplace_back(outlines[k].size(), true);
    for (const std::size_t other : {k - 1, k + 1}) {
      if (other >= outlines.size()) continue;  // k - 1 of the first wraps round
      if (outlines[k].size() * outlines[other].size() > limits::small_contour_pairs) return 0;
      for (std::size_t n = 0; n < outlines[k].size(); ++n) {
        lonely[k][n] = lonely[k][n] && std::none_of(outlines[other].begin(), outlines[other].end(),
                                                    [&](const Outline& o) { return overlap(outlines[k][n], o); });
      }
    }
  }
  std::size_t pieces = 0;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    for (std::size_t n = 0; n < outlines[k].size(); ++n) {
      bool touches = false;
      for (const std::size_t other : {k - 1, k + 1}) {
        if (!lonely[k][n] || other >= outlines.size()) continue;
        for (std::size_t m = 0; m < outlines[other].size(); ++m) {
          const Outline& o = outlines[other][m];
          touches = touches ||
                    (lonely[other][m] && o.is_hole == outlines[k][n].is_hole && near(outlines[k][n].box, o.box, reach));
        }
      }
      pieces += touches ? 1 : 0;
    }
  }
  return pieces;
}

}  // namespace odontoscope
