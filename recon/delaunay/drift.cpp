#include "recon/delaunay/drift.h"

#include <algorithm>
#include <limits>

#include "recon/core/portable_math.h"

namespace odontoscope::delaunay {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();

double distance(const TrackedShape& a, const TrackedShape& b) {
  return portable::hypot(a.centroid.x - b.centroid.x, a.centroid.y - b.centroid.y);
}

/// A part of a line: what it is worth, and what its triple next to the link is.
struct Evidence {
  double line = impossible, own = 0;
};

/// The best part of a line that goes on from a link on one side: begun anywhere, or hanging on a link that is made.
struct OneSide {
  Evidence loose{0, 0}, held;
};

void improve(Evidence& best, double triple, double further) {
  if (triple + further < best.line) best = {triple + further, triple};
}

class DriftSearch {
 public:
  DriftSearch(const ShapeGraph& graph, const std::vector<ShapePairs>& apart) : graph_(graph) {
    for (std::size_t slab = 0; slab < graph.slabs(); ++slab) collect(slab, apart[slab]);
    index();
  }

  std::vector<DriftCandidate> run() {
    std::vector<OneSide> up(found_.size()), down(found_.size());
    for (std::size_t i = found_.size(); i-- > 0;) up[i] = upwards(found_[i], up);
    for (std::size_t i = 0; i < found_.size(); ++i) down[i] = downwards(found_[i], down);
    const double starts = portable::log(static_cast<double>(std::max<std::size_t>(found_.size(), 1)));
    for (std::size_t i = 0; i < found_.size(); ++i) {
      Evidence best;
      const auto consider = [&best](double begun, const Evidence& a, const Evidence& b) {
        if (begun + a.line + b.line < best.line) best = {begun + a.line + b.line, a.own + b.own};
      };
      consider(starts, down[i].loose, up[i].loose);
      consider(0, down[i].held, up[i].loose);
      consider(0, down[i].loose, up[i].held);
      consider(0, down[i].held, up[i].held);
      found_[i].line = best.line;
      found_[i].own = best.own;
    }
    return std::move(found_);
  }

 private:
  /// Pairs of free ends of one slab.
  void collect(std::size_t slab, const ShapePairs& apart) {
    const std::vector<std::uint32_t> lower = ends(slab, true), upper = ends(slab + 1, false);
    const double height = graph_.height(slab);
    double largest = 0;
    for (const std::uint32_t b : upper) largest = std::max(largest, graph_.shape(slab + 1, b).radius);
    std::vector<DriftCandidate> pairs;
    for (const std::uint32_t a : lower) {
      const TrackedShape& shape = graph_.shape(slab, a);
      const double far = limits::track_reach_sizes * (shape.radius + largest) + limits::track_reach_slope * height;
      const auto first =
          std::lower_bound(upper.begin(), upper.end(), shape.centroid.x - far,
                           [&](std::uint32_t b, double x) { return graph_.shape(slab + 1, b).centroid.x < x; });
      for (auto b = first; b != upper.end() && graph_.shape(slab + 1, *b).centroid.x <= shape.centroid.x + far; ++b) {
        const TrackedShape& other = graph_.shape(slab + 1, *b);
        if (!ShapeGraph::like(shape, other) || distance(shape, other) > ShapeGraph::reach(shape, other, height))
          continue;
        if (std::find(apart.begin(), apart.end(), std::pair{a, *b}) == apart.end())
          pairs.push_back({slab, a, *b, 0, 0});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const DriftCandidate& p, const DriftCandidate& q) {
      return std::pair(p.lower, p.upper) < std::pair(q.lower, q.upper);
    });
    keep_clear(pairs, slab);
  }

  /// Free ends of slice k, by x.
  std::vector<std::uint32_t> ends(std::size_t k, bool above) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
      if (above ? graph_.free_above(k, i) : graph_.free_below(k, i)) found.push_back(i);
    std::stable_sort(found.begin(), found.end(), [&](std::uint32_t i, std::uint32_t j) {
      return graph_.shape(k, i).centroid.x < graph_.shape(k, j).centroid.x;
    });
    return found;
  }

  void keep_clear(const std::vector<DriftCandidate>& pairs, std::size_t slab) {
    std::vector<std::size_t> of_lower(graph_.slices()[slab].shapes.size(), 0),
        of_upper(graph_.slices()[slab + 1].shapes.size(), 0);
    for (const DriftCandidate& pair : pairs) {
      ++of_lower[pair.lower];
      ++of_upper[pair.upper];
    }
    for (const DriftCandidate& pair : pairs)
      if (std::max(of_lower[pair.lower], of_upper[pair.upper]) <= limits::track_candidates) found_.push_back(pair);
  }

  void index() {
    const auto& slices = graph_.slices();
    above_.resize(slices.size());
    below_.resize(slices.size());
    for (std::size_t k = 0; k < slices.size(); ++k) {
      above_[k].resize(slices[k].shapes.size());
      below_[k].resize(slices[k].shapes.size());
    }
    for (std::size_t i = 0; i < found_.size(); ++i) {
      above_[found_[i].slab][found_[i].lower].push_back(i);
      below_[found_[i].slab + 1][found_[i].upper].push_back(i);
    }
  }

  /// Logarithm of the chance that a, b, c in slices k-1, k, k+1 lie so well on a line.
  double triple(std::size_t k, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const TrackedShape &p = graph_.shape(k - 1, a), &q = graph_.shape(k, b), &r = graph_.shape(k + 1, c);
    const double h = graph_.height(k - 1), g = graph_.height(k);
    const double x = (r.centroid.x - q.centroid.x) / g - (q.centroid.x - p.centroid.x) / h;
    const double y = (r.centroid.y - q.centroid.y) / g - (q.centroid.y - p.centroid.y) / h;
    const double size = (r.radius - q.radius) / g - (q.radius - p.radius) / h;
    const double miss = portable::hypot(x, y, size) * (h + g) / 2;
    const double reach = (ShapeGraph::reach(p, q, h) + ShapeGraph::reach(q, r, g)) / 2;
    if (miss > limits::track_bend * reach) return impossible;
    const double share = std::max(miss / reach, limits::track_precision);
    const std::size_t rivals = std::max({above_[k][b].size(), below_[k][b].size(), std::size_t{1}});
    return portable::log(std::min(1.0, static_cast<double>(rivals) * share * share));
  }

  OneSide upwards(const DriftCandidate& link, const std::vector<OneSide>& up) const {
    OneSide best;
    const std::size_t k = link.slab + 1;
    for (const std::size_t next : above_[k][link.upper]) {
      const double worth = triple(k, link.lower, link.upper, found_[next].upper);
      improve(best.loose, worth, up[next].loose.line);
      improve(best.held, worth, up[next].held.line);
    }
    if (const auto made = graph_.same_above(k, link.upper))
      improve(best.held, triple(k, link.lower, link.upper, *made), 0);
    return best;
  }

  OneSide downwards(const DriftCandidate& link, const std::vector<OneSide>& down) const {
    OneSide best;
    const std::size_t k = link.slab;
    for (const std::size_t next : below_[k][link.lower]) {
      const double worth = triple(k, found_[next].lower, link.lower, link.upper);
      improve(best.loose, worth, down[next].loose.line);
      improve(best.held, worth, down[next].held.line);
    }
    if (const auto made = graph_.same_below(k, link.lower))
      improve(best.held, triple(k, *made, link.lower, link.upper), 0);
    return best;
  }

  const ShapeGraph& graph_;
  std::vector<DriftCandidate> found_;
  std::vector<std::vector<std::vector<std::size_t>>> above_, below_;  // of slice, of shape: candidates
};

}  // namespace

std::vector<DriftCandidate> drift_candidates(const ShapeGraph& graph, const std::vector<ShapePairs>& apart) {
  return DriftSearch(graph, apart).run();
}

}  // namespace odontoscope::delaunay
