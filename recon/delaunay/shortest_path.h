#pragma once
// The cheapest way from one part of a slab's triangulation to another, through faces: Dijkstra.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "recon/delaunay/slab.h"

namespace odontoscope::delaunay {

using TetList = std::vector<TetIndex>;

/// Cost of putting tetrahedra back: how many flat ones (which could hardly be split and lifted), how many at all, how
/// large. Geometric, so that the choice does not hang on the order of the input.
struct Cost {
  std::size_t flat = 0;
  std::size_t count = 0;
  double volume = 0;
  friend auto operator<=>(const Cost&, const Cost&) = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 errs
};

using Costs = Table<TetIndex, Cost>;

/// Of each tetrahedron. Its volume is taken six times, for a slab of height 1; it is flat where its in-plane triangle
/// or the angle between its two in-plane edges is thinner than limits::flat_share.
Costs costs_of(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper);

inline Cost operator+(const Cost& a, const Cost& b) {
  return {a.flat + b.flat, a.count + b.count, a.volume + b.volume};
}

/// The cheapest way through faces from a tetrahedron of `from` to one that `is_target`, over those that `may_pass`;
/// neither end included. `leave(t, i)` says whether the way may cross face i of tetrahedron t. Empty if there is none,
/// or none cheaper than `*bound`, where one is given. `cost` receives its cost.
template <class Leave, class MayPass, class IsTarget>
TetList shortest_path(const SlabTetrahedra& tetrahedra, const Costs& costs, const TetList& from, Leave leave,
                      MayPass may_pass, IsTarget is_target, Cost& cost, const Cost* bound = nullptr) {
  struct Step {
    Cost cost;
    TetIndex tet;
    bool operator<(const Step& other) const {
      return std::tie(other.cost, other.tet) < std::tie(cost, tet);
    }  // cheapest on top
  };
  std::priority_queue<Step> open;
  std::unordered_map<TetIndex, std::pair<Cost, TetIndex>> best;  // and the tetrahedron behind; looked up, never walked
  for (const TetIndex t : from) best[t] = {Cost{}, none};
  for (const TetIndex t : from) {  // from within nothing begins
    const auto& nb = tetrahedra[t].nb;
    if (std::any_of(nb.begin(), nb.end(), [&best](TetIndex other) { return other != none && best.count(other) == 0; }))
      open.push({Cost{}, t});
  }
  while (!open.empty()) {
    const Step step = open.top();
    open.pop();
    if (bound != nullptr && !(step.cost < *bound)) return {};
    if (best[step.tet].first < step.cost) continue;
    if (best[step.tet].second != none && is_target(step.tet)) {
      TetList way;
      for (TetIndex t = best[step.tet].second; best[t].second != none; t = best[t].second) way.push_back(t);
      cost = step.cost;
      return way;
    }
    for (int i = 0; i < 4; ++i) {
      const TetIndex other = tetrahedra[step.tet].nb[i];
      if (other == none || !leave(step.tet, i)) continue;
      const bool target = is_target(other);
      if (!target && !may_pass(other)) continue;
      const Cost next = target ? step.cost : step.cost + costs[other];
      const auto known = best.find(other);
      if (known != best.end() && known->second.first <= next) continue;
      best[other] = {next, step.tet};
      open.push({next, other});
    }
  }
  return {};
}

}  // namespace odontoscope::delaunay
