#include "recon/compare/contour_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/surface_tree.h"

namespace odontoscope {
namespace {

double length(const Point2& a, const Point2& b) { return portable::hypot(b.x - a.x, b.y - a.y); }

template <class Visit>
void for_each_edge(const Slice& slice, const std::string& structure, Visit visit) {
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      visit(contour.points[i], contour.points[(i + 1) % contour.points.size()]);
    }
  }
}

/// Places at equal steps of accumulated length, in the order of what is walked.
class Walker {
 public:
  explicit Walker(double step) : step_(step) {}
  template <class Visit>
  void walk(const Point2& a, const Point2& b, Visit visit) {
    const double here = length(a, b);  // an endless step (no samples) visits nothing
    for (; next_ < passed_ + here; next_ += step_) {
      const double share = std::clamp((next_ - passed_) / here, 0.0, 1.0);
      visit(Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
    passed_ += here;
  }

 private:
  double step_, passed_ = 0, next_ = step_ / 2;
};

// --- distances -------------------------------------------------------------------------------------------------------

std::vector<Point3> places_on_contours(const ContourStack& stack, const std::string& structure, std::size_t samples) {
  std::vector<Point3> places;
  const double whole = contour_length(stack, structure);
  if (!(whole > 0)) return places;
  Walker walker(whole / static_cast<double>(samples));
  for (const Slice& slice : stack.slices) {
    for_each_edge(slice, structure, [&](const Point2& a, const Point2& b) {
      places.push_back({a.x, a.y, slice.z});  // corners too: extremes are found there
      walker.walk(a, b, [&](const Point2& p) { places.push_back({p.x, p.y, slice.z}); });
    });
  }
  return places;
}

struct SliceMeasure {
  double largest = 0, sum = 0;
  std::size_t count = 0;
};

template <class Visit>
void for_each_segment(const PlaneSection& section, Visit visit) {
  for (const auto* side : {&section.below, &section.above}) std::for_each(side->begin(), side->end(), visit);
}

/// From the ends of the segments and places along them to the slice's contours.
SliceMeasure measure_section(const PlaneSection& section, const Slice& slice, const std::string& structure,
                             double step) {
  SliceMeasure measure;
  std::vector<Corners> edges;
  for_each_edge(slice, structure, [&](const Point2& a, const Point2& b) {
    edges.push_back({Point3{a.x, a.y, 0}, Point3{b.x, b.y, 0}, Point3{b.x, b.y, 0}});
  });
  if (edges.empty()) return measure;
  const SurfaceTree tree(edges);
  const auto distance = [&](const Point2& p) { return std::sqrt(tree.nearest({p.x, p.y, 0}).square); };
  Walker walker(step);
  for_each_segment(section, [&](const SectionSegment& s) {
    measure.largest = std::max({measure.largest, distance(s.from), distance(s.to)});
    walker.walk(s.from, s.to, [&](const Point2& p) {
      const double d = distance(p);
      measure.largest = std::max(measure.largest, d);
      measure.sum += d;
      ++measure.count;
    });
  });
  return measure;
}

// --- passages --------------------------------------------------------------------------------------------------------

/// Square cells, those that may hold a larger circle first.
struct Cell {
  Point2 middle;
  double half, clearance;  // clearance of the middle, negative outside
  double best() const { return clearance + half * std::numbers::sqrt2; }
  friend bool operator<(const Cell& a, const Cell& b) { return a.best() < b.best(); }
};

/// Largest circle within `outer` and outside all of `within`: cells are quartered, the most promising first, until none
/// can be better by more than a hundredth of the contour's size.
ContourPassage widest_place(const std::vector<Point2>& outer, const std::vector<const std::vector<Point2>*>& within) {
  const auto clearance = [&](const Point2& p) {
    double least = distance_to_border(p, outer);
    bool counts = encloses(outer, p);
    for (const auto* ring : within) {
      least = std::min(least, distance_to_border(p, *ring));
      counts = counts && !encloses(*ring, p);
    }
    return counts ? least : -least;
  };
  const auto [left, right] =
      std::minmax_element(outer.begin(), outer.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(outer.begin(), outer.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const double size = std::max(right->x - left->x, high->y - low->y);
  const Point2 middle{(left->x + right->x) / 2, (low->y + high->y) / 2};
  std::priority_queue<Cell> cells;
  cells.push({middle, size / 2, clearance(middle)});
  Cell best = cells.top();
  constexpr double precision = 0.005;         // of a radius, over the size
  constexpr std::size_t most_cells = 20'000;  // rings as thin as a hair stay unresolved
  for (std::size_t seen = 0; !cells.empty() && seen < most_cells; ++seen) {
    const Cell cell = cells.top();
    cells.pop();
    if (cell.clearance > best.clearance) best = cell;
    if (cell.best() - best.clearance <= precision * size && best.clearance > 0) break;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const Point2 p{cell.middle.x + x * cell.half, cell.middle.y + y * cell.half};
        cells.push({p, cell.half / 2, clearance(p)});
      }
    }
  }
  ContourPassage passage;
  passage.middle = best.middle;
  passage.width = 2 * std::max(best.clearance, 0.0);
  return passage;
}

void count(PassageCounts& counts, double width, bool kept) {
  ++counts.all;
  counts.lost += !kept;
  if (!kept) counts.widest_lost = std::max(counts.widest_lost, width);
  if (kept) counts.thinnest_kept = counts.thinnest_kept > 0 ? std::min(counts.thinnest_kept, width) : width;
}

PassageCounts sum(const PassageCounts& a, const PassageCounts& b) {
  PassageCounts all{a.all + b.all, a.lost + b.lost, std::max(a.thinnest_kept, b.thinnest_kept),
                    std::max(a.widest_lost, b.widest_lost)};
  if (a.thinnest_kept > 0 && b.thinnest_kept > 0) all.thinnest_kept = std::min(a.thinnest_kept, b.thinnest_kept);
  return all;
}

}  // namespace

double contour_length(const ContourStack& stack, const std::string& structure) {
  double whole = 0;
  for (const Slice& slice : stack.slices) {
    for_each_edge(slice, structure, [&](const Point2& a, const Point2& b) { whole += length(a, b); });
  }
  return whole;
}

std::vector<ContourPassage> passages(const ContourStack& ordered_stack, const std::string& structure) {
  std::vector<std::vector<ContourPassage>> by_slice(ordered_stack.slices.size());
  tbb::parallel_for(std::size_t{0}, by_slice.size(), [&](std::size_t k) {
    const auto& contours = ordered_stack.slices[k].contours;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      if (contours[c].structure != structure) continue;
      std::vector<const std::vector<Point2>*> within;
      for (std::size_t other = 0; other < contours.size(); ++other) {
        if (other == c || contours[other].structure != structure) continue;
        if (encloses(contours[c].points, contours[other].points[0])) within.push_back(&contours[other].points);
      }
      ContourPassage passage = widest_place(contours[c].points, within);
      passage.slice = k;
      passage.contour = c;
      passage.hole = signed_area(contours[c].points) < 0;
      by_slice[k].push_back(passage);
    }
  });
  std::vector<ContourPassage> all;
  for (const auto& slice : by_slice) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

ContourFit contour_fit(const ContourStack& ordered_stack, const std::string& structure, const SurfaceMesh& surface,
                       const DistanceOptions& options, const Progress& progress) {
  ContourFit fit;
  std::vector<double> heights;
  for (const Slice& slice : ordered_stack.slices) heights.push_back(slice.z);
  const auto cuts = sections(surface, heights);
  progress.check();
  for (const ContourPassage& passage : passages(ordered_stack, structure)) {
    const bool kept = is_material(cuts[passage.slice], passage.middle) != passage.hole;
    count(passage.hole ? fit.holes : fit.solids, passage.width, kept);
  }
  progress.check();
  if (const auto distance =
          distance_to_surface(places_on_contours(ordered_stack, structure, options.samples), surface, progress)) {
    fit.contours_to_surface = *distance;
  }
  double whole = 0;
  std::vector<PlaneSection> outlines(cuts.size());
  tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t k) { outlines[k] = outline(cuts[k]); });
  progress.check();
  for (const PlaneSection& section : outlines) {
    for_each_segment(section, [&whole](const SectionSegment& s) { whole += length(s.from, s.to); });
  }
  std::vector<SliceMeasure> measures(cuts.size());
  tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t k) {
    if (progress.stop.stop_requested()) return;
    measures[k] =
        measure_section(outlines[k], ordered_stack.slices[k], structure, whole / static_cast<double>(options.samples));
  });
  progress.check();
  SliceMeasure all;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    if (measures[k].largest > all.largest) fit.worst_slice = k;
    all = {std::max(all.largest, measures[k].largest), all.sum + measures[k].sum, all.count + measures[k].count};
  }
  fit.section_to_contours = {all.largest, all.count > 0 ? all.sum / static_cast<double>(all.count) : 0};
  return fit;
}

ContourFit joined(const std::vector<WeightedFit>& fits) {
  ContourFit all;
  double weight = 0;
  for (const WeightedFit& one : fits) {
    const auto join = [&](OneWayDistance& whole, const OneWayDistance& part) {
      whole.largest = std::max(whole.largest, part.largest);
      whole.mean += one.weight * part.mean;
    };
    if (one.fit.section_to_contours.largest > all.section_to_contours.largest) all.worst_slice = one.fit.worst_slice;
    join(all.contours_to_surface, one.fit.contours_to_surface);
    join(all.section_to_contours, one.fit.section_to_contours);
    all.holes = sum(all.holes, one.fit.holes);
    all.solids = sum(all.solids, one.fit.solids);
    weight += one.weight;
  }
  if (weight > 0) {
    all.contours_to_surface.mean /= weight;
    all.section_to_contours.mean /= weight;
  }
  return all;
}

}  // namespace odontoscope
