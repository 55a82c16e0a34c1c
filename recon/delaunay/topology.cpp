#include "recon/delaunay/topology.h"

#include <algorithm>
#include <array>
#include <set>

#include "recon/core/union_find.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {
namespace {

/// Of the graph whose nodes are those that are `in`: components, and cycles beyond a tree in each.
struct GraphCount {
  long components = 0, cycles = 0;
};

GraphCount count(const SlabLinks& links) {
  const auto lower = static_cast<std::uint32_t>(links.lower_in.size()),
             upper = static_cast<std::uint32_t>(links.upper_in.size());
  UnionFind pieces(lower + upper);
  GraphCount found;
  for (const auto& [a, b] : links.material) {
    if (!links.lower_in[a] || !links.upper_in[b]) continue;
    if (pieces.find(a) == pieces.find(lower + b)) ++found.cycles;
    pieces.join(a, lower + b);
  }
  std::set<std::uint32_t> heads;
  for (std::uint32_t r = 0; r < lower; ++r)
    if (links.lower_in[r]) heads.insert(pieces.find(r));
  for (std::uint32_t r = 0; r < upper; ++r)
    if (links.upper_in[r]) heads.insert(pieces.find(lower + r));
  found.components = static_cast<long>(heads.size());
  return found;
}

long holes_in(const Nesting& slice, const std::vector<bool>& in) {
  long holes = 0;
  for (std::size_t v = 1; v < slice.owner.size(); ++v) holes += in[slice.owner[v]];
  return holes;
}

/// Components of the graph of void that do not reach the outside.
long shut_voids(const Nesting& lower, const Nesting& upper, const SlabLinks& links) {
  const auto first_upper = static_cast<std::uint32_t>(lower.owner.size());
  UnionFind voids(first_upper + static_cast<std::uint32_t>(upper.owner.size()));
  voids.join(0, first_upper);
  for (const auto& [a, b] : links.voids) voids.join(a, first_upper + b);
  const auto merge_through_absent = [&voids](const Nesting& slice, const std::vector<bool>& in, std::uint32_t first) {
    for (std::uint32_t v = 1; v < slice.owner.size(); ++v)
      if (!in[slice.owner[v]]) voids.join(first + v, first + slice.around[slice.owner[v]]);
  };
  merge_through_absent(lower, links.lower_in, 0);
  merge_through_absent(upper, links.upper_in, first_upper);
  std::set<std::uint32_t> heads;
  for (std::uint32_t v = 0; v < first_upper + upper.owner.size(); ++v) heads.insert(voids.find(v));
  return static_cast<long>(heads.size()) - 1;
}

struct Connected {
  long parts = 0, corners = 0;
};

/// Simplices joined by common corners, which `number` maps below `count`.
template <class Simplex, class Number>
Connected connected(const std::vector<Simplex>& simplices, Number number, std::uint32_t count) {
  std::vector<bool> used(count, false);
  UnionFind parts(count);
  for (const Simplex& simplex : simplices) {
    const std::uint32_t first = number(simplex[0]);
    for (const std::uint32_t v : simplex) {
      used[number(v)] = true;
      parts.join(first, number(v));
    }
  }
  Connected found;
  for (std::uint32_t p = 0; p < count; ++p) {
    found.corners += used[p];
    found.parts += used[p] && parts.find(p) == p;
  }
  return found;
}

/// The pieces of a set of tetrahedra, joined by faces, and their cells.
class PiecesByFaces {
 public:
  explicit PiecesByFaces(const std::vector<Tetrahedron>& tetrahedra)
      : tetrahedra_(tetrahedra), first_with_(tetrahedra.size() * 4), joined_(tetrahedra.size()) {
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
      for (const auto& f : outward_face) {
        std::uint32_t& first = first_with_(tetrahedra[t][f[0]], tetrahedra[t][f[1]], tetrahedra[t][f[2]]);
        if (first == FaceTable::vacant)
          first = t;
        else
          joined_.join(first, t);
      }
  }

  long count() {
    long pieces = 0;
    for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t) pieces += joined_.find(t) == t;
    return pieces;
  }

  std::uint32_t of(std::uint32_t tetrahedron) { return joined_.find(tetrahedron); }
  std::uint32_t of(const Triangle& face) { return joined_.find(first_with_(face[0], face[1], face[2])); }

  /// Vertices and edges; those that pieces share count once for each.
  long vertices_less_edges() {
    std::vector<std::array<std::uint32_t, 2>> vertices;
    std::vector<std::array<std::uint32_t, 3>> edges;
    for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t)
      for (int i = 0; i < 4; ++i) {
        vertices.push_back({of(t), tetrahedra_[t][i]});
        for (int j = 0; j < i; ++j) edges.push_back(edge(of(t), tetrahedra_[t][i], tetrahedra_[t][j]));
      }
    return different(vertices) - different(edges);
  }

  static std::array<std::uint32_t, 3> edge(std::uint32_t piece, std::uint32_t a, std::uint32_t b) {
    return {piece, std::min(a, b), std::max(a, b)};
  }

 private:
  template <class Cell>
  static long different(std::vector<Cell>& cells) {
    std::sort(cells.begin(), cells.end());
    return std::unique(cells.begin(), cells.end()) - cells.begin();
  }

  const std::vector<Tetrahedron>& tetrahedra_;
  FaceTable first_with_;
  UnionFind joined_;
};

/// Parts of the pieces' boundary, joined by edges within a piece.
long boundary_parts(PiecesByFaces& pieces, const std::vector<Triangle>& boundary) {
  std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> sides;
  for (std::uint32_t f = 0; f < boundary.size(); ++f)
    for (int i = 0; i < 3; ++i)
      sides.emplace_back(PiecesByFaces::edge(pieces.of(boundary[f]), boundary[f][i], boundary[f][(i + 1) % 3]), f);
  std::sort(sides.begin(), sides.end());
  UnionFind joined(boundary.size());
  for (std::size_t s = 1; s < sides.size(); ++s)
    if (sides[s].first == sides[s - 1].first) joined.join(sides[s].second, sides[s - 1].second);
  long parts = 0;
  for (std::uint32_t f = 0; f < boundary.size(); ++f) parts += joined.find(f) == f;
  return parts;
}

}  // namespace

Topology implied_topology(const Nesting& lower, const Nesting& upper, const SlabLinks& links) {
  const GraphCount material = count(links);
  Topology implied;
  implied.pieces = material.components + static_cast<long>(links.lower_plates + links.upper_plates);
  implied.handles = holes_in(lower, links.lower_in) + holes_in(upper, links.upper_in) + material.cycles -
                    shut_voids(lower, upper, links) + static_cast<long>(links.plate_holes);
  return implied;
}

Topology counted_topology(const std::vector<Tetrahedron>& tetrahedra, const std::vector<Triangle>& boundary,
                          const PointRanges& points) {
  Topology found;
  if (tetrahedra.empty()) return found;
  const std::uint32_t on_slices = points.end - points.first,
                      count = on_slices + (points.end_added - points.first_added);
  const auto number = [&](std::uint32_t v) {
    return v >= points.first_added && v < points.end_added ? on_slices + (v - points.first_added) : v - points.first;
  };
  const Connected pieces = connected(tetrahedra, number, count), shells = connected(boundary, number, count);
  // A closed surface has three edges for two faces; the Euler characteristic of a solid is half that of its boundary.
  const long euler = (shells.corners - static_cast<long>(boundary.size()) / 2) / 2;
  found.pieces = pieces.parts;
  found.bubbles = shells.parts - pieces.parts;
  found.handles = found.pieces + found.bubbles - euler;
  return found;
}

Topology counted_topology_of_pinched(const std::vector<Tetrahedron>& tetrahedra,
                                     const std::vector<Triangle>& boundary) {
  PiecesByFaces pieces(tetrahedra);
  const long faces = (4 * static_cast<long>(tetrahedra.size()) + static_cast<long>(boundary.size())) / 2;
  const long euler = pieces.vertices_less_edges() + faces - static_cast<long>(tetrahedra.size());
  Topology found;
  found.pieces = pieces.count();
  found.bubbles = boundary_parts(pieces, boundary) - found.pieces;
  found.handles = found.pieces + found.bubbles - euler;
  return found;
}

}  // namespace odontoscope::delaunay
