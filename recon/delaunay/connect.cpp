#include <map>

#include "recon/delaunay/carve.h"
#include "recon/delaunay/links.h"

namespace odontoscope::delaunay {
namespace {

/// Numbers the face-connected pieces of kept tetrahedra; none for the others. The number of a piece is its first tetrahedron.
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

/// For each piece whose owner has several: its tetrahedra.
std::vector<TetList> strays(const std::vector<std::uint32_t>& piece, const std::vector<std::uint32_t>& owner) {
  std::map<std::uint32_t, TetList> members;
  std::map<std::uint32_t, std::size_t> pieces;
  for (std::uint32_t t = 0; t < piece.size(); ++t) {
    if (piece[t] == none) continue;
    if (piece[t] == t) ++pieces[owner[t]];
    members[piece[t]].push_back(t);
  }
  std::vector<TetList> found;
  for (auto& [first, tets] : members)
    if (pieces[owner[first]] > 1) found.push_back(std::move(tets));
  return found;
}

}  // namespace

std::optional<std::size_t> connect(const std::vector<SlabTetrahedron>& tets, const Planar& lower, const Planar& upper,
                                   const std::vector<std::uint32_t>& owner, std::vector<Fate>& fate) {
  std::size_t restored = 0;
  for (;;) {
    const std::vector<std::uint32_t> piece = pieces_of(tets, fate);
    const std::vector<TetList> apart = strays(piece, owner);
    if (apart.empty()) return restored;
    const std::vector<Cost> costs = costs_of(tets, lower, upper);
    TetList best;
    Cost least;
    for (const TetList& start : apart) {
      Cost cost;
      TetList way = cheapest_way(
          tets, costs, start, [](std::uint32_t, int) { return true; },
          [&](std::uint32_t t) { return piece[t] == none && owner[t] == owner[start[0]]; },
          [&](std::uint32_t t) { return piece[t] != none && piece[t] != piece[start[0]] && owner[t] == owner[start[0]]; }, cost);
      if (!way.empty() && (best.empty() || cost < least)) {
        best = std::move(way);
        least = cost;
      }
    }
    if (best.empty()) return std::nullopt;
    for (const std::uint32_t t : best) fate[t] = Fate::restored;
    restored += best.size();
  }
}

}  // namespace odontoscope::delaunay
