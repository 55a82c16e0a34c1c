#include "recon/delaunay/slab_links.h"

#include <algorithm>
#include <cmath>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope::delaunay {
namespace {

int index_of(const SlabTetrahedron& tet, SlabPoint v) {
  return tet.v[0] == v ? 0 : tet.v[1] == v ? 1 : tet.v[2] == v ? 2 : 3;
}

/// From tetrahedron `t` turns around edge (a, b), leaving first through the face opposite `away`; true if it comes back
/// to t.
bool turn_around(const SlabTetrahedra& tets, SlabPoint a, SlabPoint b, TetIndex t, SlabPoint away, TetList& ring) {
  const TetIndex start = t;
  for (;;) {
    const TetIndex next = tets[t].nb[index_of(tets[t], away)];
    if (next == none) return false;
    if (next == start) return true;
    // The vertex shared with the tetrahedron behind is the one to turn away from next.
    away =
        *std::find_if(tets[t].v.begin(), tets[t].v.end(), [&](SlabPoint w) { return w != a && w != b && w != away; });
    t = next;
    ring.push_back(t);
  }
}

}  // namespace

Costs costs_of(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper) {
  Costs costs;
  costs.reserve(tetrahedra.size());
  const SlabNumbers numbers(lower);
  for (const SlabTetrahedron& tet : tetrahedra) {
    const auto vector = [&](int i, int j) {
      const auto point = [&](int k) {
        return (numbers.is_lower(tet.v[k]) ? lower : upper).points[numbers.own(tet.v[k])];
      };
      return Point2{point(j).x - point(i).x, point(j).y - point(i).y};
    };
    const int first = tet.lower_count == 1 ? 1 : 0;  // the in-plane triangle's first corner
    const Point2 e = vector(first, first + 1), f = tet.lower_count == 2 ? vector(2, 3) : vector(first, first + 2);
    const double area = std::abs(e.x * f.y - e.y * f.x);
    costs.push_back(
        {area < limits::flat_share * portable::hypot(e.x, e.y) * portable::hypot(f.x, f.y) ? 1u : 0u, 1, area});
  }
  return costs;
}

Links::Links(const SlabTetrahedra& tetrahedra, std::size_t points, const Fates& fate)
    : tets_(tetrahedra),
      fate_(fate),
      star_(points,
            [this](const auto& add) {
              for (const TetIndex t : tets_.indices())
                for (const SlabPoint v : tets_[t].v) add(v, t);
            }),
      seen_vertex_(points, 0),
      seen_tet_(tetrahedra.size(), 0) {}

std::vector<Links::MixedEdge> Links::mixed_edges(SlabPoint v) {
  std::vector<MixedEdge> edges;
  ++vertex_epoch_;
  for (const TetIndex t : star_[v]) {
    if (!in(t)) continue;
    const SlabTetrahedron& tet = tets_[t];
    for (int i = 0; i < 4; ++i) {
      if (tet.v[i] == v || tet.nb[i] == none || in(tet.nb[i])) continue;
      for (const SlabPoint w : tet.v) {
        if (w == v || w == tet.v[i] || seen_vertex_[w] == vertex_epoch_) continue;
        seen_vertex_[w] = vertex_epoch_;
        edges.push_back({w, t});
      }
    }
  }
  return edges;
}

Links::Gaps Links::gaps(SlabPoint a, SlabPoint b, TetIndex t) const {
  TetList ring;
  std::array<SlabPoint, 2> others;
  int count = 0;
  for (const SlabPoint w : tets_[t].v)
    if (w != a && w != b) others[count++] = w;
  Gaps found;
  found.closed = turn_around(tets_, a, b, t, others[0], ring);
  std::reverse(ring.begin(), ring.end());
  ring.push_back(t);
  if (!found.closed) turn_around(tets_, a, b, t, others[1], ring);

  const std::size_t n = ring.size();
  std::size_t first = 0;
  while (first < n && !in(ring[first])) ++first;
  TetList run;
  for (std::size_t i = first + 1; first < n && i < n + (found.closed ? first + 1 : 0); ++i) {
    const TetIndex here = ring[i % n];
    if (!in(here)) {
      run.push_back(here);
    } else if (!run.empty()) {
      found.runs.push_back(std::move(run));
      run.clear();
    }
  }
  return found;
}

/// Adds to `seeds` what can be reached from them within v's star through faces at v, staying in that part of it, and
/// marks all of it.
void Links::flood(SlabPoint v, TetList& seeds, Part part) {
  for (const TetIndex t : seeds) seen_tet_[t] = tet_epoch_;
  for (std::size_t at = 0; at < seeds.size(); ++at) {
    const SlabTetrahedron& tet = tets_[seeds[at]];
    for (int i = 0; i < 4; ++i) {
      const TetIndex other = tet.nb[i];
      if (tet.v[i] == v || other == none || in(other) != (part == Part::kept) || seen_tet_[other] == tet_epoch_)
        continue;
      seen_tet_[other] = tet_epoch_;
      seeds.push_back(other);
    }
  }
}

std::vector<TetList> Links::fans(SlabPoint v) {
  ++tet_epoch_;
  std::vector<TetList> found;
  for (const TetIndex t : star_[v]) {
    if (!in(t) || seen_tet_[t] == tet_epoch_) continue;
    found.push_back({t});
    flood(v, found.back(), Part::kept);
  }
  return found;
}

TetList Links::shut_in(SlabPoint v) {
  ++tet_epoch_;
  TetList at_border, enclosed;
  for (const TetIndex t : star_[v]) {
    const SlabTetrahedron& tet = tets_[t];
    if (in(t)) continue;
    for (int i = 0; i < 4; ++i)
      if (tet.v[i] != v && tet.nb[i] == none) {
        at_border.push_back(t);
        break;
      }
  }
  flood(v, at_border, Part::removed);
  for (const TetIndex t : star_[v])
    if (!in(t) && seen_tet_[t] != tet_epoch_) enclosed.push_back(t);
  return enclosed;
}

bool Links::regular(SlabPoint v) {
  for (const auto& [w, t] : mixed_edges(v))
    if (gaps(v, w, t).singular()) return false;
  return fans(v).size() <= 1 && shut_in(v).empty();
}

}  // namespace odontoscope::delaunay
