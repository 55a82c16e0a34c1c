#include "recon/delaunay/track.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"
#include "recon/delaunay/bits.h"

namespace odontoscope::delaunay {
namespace {

const double believed = portable::log(limits::track_chance),
             clear_of_chance = portable::log(limits::track_chance_clear),
             worth_asking = portable::log(limits::track_chance_doubtful);

/// A free end with a shape beyond it: `share` of area speaks for the link.
struct Proposal {
  std::size_t slab = 0;
  std::uint32_t lower = 0, upper = 0;
  double share = 0;
  bool from_lower = true, from_upper = false;  // which of the two hangs free and asks for it
};

class Tracker {
 public:
  Tracker(const std::vector<ShapeSlice>& slices, const std::vector<KnownLinks>& slabs)
      : slabs_(slabs), graph_(slices), joined_(number_shapes(slices)) {
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      apart_.push_back(slabs[k].apart);
      for (const RegionLink& link : slabs[k].made) graph_.add(k, link.lower, link.upper);
    }
    result_.links.resize(slabs.size());
    result_.closed.resize(slabs.size());
  }

  Tracking run() {
    follow_drift();
    link_entries();
    link_overlaps();
    link_entries();
    link_bits();
    link_outlets();
    link_lobes();
    ask_about_free_ends();
    ask_about_openings();
    for (auto& links : result_.links)
      std::sort(links.begin(), links.end(), [](const TrackedLink& a, const TrackedLink& b) {
        return std::pair(a.lower, a.upper) < std::pair(b.lower, b.upper);
      });
    for (const auto& [pair, doubtful] : doubts_) result_.doubtful.push_back(doubtful);
    return std::move(result_);
  }

 private:
  std::size_t number_shapes(const std::vector<ShapeSlice>& slices) {
    std::size_t count = 0;
    for (const ShapeSlice& slice : slices) {
      first_shape_.push_back(count);
      count += slice.shapes.size();
    }
    return count;
  }

  // --- links and doubts ----------------------------------------------------------------------------------------------

  /// False, and a doubt, where the link would close a loop of tracked links.
  bool make(std::size_t slab, std::uint32_t lower, std::uint32_t upper, TrackedBy by, bool clear) {
    const auto a = static_cast<std::uint32_t>(first_shape_[slab] + lower),
               b = static_cast<std::uint32_t>(first_shape_[slab + 1] + upper);
    if (joined_.find(a) == joined_.find(b)) {
      doubt(Choice::may_connect, by, slab, lower, upper);
      return false;
    }
    joined_.join(a, b);
    graph_.add(slab, lower, upper);
    result_.links[slab].push_back({lower, upper, by});
    doubts_.erase({slab, lower, upper});
    if (!clear) doubt(Choice::may_part, by, slab, lower, upper);
    return true;
  }

  void doubt(Choice choice, TrackedBy by, std::size_t slab, std::uint32_t lower, std::uint32_t upper) {
    if (choice == Choice::may_connect && is_linked(slab, lower, upper)) return;
    const TrackedShape &a = graph_.shape(slab, lower), &b = graph_.shape(slab + 1, upper);
    const Point2 p = a.unbounded ? b.centroid : a.centroid, q = b.unbounded ? a.centroid : b.centroid;
    const double z = (graph_.slices()[slab].z + graph_.slices()[slab + 1].z) / 2;
    doubts_.insert({{slab, lower, upper},
                    {choice, by, slab, lower, upper, a.contour, b.contour, {(p.x + q.x) / 2, (p.y + q.y) / 2, z}}});
  }

  bool is_linked(std::size_t slab, std::uint32_t lower, std::uint32_t upper) const {
    const auto& above = graph_.above(slab, lower);
    return std::find(above.begin(), above.end(), upper) != above.end();
  }

  bool is_apart(std::size_t slab, std::uint32_t lower, std::uint32_t upper) const {
    return std::find(apart_[slab].begin(), apart_[slab].end(), std::pair{lower, upper}) != apart_[slab].end();
  }

  // --- drift ---------------------------------------------------------------------------------------------------------

  void follow_drift() {
    for (int round = 0; round < limits::track_rounds; ++round) {
      const std::vector<DriftCandidate> candidates = drift_candidates(graph_, apart_);
      if (!link_best(candidates)) return;
    }
  }

  /// Links pairs that are each other's best; what loses to them is asked about if it would be believed alone.
  bool link_best(const std::vector<DriftCandidate>& candidates) {
    std::map<std::pair<std::size_t, std::uint32_t>, double> best_above, best_below;
    const auto better = [](auto& best, std::pair<std::size_t, std::uint32_t> end, double line) {
      const auto [known, fresh] = best.insert({end, line});
      if (!fresh) known->second = std::min(known->second, line);
    };
    const auto holds = [](const DriftCandidate& c) { return c.line <= believed && c.own <= believed; };
    for (const DriftCandidate& c : candidates)
      if (holds(c)) {
        better(best_above, {c.slab, c.lower}, c.line);
        better(best_below, {c.slab + 1, c.upper}, c.line);
      }
    bool any = false;
    std::vector<const DriftCandidate*> lost;
    for (const DriftCandidate& c : candidates) {
      if (!holds(c)) continue;
      const bool best = c.line <= best_above.at({c.slab, c.lower}) && c.line <= best_below.at({c.slab + 1, c.upper});
      if (best && graph_.free_above(c.slab, c.lower) && graph_.free_below(c.slab + 1, c.upper))
        any |= make(c.slab, c.lower, c.upper, TrackedBy::drift, c.line <= clear_of_chance);
      else
        lost.push_back(&c);
    }
    for (const DriftCandidate* c : lost)
      if (!graph_.free_above(c->slab, c->lower) || !graph_.free_below(c->slab + 1, c->upper))
        doubt(Choice::may_connect, TrackedBy::drift, c->slab, c->lower, c->upper);
    return any;
  }

  // --- entry ---------------------------------------------------------------------------------------------------------

  /// The same thing in the slice before the end, seen from the end: below it if the end looks up.
  std::optional<std::uint32_t> before(std::size_t k, std::uint32_t i, bool up) const {
    return up ? graph_.same_below(k, i) : graph_.same_above(k, i);
  }

  /// Heights are taken along the direction in which the end looks.
  double height_before(std::size_t k, bool up) const { return graph_.height(up ? k - 1 : k); }

  /// Will the area be much smaller one slab on, if it goes on changing as it did?
  bool running_out(std::size_t k, std::uint32_t i, bool up) const {
    const auto last = before(k, i, up);
    return last && running_out(k, i, up, *last);
  }
  bool running_out(std::size_t k, std::uint32_t i, bool up, std::uint32_t last) const {
    const double area = graph_.shape(k, i).area, was = graph_.shape(up ? k - 1 : k + 1, last).area;
    const double then = area + (area - was) * graph_.height(up ? k : k - 1) / height_before(k, up);
    return then < limits::track_taper * area;
  }

  /// How far the end's drift takes it over the slab before it; measured over two slabs where it is the same thing so
  /// long.
  std::optional<Point2> drift(std::size_t k, std::uint32_t i, bool up) const {
    const auto last = before(k, i, up);
    if (!last) return std::nullopt;
    std::size_t slice = up ? k - 1 : k + 1;
    std::uint32_t shape = *last;
    double height = height_before(k, up);
    if (up ? slice > 0 : slice + 1 < graph_.slices().size())
      if (const auto first = before(slice, shape, up)) {
        height += height_before(slice, up);
        slice = up ? slice - 1 : slice + 1;
        shape = *first;
      }
    const Point2 from = graph_.shape(slice, shape).centroid, to = graph_.shape(k, i).centroid;
    const double share = graph_.height(up ? k : k - 1) / height;
    return Point2{(to.x - from.x) * share, (to.y - from.y) * share};
  }

  /// Adds the shapes beyond a free end into which its drift takes a part of it that is worth a question.
  void propose_entries(std::size_t k, std::uint32_t i, bool up, std::vector<Proposal>& proposals) const {
    if (!(up ? graph_.free_above(k, i) : graph_.free_below(k, i)) || running_out(k, i, up)) return;
    const std::optional<Point2> by = drift(k, i, up);
    const TrackedShape& shape = graph_.shape(k, i);
    const std::size_t slab = up ? k : k - 1, beyond = up ? k + 1 : k - 1;
    if (!by || portable::hypot(by->x, by->y) > ShapeGraph::reach(shape, shape, graph_.height(slab))) return;
    const double area = net_area(shape);
    for (std::uint32_t j = 0; j < graph_.slices()[beyond].shapes.size(); ++j) {
      const std::uint32_t lower = up ? i : j, upper = up ? j : i;
      if (is_apart(slab, lower, upper)) continue;
      const double share = overlap_area(shape, *by, graph_.shape(beyond, j)) / area;
      if (share >= limits::track_entry_doubtful) proposals.push_back({slab, lower, upper, share, up, !up});
    }
  }

  void link_entries() {
    std::vector<Proposal> proposals;
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
        for (const bool up : {true, false}) propose_entries(k, i, up, proposals);
    decide(proposals, limits::track_entry_doubtful, limits::track_entry_clear, TrackedBy::entry);
  }

  // --- overlap -------------------------------------------------------------------------------------------------------

  void link_overlaps() {
    std::vector<Proposal> proposals;
    for (std::size_t k = 0; k < slabs_.size(); ++k)
      for (const RegionLink& link : slabs_[k].overlapping) {
        const bool lower_free = graph_.free_above(k, link.lower), upper_free = graph_.free_below(k + 1, link.upper);
        if (is_linked(k, link.lower, link.upper) || is_apart(k, link.lower, link.upper)) continue;
        const double share = overlap_share(graph_.shape(k, link.lower), graph_.shape(k + 1, link.upper));
        // What is running out needs no partner; one that hangs free itself may be its other part.
        const bool asks_above = lower_free && (upper_free || !running_out(k, link.lower, true));
        const bool asks_below = upper_free && (lower_free || !running_out(k + 1, link.upper, false));
        if (asks_above || asks_below)
          proposals.push_back({k, link.lower, link.upper, share, asks_above, asks_below});
        else if (share >= limits::track_overlap && (lower_free || upper_free) &&
                 ShapeGraph::like(graph_.shape(k, link.lower), graph_.shape(k + 1, link.upper)))
          doubt(Choice::may_connect, TrackedBy::overlap, k, link.lower, link.upper);  // a canal that forks narrows too
        else if (share >= limits::track_overlap)
          dispute(k, link.lower, link.upper);
      }
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
        if (alone(k, i))
          for (const bool up : {true, false}) propose_overlaps(k, i, up, proposals);
    decide(proposals, limits::track_overlap, limits::track_overlap_clear, TrackedBy::overlap);
  }

  /// Linked with nothing on either side.
  bool alone(std::size_t k, std::uint32_t i) const {
    return !graph_.shape(k, i).unbounded && graph_.above(k, i).empty() && graph_.below(k, i).empty();
  }

  /// A sliver may lie over a region with no point of the Voronoi overlay in both.
  void propose_overlaps(std::size_t k, std::uint32_t i, bool up, std::vector<Proposal>& proposals) const {
    if (!(up ? graph_.free_above(k, i) : graph_.free_below(k, i))) return;
    const std::size_t slab = up ? k : k - 1, beyond = up ? k + 1 : k - 1;
    for (std::uint32_t j = 0; j < graph_.slices()[beyond].shapes.size(); ++j) {
      const std::uint32_t lower = up ? i : j, upper = up ? j : i;
      const auto& known = slabs_[slab].overlapping;
      const bool seen = std::any_of(known.begin(), known.end(),
                                    [&](const RegionLink& link) { return link.lower == lower && link.upper == upper; });
      if (seen || is_apart(slab, lower, upper) || graph_.shape(beyond, j).unbounded) continue;
      const double share = overlap_share(graph_.shape(k, i), graph_.shape(beyond, j));
      if (share >= limits::track_overlap) proposals.push_back({slab, lower, upper, share, up, !up});
    }
  }

  /// An overlap that was passed over for a tracked link on the same side.
  void dispute(std::size_t slab, std::uint32_t lower, std::uint32_t upper) {
    const auto& links = result_.links[slab];
    const bool tracked = std::any_of(links.begin(), links.end(), [&](const TrackedLink& link) {
      return link.lower == lower || link.upper == upper;
    });
    if (tracked) doubt(Choice::may_connect, TrackedBy::overlap, slab, lower, upper);
  }

  /// The largest share first. A link that an end, still free, asks for is made from `least` on; below it is asked
  /// about.
  void decide(std::vector<Proposal>& proposals, double least, double clear, TrackedBy by) {
    std::stable_sort(proposals.begin(), proposals.end(),
                     [](const Proposal& a, const Proposal& b) { return a.share > b.share; });
    for (const Proposal& p : proposals) {
      const bool asked = (p.from_lower && graph_.free_above(p.slab, p.lower)) ||
                         (p.from_upper && graph_.free_below(p.slab + 1, p.upper));
      if (is_linked(p.slab, p.lower, p.upper)) continue;
      if (asked && p.share >= (by == TrackedBy::entry && leaves(p) ? limits::track_entry : least))
        make(p.slab, p.lower, p.upper, by, p.share >= clear || nothing_else(p, proposals));
      else if (asked || p.share >= least)
        doubt(Choice::may_connect, by, p.slab, p.lower, p.upper);
    }
  }

  /// A way out is not believed as easily as a fork: most ends close.
  bool leaves(const Proposal& p) const {
    return graph_.shape(p.slab, p.lower).unbounded || graph_.shape(p.slab + 1, p.upper).unbounded;
  }

  /// Does what asks hang on nothing at all, and lie over nothing but this, which goes on? Then it is its end, as of
  /// enamel's margin, and no thing of a single slice: no real choice.
  bool nothing_else(const Proposal& p, const std::vector<Proposal>& proposals) const {
    const bool lower_asks = p.from_lower && alone(p.slab, p.lower),
               upper_asks = p.from_upper && alone(p.slab + 1, p.upper);
    if (lower_asks == upper_asks) return false;
    const std::size_t slice = lower_asks ? p.slab : p.slab + 1;
    const std::uint32_t shape = lower_asks ? p.lower : p.upper;
    return std::count_if(proposals.begin(), proposals.end(), [&](const Proposal& other) {
             return (other.slab == slice && other.lower == shape) || (other.slab + 1 == slice && other.upper == shape);
           }) == 1;
  }

  // ---- bits ---------------------------------------------------------------------------------------------------------

  void link_bits() {
    const auto ends_by_itself = [this](std::size_t k, std::uint32_t i, bool up) {
      const auto& inner = up ? graph_.below(k, i) : graph_.above(k, i);
      return inner.size() == 1 && running_out(k, i, up, inner.front());
    };
    const auto links = links_of_bits(graph_, apart_, ends_by_itself);
    std::vector<bool> clear;
    for (const BitLink& link : links)
      clear.push_back(outermost(link.slab, link.lower, true) || outermost(link.slab + 1, link.upper, false));
    for (std::size_t n = 0; n < links.size(); ++n)
      make(links[n].slab, links[n].lower, links[n].upper, TrackedBy::beside, clear[n]);
    link_entries();
  }

  /// A piece of the structure's first slice, or its last, that hangs on nothing else: all of that slice is an end, as
  /// enamel's margin, and the structure must begin with something. Of material only: a row of holes may begin with a
  /// pit.
  bool outermost(std::size_t k, std::uint32_t i, bool lowest) const {
    if (has_outside(k) || !alone(k, i)) return false;
    for (std::size_t other = lowest ? 0 : k + 1; other < (lowest ? k : graph_.slices().size()); ++other)
      if (!graph_.slices()[other].shapes.empty()) return false;
    return true;
  }

  /// Voids that end beside a notch of the next slice. Only what hangs on a tracked link: a horn near the surface is no
  /// canal.
  void link_outlets() {
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
        for (const bool up : {true, false}) {
          if (!(up ? graph_.free_above(k, i) : graph_.free_below(k, i)) || !hangs_on_tracked(k, i, up)) continue;
          const std::size_t beyond = up ? k + 1 : k - 1;
          if (has_outside(k) && has_outside(beyond) &&
              leaves_through(graph_.shape(k, i), graph_.shape(k, outside), graph_.shape(beyond, outside)))
            make(up ? k : k - 1, up ? i : outside, up ? outside : i, TrackedBy::beside, false);
        }
  }

  /// Canals that end or go on, and lie over a notch of the next slice: they leave there, or an accessory canal does, of
  /// which one slice shows the beginning as a lobe of the canal and the other the end as a notch.
  void link_lobes() {
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
        for (const bool up : {true, false}) {
          if (graph_.shape(k, i).unbounded || !(up ? k + 1 < graph_.slices().size() : k > 0)) continue;
          const std::size_t slab = up ? k : k - 1, beyond = up ? k + 1 : k - 1;
          const auto& links = up ? graph_.above(k, i) : graph_.below(k, i);
          const bool opens = std::any_of(links.begin(), links.end(),
                                         [&](std::uint32_t j) { return graph_.shape(beyond, j).unbounded; });
          if (opens || links.size() > 1 || !has_outside(k) || !has_outside(beyond)) continue;
          if (lies_over_notch(graph_.shape(k, i), graph_.shape(k, outside), graph_.shape(beyond, outside)))
            make(slab, up ? i : outside, up ? outside : i, TrackedBy::overlap, false);
          else if (all_but_reaches_notch(graph_.shape(k, i), graph_.shape(k, outside), graph_.shape(beyond, outside)))
            doubt(Choice::may_connect, TrackedBy::overlap, slab, up ? i : outside, up ? outside : i);
        }
  }

  bool has_outside(std::size_t k) const {
    return !graph_.slices()[k].shapes.empty() && graph_.shape(k, outside).unbounded;
  }

  /// Of voids that are running out: those that open into the outside in the next slice may close before, and do if
  /// their drift takes them away from it; those that end may open, if it takes them there.
  void ask_about_openings() {
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i)
        for (const bool up : {true, false}) {
          if (graph_.shape(k, i).unbounded || !(up ? k + 1 < graph_.slices().size() : k > 0)) continue;
          const std::size_t slab = up ? k : k - 1, beyond = up ? k + 1 : k - 1;
          if (!has_outside(beyond) || !running_out(k, i, up)) continue;
          const std::uint32_t lower = up ? i : outside, upper = up ? outside : i;
          const auto& links = up ? graph_.above(k, i) : graph_.below(k, i);
          const bool opens = links.size() == 1 && graph_.shape(beyond, links.front()).unbounded;
          const bool leaves = drifts_outside(k, i, up);
          if (opens && leaves) doubt(Choice::may_part, TrackedBy::overlap, slab, lower, upper);
          if (opens && !leaves) close(slab, lower, upper);
          if (links.empty() && leaves) doubt(Choice::may_connect, TrackedBy::entry, slab, lower, upper);
        }
  }

  /// Its middle, seen from above: it is running out. What has no drift stays where it is.
  bool drifts_outside(std::size_t k, std::uint32_t i, bool up) const {
    const Point2 by = drift(k, i, up).value_or(Point2{}), from = graph_.shape(k, i).centroid;
    const Point2 to{from.x + by.x, from.y + by.y};
    const auto& outlines = graph_.shape(up ? k + 1 : k - 1, outside).contours;
    return std::none_of(outlines.begin(), outlines.end(), [to](const auto& ring) { return encloses(ring, to); });
  }

  void close(std::size_t slab, std::uint32_t lower, std::uint32_t upper) {
    const auto& tracked = result_.links[slab];
    if (std::any_of(tracked.begin(), tracked.end(),
                    [&](const TrackedLink& link) { return link.lower == lower && link.upper == upper; }))
      return doubt(Choice::may_part, TrackedBy::overlap, slab, lower, upper);
    graph_.remove(slab, lower, upper);
    result_.closed[slab].emplace_back(lower, upper);
    doubt(Choice::may_connect, TrackedBy::overlap, slab, lower, upper);
  }

  /// Does the row of like sections that ends here begin with a tracked link, or hold one?
  bool hangs_on_tracked(std::size_t k, std::uint32_t i, bool up) const {
    for (;;) {
      const auto& inner = up ? graph_.below(k, i) : graph_.above(k, i);
      if (inner.size() != 1) return false;
      const std::uint32_t next = inner.front();
      const auto& tracked = result_.links[up ? k - 1 : k];
      if (std::any_of(tracked.begin(), tracked.end(), [&](const TrackedLink& link) {
            return link.lower == (up ? next : i) && link.upper == (up ? i : next);
          }))
        return true;
      if (!before(k, i, up)) return false;
      k = up ? k - 1 : k + 1;
      i = next;
    }
  }

  // --- what stays free -----------------------------------------------------------------------------------------------

  void ask_about_free_ends() {
    for (const DriftCandidate& c : drift_candidates(graph_, apart_))
      if (std::max(c.line, c.own) < worth_asking)
        doubt(Choice::may_connect, TrackedBy::drift, c.slab, c.lower, c.upper);
  }

  const std::vector<KnownLinks>& slabs_;
  ShapeGraph graph_;
  std::vector<std::size_t> first_shape_;
  UnionFind joined_;  // shapes, by tracked links alone
  std::vector<ShapePairs> apart_;
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, DoubtfulLink> doubts_;
  Tracking result_;
};

}  // namespace

Tracking track(const std::vector<ShapeSlice>& slices, const std::vector<KnownLinks>& slabs) {
  return Tracker(slices, slabs).run();
}

KnownLinks links_by(const std::vector<RegionLink>& witnessed, Correspondence criterion) {
  const LinkCriterion widest = criterion == Correspondence::reverse  ? LinkCriterion::reverse
                               : criterion == Correspondence::medial ? LinkCriterion::medial
                                                                     : LinkCriterion::overlap;
  KnownLinks links;
  for (const RegionLink& link : witnessed) (link.criterion <= widest ? links.made : links.overlapping).push_back(link);
  return links;
}

}  // namespace odontoscope::delaunay
