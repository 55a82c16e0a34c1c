#include "recon/mesh/part_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "recon/core/union_find.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/mesh/half_edges.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

using Edge = std::span<const HalfEdge>;  // its half-edges: more than two

class WallParting {
 public:
  explicit WallParting(const SurfaceMesh& mesh)
      : mesh_(mesh),
        edges_(edge_mates(mesh)),
        partner_(mesh.triangles.size(), none),
        corners_(3 * mesh.triangles.size()),
        surfaces_(mesh.triangles.size()) {}

  std::size_t run(SurfaceMesh& parted) {
    if (edges_.crowded.empty()) return 0;  // two that lie on each other by themselves are one surface
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
    for (HalfEdge h = 0; h < edges_.mate.size(); ++h)
      if (const HalfEdge mate = edges_.mate[h]; mate < EdgeMates::no_edge && h < mate) join(h, mate);
    const Edge crowded = edges_.crowded;
    for (std::size_t i = 0, end = 0; i < crowded.size(); i = end) {
      while (end < crowded.size() && low(crowded[end]) == low(crowded[i]) && high(crowded[end]) == high(crowded[i]))
        ++end;
      join_round(crowded.subspan(i, end - i));
    }
    join_beside_walls();
  }

  /// Vertices of no wall stay whole, and triangles without edges stay where they are.
  void join_beside_walls() {
    std::vector<bool> on_wall(mesh_.points.size(), false);
    for (std::uint32_t t = 0; t < partner_.size(); ++t)
      if (partner_[t] != none)
        for (const PointIndex v : mesh_.triangles[t]) on_wall[v] = true;
    std::vector<std::uint32_t> first(mesh_.points.size(), none);
    for (HalfEdge corner = 0; corner < 3 * mesh_.triangles.size(); ++corner) {
      const PointIndex v = start(mesh_, corner);
      if (first[v] == none) first[v] = corner;
      if (!on_wall[v] || edges_.mate[corner] == EdgeMates::no_edge) corners_.join(first[v], corner);
    }
  }

  void join_round(Edge edge) {
    const bool walled = std::any_of(edge.begin(), edge.end(), [&](HalfEdge h) { return partner_[h / 3] != none; });
    if (const auto pairs = walled ? pairs_of(edge) : std::nullopt) {
      for (const auto& [a, b] : *pairs) join(a, b);
      return;
    }
    for (const HalfEdge h : edge) join(edge[0], h);
  }

  void join(HalfEdge a, HalfEdge b) {
    surfaces_.join(a / 3, b / 3);
    const bool alike = start(mesh_, a) == start(mesh_, b);
    corners_.join(a, alike ? b : next(b));
    corners_.join(next(a), alike ? next(b) : b);
  }

  PointIndex low(HalfEdge h) const { return std::min(start(mesh_, h), end(mesh_, h)); }
  PointIndex high(HalfEdge h) const { return std::max(start(mesh_, h), end(mesh_, h)); }
  bool forward(HalfEdge h) const { return start(mesh_, h) == low(h); }
  PointIndex opposite(HalfEdge h) const { return start(mesh_, previous(h)); }
  bool lie(HalfEdge a, HalfEdge b) const { return partner_[a / 3] == b / 3; }

  /// Round an edge, turning about it from low to high, material begins at triangles that run backward and ends at those
  /// that run forward. So each of those belongs with the next of these; none if that is not clear.
  std::optional<std::vector<std::pair<HalfEdge, HalfEdge>>> pairs_of(Edge edge) const {
    const std::optional<std::vector<HalfEdge>> order = turning(edge);
    if (!order) return std::nullopt;
    const std::size_t count = order->size();
    std::vector<std::pair<HalfEdge, HalfEdge>> pairs;
    std::size_t begin = 0;
    while (begin < count && !(forward((*order)[begin]) && !forward((*order)[(begin + 1) % count]))) ++begin;
    if (begin == count) return std::nullopt;
    for (std::size_t i = 1; i <= count; i += 2) {
      const HalfEdge from = (*order)[(begin + i) % count], to = (*order)[(begin + i + 1) % count];
      if (forward(from) || !forward(to) || lie(from, to)) return std::nullopt;
      pairs.emplace_back(from, to);
    }
    return pairs;
  }

  /// The triangles of an edge in order of their angle about it, of two that lie on each other the one that ends
  /// material first; none if others are level.
  std::optional<std::vector<HalfEdge>> turning(Edge edge) const {
    if (edge.size() == 4)
      if (auto forced = the_only_way(edge)) return forced;
    const Point3 &from = mesh_.points[low(edge[0])], &to = mesh_.points[high(edge[0])];
    const PointIndex first = opposite(edge[0]);
    const auto about = [&](PointIndex a, PointIndex b) {
      return a == b ? 0 : orientation(from, to, mesh_.points[a], mesh_.points[b]);
    };
    bool level = false;
    const auto half = [&](PointIndex v) {
      const int turn = about(first, v);
      if (turn == 0 && v != first) level = true;
      return v == first ? 0 : (turn > 0 ? 1 : 2);
    };
    std::vector<HalfEdge> order(edge.begin(), edge.end());
    std::sort(order.begin(), order.end(), [&](HalfEdge a, HalfEdge b) {
      const PointIndex va = opposite(a), vb = opposite(b);
      const int ha = half(va), hb = half(vb);
      if (ha != hb) return ha < hb;
      if (va == vb) return std::pair{!forward(a), a} < std::pair{!forward(b), b};
      const int turn = about(va, vb);
      if (turn == 0) level = true;
      return turn != 0 ? turn > 0 : a < b;
    });
    if (level) return std::nullopt;
    return order;
  }

  /// Of four triangles two lie on each other: each of them belongs with the other one that it can, whatever the angles.
  std::optional<std::vector<HalfEdge>> the_only_way(Edge edge) const {
    std::vector<HalfEdge> ends, begins;  // of material
    for (const HalfEdge h : edge) (forward(h) ? ends : begins).push_back(h);
    if (ends.size() != 2) return std::nullopt;
    if (lie(ends[0], begins[1]) || lie(ends[1], begins[0])) std::swap(begins[0], begins[1]);
    if (!lie(ends[0], begins[0]) && !lie(ends[1], begins[1])) return std::nullopt;
    return std::vector<HalfEdge>{ends[0], begins[0], ends[1], begins[1]};
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
  const EdgeMates edges_;
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
    mesh.remarks.push_back(fmt::format(
        "{} of its triangles lie on each other, face to face: surfaces that share walls were parted there", walls));
}

}  // namespace odontoscope
