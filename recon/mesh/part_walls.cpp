#include "recon/mesh/part_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "recon/core/union_find.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// An edge of a triangle, from its lower vertex to its higher one.
struct Side {
  PointIndex low = 0, high = 0;
  std::uint32_t triangle = 0;
  std::uint8_t corner = 0;    // that it leaves from, as the triangle runs
  bool forward = false;       // the triangle runs from low to high
};

bool same_edge(const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; }

class WallParting {
 public:
  explicit WallParting(const SurfaceMesh& mesh) : mesh_(mesh), partner_(mesh.triangles.size(), none), corners_(3 * mesh.triangles.size()), surfaces_(mesh.triangles.size()) {}

  std::size_t run(SurfaceMesh& parted) {
    const std::size_t walls = find_partners();
    if (walls == 0) return 0;
    join_along_edges();
    for (std::uint32_t t = 0; t < partner_.size(); ++t)
      if (partner_[t] != none && surfaces_.find(t) == surfaces_.find(partner_[t])) return 0;
    number_anew(parted);
    return walls;
  }

 private:
  /// Of each triangle the one that lies on it, turned over; none where more than two have the same corners.
  std::size_t find_partners() {
    std::vector<std::pair<Triangle, std::uint32_t>> sorted;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      Triangle one = mesh_.triangles[t];
      std::sort(one.begin(), one.end());
      sorted.emplace_back(one, t);
    }
    std::sort(sorted.begin(), sorted.end());
    std::size_t walls = 0;
    for (std::size_t i = 0, end = 0; i < sorted.size(); i = end) {
      while (end < sorted.size() && sorted[end].first == sorted[i].first) ++end;
      const auto& [corners, t] = sorted[i];
      if (end - i != 2 || corners[0] == corners[1] || corners[1] == corners[2]) continue;
      const std::uint32_t other = sorted[i + 1].second;
      if (even(t) == even(other)) continue;
      partner_[t] = other;
      partner_[other] = t;
      walls += 2;
    }
    return walls;
  }

  /// Do its corners ascend, read from some corner on?
  bool even(std::uint32_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return (a < b) + (b < c) + (c < a) == 2;
  }

  void join_along_edges() {
    std::vector<Side> sides;
    std::vector<bool> on_wall(mesh_.points.size(), false);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& one = mesh_.triangles[t];
      for (std::uint8_t i = 0; i < 3; ++i) {
        const PointIndex a = one[i], b = one[(i + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), t, i, a < b});
        if (partner_[t] != none) on_wall[a] = true;
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::array{a.low, a.high, a.triangle, std::uint32_t{a.corner}} < std::array{b.low, b.high, b.triangle, std::uint32_t{b.corner}};
    });
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      while (end < sides.size() && same_edge(sides[end], sides[i])) ++end;
      join({sides.begin() + static_cast<std::ptrdiff_t>(i), sides.begin() + static_cast<std::ptrdiff_t>(end)});
    }
    std::vector<std::uint32_t> first(mesh_.points.size(), none);
    for (std::uint32_t c = 0; c < 3 * mesh_.triangles.size(); ++c) {
      const PointIndex v = mesh_.triangles[c / 3][c % 3];
      if (on_wall[v]) continue;
      if (first[v] == none) first[v] = c;
      corners_.join(first[v], c);
    }
  }

  void join(const std::vector<Side>& edge) {
    const bool walled = std::any_of(edge.begin(), edge.end(), [&](const Side& side) { return partner_[side.triangle] != none; });
    if (walled && edge.size() > 2) {
      if (const auto pairs = pairs_of(edge)) {
        for (const auto& [a, b] : *pairs) join(edge[a], edge[b]);
        return;
      }
    }
    for (std::size_t i = 1; i < edge.size(); ++i) join(edge[0], edge[i]);
  }

  void join(const Side& a, const Side& b) {
    surfaces_.join(a.triangle, b.triangle);
    corners_.join(corner(a, a.forward), corner(b, b.forward));
    corners_.join(corner(a, !a.forward), corner(b, !b.forward));
  }

  /// Of the two ends of a side: the one that the triangle leaves from, or the other.
  static std::uint32_t corner(const Side& side, bool leaving) { return 3 * side.triangle + (leaving ? side.corner : (side.corner + 1) % 3); }

  PointIndex opposite(const Side& side) const { return mesh_.triangles[side.triangle][(side.corner + 2) % 3]; }

  /// Round an edge, turning about it from low to high, material begins at triangles that run backward and ends at those that run forward. So each of those
  /// belongs with the next of these; none if that is not clear.
  std::optional<std::vector<std::pair<std::size_t, std::size_t>>> pairs_of(const std::vector<Side>& edge) const {
    const std::optional<std::vector<std::size_t>> order = turning(edge);
    if (!order) return std::nullopt;
    const std::size_t count = order->size();
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::size_t begin = 0;
    while (begin < count && !(edge[(*order)[begin]].forward && !edge[(*order)[(begin + 1) % count]].forward)) ++begin;
    if (begin == count) return std::nullopt;
    for (std::size_t i = 1; i <= count; i += 2) {
      const std::size_t from = (*order)[(begin + i) % count], to = (*order)[(begin + i + 1) % count];
      if (edge[from].forward || !edge[to].forward || partner_[edge[from].triangle] == edge[to].triangle) return std::nullopt;
      pairs.emplace_back(from, to);
    }
    return pairs;
  }

  /// The triangles of an edge in order of their angle about it, of two that lie on each other the one that ends material first; none if others are level.
  std::optional<std::vector<std::size_t>> turning(const std::vector<Side>& edge) const {
    if (edge.size() == 4)
      if (auto forced = the_only_way(edge)) return forced;
    const Point3 &low = mesh_.points[edge[0].low], &high = mesh_.points[edge[0].high];
    const PointIndex first = opposite(edge[0]);
    const auto about = [&](PointIndex from, PointIndex to) { return from == to ? 0 : orientation(low, high, mesh_.points[from], mesh_.points[to]); };
    bool level = false;
    const auto half = [&](PointIndex v) {
      const int turn = about(first, v);
      if (turn == 0 && v != first) level = true;
      return v == first ? 0 : (turn > 0 ? 1 : 2);
    };
    std::vector<std::size_t> order(edge.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const PointIndex va = opposite(edge[a]), vb = opposite(edge[b]);
      const int ha = half(va), hb = half(vb);
      if (ha != hb) return ha < hb;
      if (va == vb) return std::pair{!edge[a].forward, a} < std::pair{!edge[b].forward, b};
      const int turn = about(va, vb);
      if (turn == 0) level = true;
      return turn != 0 ? turn > 0 : a < b;
    });
    if (level) return std::nullopt;
    return order;
  }

  /// Of four triangles two lie on each other: each of them belongs with the other one that it can, whatever the angles.
  std::optional<std::vector<std::size_t>> the_only_way(const std::vector<Side>& edge) const {
    std::vector<std::size_t> forward, backward;
    for (std::size_t i = 0; i < 4; ++i) (edge[i].forward ? forward : backward).push_back(i);
    if (forward.size() != 2) return std::nullopt;
    const auto lie = [&](std::size_t a, std::size_t b) { return partner_[edge[a].triangle] == edge[b].triangle; };
    if (lie(forward[0], backward[1]) || lie(forward[1], backward[0])) std::swap(backward[0], backward[1]);
    if (!lie(forward[0], backward[0]) && !lie(forward[1], backward[1])) return std::nullopt;
    return std::vector<std::size_t>{forward[0], backward[0], forward[1], backward[1]};
  }

  void number_anew(SurfaceMesh& parted) {
    std::vector<PointIndex> number(3 * mesh_.triangles.size(), none);
    for (std::uint32_t c = 0; c < number.size(); ++c) {
      const std::uint32_t root = corners_.find(c);
      if (number[root] == none) {
        number[root] = static_cast<PointIndex>(parted.points.size());
        parted.points.push_back(mesh_.points[mesh_.triangles[c / 3][c % 3]]);
      }
      if (c % 3 == 0) parted.triangles.emplace_back();
      parted.triangles.back()[c % 3] = number[root];
    }
  }

  const SurfaceMesh& mesh_;
  std::vector<std::uint32_t> partner_;
  UnionFind corners_, surfaces_;
};

}  // namespace

std::size_t part_walls(SurfaceMesh& mesh) {
  SurfaceMesh parted;
  const std::size_t walls = WallParting(mesh).run(parted);
  if (walls > 0) mesh = std::move(parted);
  return walls;
}

void part_walls_told(NamedMesh& mesh) {
  if (const std::size_t walls = part_walls(mesh.surface))
    mesh.remarks.push_back(fmt::format("{} of its triangles lie on each other, face to face: surfaces that share walls were parted there", walls));
}

}  // namespace odontoscope
