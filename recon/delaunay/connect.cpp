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
std::vector<std::uint32_t> pieces_of(const std::vector<SlabTetrahedron>& tets, const std::vector<Fate>& fate) {
  std::vector<std::uint32_t> piece(tets.size(), none), stack;
  for (std::uint32_t seed = 0; seed < tets.size(); ++seed) {
    if (fate[seed] == Fate::removed || piece[seed] != none) continue;
    piece[seed] = seed;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (const std::uint32_t other : tets[t].nb)
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
  Pieces(const std::vector<SlabTetrahedron>& tets, const std::vector<std::uint32_t>& owner,
         const std::vector<Fate>& fate)
      : tets_(tets), owner_(owner), piece_(pieces_of(tets, fate)), now_(tets.size()) {
    for (std::uint32_t t = 0; t < piece_.size(); ++t) {
      if (piece_[t] == none) continue;
      if (piece_[t] == t) ++pieces_[owner_[t]];
      members_[piece_[t]].push_back(t);
    }
  }

  /// The piece of t; none if t is kept by nobody.
  std::uint32_t of(std::uint32_t t) { return piece_[t] == none ? none : now_.find(piece_[t]); }

  /// For each piece whose owner has several: its tetrahedra.
  std::vector<const TetList*> strays() const {
    std::vector<const TetList*> found;
    for (const auto& [first, tets] : members_)
      if (pieces_.at(owner_[first]) > 1) found.push_back(&tets);
    return found;
  }

  /// t is put back, and joins what it meets in a face.
  void add(std::uint32_t t) {
    piece_[t] = t;
    members_[t] = {t};
    ++pieces_[owner_[t]];
    for (const std::uint32_t other : tets_[t].nb)
      if (other != none && piece_[other] != none) join(of(t), of(other));
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    now_.join(a, b);
    const std::uint32_t stays = now_.find(a), goes = stays == a ? b : a;
    --pieces_[owner_[goes]];
    TetList both;
    std::merge(members_[a].begin(), members_[a].end(), members_[b].begin(), members_[b].end(),
               std::back_inserter(both));
    members_.erase(goes);
    members_[stays] = std::move(both);
  }

  const std::vector<SlabTetrahedron>& tets_;
  const std::vector<std::uint32_t>& owner_;
  std::vector<std::uint32_t> piece_;  // of each tetrahedron, as it was at first
  UnionFind now_;                     // of these; the least stands for all
  std::map<std::uint32_t, TetList> members_;
  std::map<std::uint32_t, std::size_t> pieces_;  // of each owner
};

}  // namespace

std::optional<std::size_t> connect(const std::vector<SlabTetrahedron>& tets, const Planar& lower, const Planar& upper,
                                   const std::vector<std::uint32_t>& owner, std::vector<Fate>& fate) {
  Pieces pieces(tets, owner, fate);
  std::size_t restored = 0;
  std::vector<Cost> costs;
  for (;;) {
    const std::vector<const TetList*> apart = pieces.strays();
    if (apart.empty()) return restored;
    if (costs.empty()) costs = costs_of(tets, lower, upper);
    TetList best;
    Cost least;
    for (const TetList* start : apart) {
      const std::uint32_t own = pieces.of(start->front()), by = owner[start->front()];
      Cost cost;
      TetList way = shortest_path(
          tets, costs, *start, [](std::uint32_t, int) { return true; },
          [&](std::uint32_t t) { return fate[t] == Fate::removed && owner[t] == by; },
          [&](std::uint32_t t) { return fate[t] != Fate::removed && owner[t] == by && pieces.of(t) != own; }, cost,
          best.empty() ? nullptr : &least);
      if (!way.empty()) {
        best = std::move(way);
        least = cost;
      }
    }
    if (best.empty()) return std::nullopt;
    for (const std::uint32_t t : best) {
      fate[t] = Fate::restored;
      pieces.add(t);
    }
    restored += best.size();
  }
}

}  // namespace odontoscope::delaunay
