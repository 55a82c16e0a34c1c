#include <algorithm>
#include <numeric>
#include <set>

#include "recon/delaunay/carve.h"
#include "recon/delaunay/slab_links.h"

namespace odontoscope::delaunay {
namespace {

/// Works in rounds. A round looks at all singularities as they stand and mends each in its cheapest way, edges first,
/// so that the result does not depend on the order in which they are met.
class Repair {
 public:
  /// `suspects`: the vertices to look at first.
  Repair(const SlabTetrahedra& tets, const Planar& lower, const Planar& upper, const Owners& owner,
         const std::vector<SlabPoint>& suspects, Fates& fate)
      : tets_(tets),
        owner_(owner),
        fate_(fate),
        costs_(costs_of(tets, lower, upper)),
        links_(tets, lower.points.size() + upper.points.size(), fate),
        edges_waiting_(suspects.begin(), suspects.end()),
        links_waiting_(edges_waiting_) {}

  bool run() {
    for (;;) {
      TetList put_back;
      for (const SlabPoint v : edges_waiting_)
        if (!mend_edges(v, put_back)) return false;
      edges_waiting_.clear();  // what is not put back at v leaves v as it is
      if (put_back.empty()) {
        for (const SlabPoint v : links_waiting_)
          if (!mend_link(v, put_back)) return false;
        links_waiting_.clear();
      }
      if (put_back.empty()) return true;
      for (const TetIndex t : put_back) restore(t);
    }
  }

  /// What was put back early may have become needless by what was put back later. The costliest go first.
  void prune() {
    std::stable_sort(restored_.begin(), restored_.end(),
                     [this](TetIndex a, TetIndex b) { return costs_[a] > costs_[b]; });
    for (bool changed = true; changed;) {
      changed = false;
      for (const TetIndex t : restored_) {
        if (fate_[t] != Fate::restored || !may_go(t)) continue;
        fate_[t] = Fate::removed;
        const auto& v = tets_[t].v;
        if (std::all_of(v.begin(), v.end(), [this](SlabPoint w) { return links_.regular(w); }))
          changed = true;
        else
          fate_[t] = Fate::restored;
      }
    }
  }

 private:
  void restore(TetIndex t) {
    if (links_.in(t)) return;
    fate_[t] = Fate::restored;
    restored_.push_back(t);
    edges_waiting_.insert(tets_[t].v.begin(), tets_[t].v.end());
    links_waiting_.insert(tets_[t].v.begin(), tets_[t].v.end());
  }

  /// Quickly, what speaks against taking t out again: with at most one open face it would leave a pocket shut in at a
  /// vertex; with two, the edge between the other two faces must have nothing else open around it. A cheap filter:
  /// links are then tested in full.
  bool may_go(TetIndex t) const {
    const SlabTetrahedron& tet = tets_[t];
    std::array<SlabPoint, 4> open;
    int count = 0;
    for (int i = 0; i < 4; ++i)
      if (tet.nb[i] == none || !links_.in(tet.nb[i])) open[count++] = tet.v[i];
    if (count == 2) return links_.gaps(open[0], open[1], t).closed_and_full();
    return count > 2;
  }

  Cost cost_of(const TetList& tets) const {
    Cost cost;
    for (const TetIndex t : tets) cost = cost + costs_[t];
    return cost;
  }

  bool allowed(const TetList& tets) const {
    return std::all_of(tets.begin(), tets.end(), [this](TetIndex t) { return owner_[t] != none; });
  }

  /// Closes all gaps around each edge at v but the costliest; where the ring is open at the hull or a slice, that one
  /// too.
  bool mend_edges(SlabPoint v, TetList& put_back) {
    for (const auto& [w, t] : links_.mixed_edges(v)) {
      Links::Gaps gaps = links_.gaps(v, w, t);
      if (!gaps.singular()) continue;
      auto& runs = gaps.runs;
      if (gaps.closed) {  // a gap that must not be filled is the one to leave
        const auto left = std::max_element(runs.begin(), runs.end(), [this](const TetList& a, const TetList& b) {
          return std::pair(!allowed(a), cost_of(a)) < std::pair(!allowed(b), cost_of(b));
        });
        runs.erase(left);
      }
      for (const TetList& run : runs) {
        if (!allowed(run)) return false;
        put_back.insert(put_back.end(), run.begin(), run.end());
      }
    }
    return true;
  }

  /// Joins two fans of v by the cheapest way round, or fills what they shut in.
  bool mend_link(SlabPoint v, TetList& put_back) {
    const std::vector<TetList> fans = links_.fans(v);
    const TetList filling = fans.size() > 1 ? cheapest_join(v, fans) : links_.shut_in(v);
    if ((fans.size() > 1 && filling.empty()) || !allowed(filling)) return false;
    put_back.insert(put_back.end(), filling.begin(), filling.end());
    return true;
  }

  TetList cheapest_join(SlabPoint v, const std::vector<TetList>& fans) const {
    TetList best;
    Cost least;
    for (const TetList& fan : fans) {
      const std::set<TetIndex> own(fan.begin(), fan.end());
      Cost cost;
      TetList way = shortest_path(
          tets_, costs_, fan, [&](TetIndex t, int i) { return tets_[t].v[i] != v; },
          [&](TetIndex t) { return !links_.in(t) && owner_[t] != none; },
          [&](TetIndex t) { return links_.in(t) && own.count(t) == 0; }, cost, best.empty() ? nullptr : &least);
      if (!way.empty() && (best.empty() || cost < least)) {
        best = std::move(way);
        least = cost;
      }
    }
    return best;
  }

  const SlabTetrahedra& tets_;
  const Owners& owner_;
  Fates& fate_;
  Costs costs_;
  Links links_;
  std::set<SlabPoint> edges_waiting_,
      links_waiting_;  // vertices at which something changed since they were looked at
  TetList restored_;
};

/// The faces between the kept tetrahedra and anything else, except those that lie in a region.
std::vector<std::array<SlabPoint, 3>> interface_of(const SlabTetrahedra& tets, const Fates& fate) {
  std::vector<std::array<SlabPoint, 3>> faces;
  for (const TetIndex t : tets.indices()) {
    if (fate[t] == Fate::removed) continue;
    const SlabTetrahedron& tet = tets[t];
    // What elimination keeps of a 3-1 stands on an internal triangle; the face opposite its apex is that triangle.
    const int in_plane = tet.lower_count == 3 ? 3 : tet.lower_count == 1 ? 0 : -1;
    for (int i = 0; i < 4; ++i) {
      if (i == in_plane || (tet.nb[i] != none && fate[tet.nb[i]] != Fate::removed)) continue;
      faces.push_back({tet.v[(i + 1) % 4], tet.v[(i + 2) % 4], tet.v[(i + 3) % 4]});
    }
  }
  return faces;
}

/// Vertices around which the kept tetrahedra may be singular. Around a regular one the interface is a single strip of
/// faces, from the contour edge on one side of the vertex to that on the other: then the kept part of its link is a
/// disc. So the graph that the faces leave on the vertex's neighbours is one simple path between its two contour
/// neighbours, through points of the other slice only (a point of its own slice would be the far end of an internal
/// edge with a gap above it). Precondition: nothing is restored yet.
std::vector<SlabPoint> suspects(const SlabTetrahedra& tets, const Planar& lower, const Planar& upper,
                                const Fates& fate) {
  const auto faces = interface_of(tets, fate);
  const SlabNumbers numbers(lower);
  const std::size_t points = lower.points.size() + upper.points.size();
  Table<SlabPoint, std::uint32_t> first(points + 1, 0);
  for (const auto& face : faces)
    for (const SlabPoint v : face) ++first[SlabPoint(v + 1)];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::array<SlabPoint, 2>> strip(first.back());
  Table<SlabPoint, std::uint32_t> fill(first.begin(), first.end() - 1);
  for (const auto& face : faces)
    for (int i = 0; i < 3; ++i) strip[fill[face[i]]++] = {face[(i + 1) % 3], face[(i + 2) % 3]};

  std::vector<SlabPoint> found;
  Table<SlabPoint, SlabPoint> passed(points, none);  // of each point: round which it was passed last
  for (const SlabPoint v : passed.indices()) {
    const SlicePoint own = numbers.own(v);
    const bool is_lower = numbers.is_lower(v);
    const SlabPoint start = is_lower ? numbers.of_lower(lower.previous[own]) : numbers.of_upper(upper.previous[own]);
    const SlabPoint end = is_lower ? numbers.of_lower(lower.next[own]) : numbers.of_upper(upper.next[own]);
    SlabPoint at = start;
    const std::uint32_t from = first[v];
    std::uint32_t left = first[SlabPoint(v + 1)] - from;
    while (left > 0 && at != end) {  // eat the strip from its start; each step takes one face out
      std::uint32_t s = from;
      while (s < from + left && strip[s][0] != at && strip[s][1] != at) ++s;
      if (s == from + left) break;
      at = strip[s][0] == at ? strip[s][1] : strip[s][0];
      std::swap(strip[s], strip[from + --left]);
      if (at != end && (numbers.is_lower(at) == is_lower || passed[at] == v)) break;
      passed[at] = v;
    }
    if (left > 0 || at != end) found.push_back(v);
  }
  return found;
}

}  // namespace

bool repair(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper, const Owners& owner,
            Fates& fate) {
  // What was restored before the call joins pieces on purpose: look at every vertex, and take nothing out.
  const bool fresh = std::find(fate.begin(), fate.end(), Fate::restored) == fate.end();
  std::vector<SlabPoint> doubtful;
  if (fresh) {
    doubtful = suspects(tetrahedra, lower, upper, fate);
  } else {
    doubtful.resize(lower.points.size() + upper.points.size());
    std::iota(doubtful.begin(), doubtful.end(), SlabPoint(0));
  }
  if (doubtful.empty()) return true;
  Repair work(tetrahedra, lower, upper, owner, doubtful, fate);
  if (!work.run()) return false;
  if (fresh) work.prune();
  return true;
}

}  // namespace odontoscope::delaunay
