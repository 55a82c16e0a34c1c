#include <algorithm>
#include <iterator>
#include <map>

#include "recon/core/union_find.h"
#include "recon/delaunay/carve.h"
#include "recon/delaunay/slab_links.h"

namespace odontoscope::delaunay {
namespace {

/// Numbers the face-connected pieces of kept tetrahedra; none for the others. The number of a piece is its first
/// tetrahedron.
Table<TetIndex, TetIndex> pieces_of(const SlabTetrahedra& tets, const Fates& fate) {
  Table<TetIndex, TetIndex> piece(tets.size(), none);
  TetList stack;
  for (const TetIndex seed : tets.indices()) {
    if (fate[seed] == Fate::removed || piece[seed] != none) continue;
    piece[seed] = seed;
    stack.push_back(seed);
    while (!stack.empty()) {
      const TetIndex t = stack.back();
      stack.pop_back();
      for (const TetIndex other : tets[t].nb)
        if (other != none && fate[other] != Fate::removed && piece[other] == none) {
          piece[other] = seed;
          stack.push_back(other);
        }
    }
  }
  return piece;
}

/// The pieces as they grow together. A piece goes by its first tetrahedron.
class Pieces {
 public:
  Pieces(const SlabTetrahedra& tets, const Owners& owner, const Fates& fate)
      : tets_(tets), owner_(owner), piece_(pieces_of(tets, fate)), now_(tets.size()) {
    for (const TetIndex t : piece_.indices()) {
      if (piece_[t] == none) continue;
      if (piece_[t] == t) ++pieces_[owner_[t]];
      members_[piece_[t]].push_back(t);
    }
  }

  /// The piece of t; none if t is kept by nobody.
  TetIndex of(TetIndex t) { return piece_[t] == none ? TetIndex() : TetIndex(now_.find(piece_[t])); }

  /// For each piece whose owner has several: its tetrahedra.
  std::vector<const TetList*> strays() const {
    std::vector<const TetList*> found;
    for (const auto& [first, tets] : members_)
      if (pieces_.at(owner_[first]) > 1) found.push_back(&tets);
    return found;
  }

  /// t is put back, and joins what it meets in a face.
  void add(TetIndex t) {
    piece_[t] = t;
    members_[t] = {t};
    ++pieces_[owner_[t]];
    for (const TetIndex other : tets_[t].nb)
      if (other != none && piece_[other] != none) join(of(t), of(other));
  }

 private:
  void join(TetIndex a, TetIndex b) {
    if (a == b) return;
    now_.join(a, b);
    const TetIndex stays(now_.find(a)), goes = stays == a ? b : a;
    --pieces_[owner_[goes]];
    TetList both;
    std::merge(members_[a].begin(), members_[a].end(), members_[b].begin(), members_[b].end(),
               std::back_inserter(both));
    members_.erase(goes);
    members_[stays] = std::move(both);
  }

  const SlabTetrahedra& tets_;
  const Owners& owner_;
  Table<TetIndex, TetIndex> piece_;  // of each tetrahedron, as it was at first
  UnionFind now_;                    // of these; the least stands for all
  std::map<TetIndex, TetList> members_;
  std::map<std::uint32_t, std::size_t> pieces_;  // of each owner
};

}  // namespace

std::optional<std::size_t> connect(const SlabTetrahedra& tets, const Planar& lower, const Planar& upper,
                                   const Owners& owner, Fates& fate) {
  Pieces pieces(tets, owner, fate);
  std::size_t restored = 0;
  Costs costs;
  for (;;) {
    const std::vector<const TetList*> apart = pieces.strays();
    if (apart.empty()) return restored;
    if (costs.empty()) costs = costs_of(tets, lower, upper);
    TetList best;
    Cost least;
    for (const TetList* start : apart) {
      const TetIndex own = pieces.of(start->front());
      const std::uint32_t by = owner[start->front()];
      Cost cost;
      TetList way = shortest_path(
          tets, costs, *start, [](TetIndex, int) { return true; },
          [&](TetIndex t) { return fate[t] == Fate::removed && owner[t] == by; },
          [&](TetIndex t) { return fate[t] != Fate::removed && owner[t] == by && pieces.of(t) != own; }, cost,
          best.empty() ? nullptr : &least);
      if (!way.empty()) {
        best = std::move(way);
        least = cost;
      }
    }
    if (best.empty()) return std::nullopt;
    for (const TetIndex t : best) {
      fate[t] = Fate::restored;
      pieces.add(t);
    }
    restored += best.size();
  }
}

}  // namespace odontoscope::delaunay
