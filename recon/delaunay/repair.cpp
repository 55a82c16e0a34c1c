#include <algorithm>
#include <deque>

#include "recon/core/error.h"
#include "recon/delaunay/carve.h"

namespace odontoscope::delaunay {
namespace {

/// The tetrahedra around an edge in circular order.
struct Ring {
  std::vector<std::uint32_t> tets;
  bool closed = false;   // open: its ends lie on the hull or in a slice
};

int index_of(const SlabTetrahedron& tet, std::uint32_t v) {
  return tet.v[0] == v ? 0 : tet.v[1] == v ? 1 : tet.v[2] == v ? 2 : tet.v[3] == v ? 3 : -1;
}

class Repair {
 public:
  /// `suspects`: the vertices to look at first.
  Repair(const std::vector<SlabTetrahedron>& tets, std::size_t points, const std::vector<bool>& may_restore,
         const std::vector<std::uint32_t>& suspects, std::vector<Fate>& fate)
      : tets_(tets), may_restore_(may_restore), fate_(fate), queue_(suspects.begin(), suspects.end()), queued_(points, false),
        seen_vertex_(points, 0), seen_tet_(tets.size(), 0) {
    collect_stars(points);
    for (const std::uint32_t v : suspects) queued_[v] = true;
  }

  bool run() {
    while (!queue_.empty()) {
      const std::uint32_t v = queue_.front();
      queue_.pop_front();
      queued_[v] = false;
      if (!mend(v)) return false;
    }
    prune();
    return true;
  }

 private:
  // ---- the star of a vertex, the ring of an edge ------------------------------------------------------------------

  void collect_stars(std::size_t points) {
    first_.assign(points + 1, 0);
    for (const SlabTetrahedron& tet : tets_)
      for (const std::uint32_t v : tet.v) ++first_[v + 1];
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
    star_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < tets_.size(); ++t)
      for (const std::uint32_t v : tets_[t].v) star_[fill[v]++] = t;
  }

  bool in(std::uint32_t t) const { return fate_[t] != Fate::removed; }

  /// From tetrahedron `t` turns around edge (a, b), leaving first through the face opposite `away`.
  void turn_around(std::uint32_t a, std::uint32_t b, std::uint32_t t, std::uint32_t away, Ring& ring) const {
    const std::uint32_t start = t;
    for (;;) {
      const std::uint32_t next = tets_[t].nb[index_of(tets_[t], away)];
      if (next == none) return;
      if (next == start) {
        ring.closed = true;
        return;
      }
      // The vertex shared with the tetrahedron behind is the one to turn away from next.
      for (const std::uint32_t w : tets_[t].v)
        if (w != a && w != b && w != away) {
          away = w;
          break;
        }
      t = next;
      ring.tets.push_back(t);
    }
  }

  const Ring& ring_of(std::uint32_t a, std::uint32_t b, std::uint32_t t) {
    ring_.tets.clear();
    ring_.closed = false;
    std::array<std::uint32_t, 2> others{};
    int count = 0;
    for (const std::uint32_t w : tets_[t].v)
      if (w != a && w != b) others[count++] = w;
    turn_around(a, b, t, others[0], ring_);
    if (!ring_.closed) {
      std::reverse(ring_.tets.begin(), ring_.tets.end());
      ring_.tets.push_back(t);
      turn_around(a, b, t, others[1], ring_);
    } else {
      ring_.tets.push_back(t);
    }
    return ring_;
  }

  /// The runs of removed tetrahedra between kept ones. More than one in a closed ring, or any in an open one, is a singular edge.
  std::vector<std::vector<std::uint32_t>> gaps(const Ring& ring) const {
    std::vector<std::vector<std::uint32_t>> found;
    const std::size_t n = ring.tets.size();
    std::size_t first = 0;
    while (first < n && !in(ring.tets[first])) ++first;
    if (first == n) return found;
    std::vector<std::uint32_t> run;
    for (std::size_t i = first + 1; i < n + (ring.closed ? first + 1 : 0); ++i) {
      const std::uint32_t t = ring.tets[i % n];
      if (!in(t)) {
        run.push_back(t);
      } else if (!run.empty()) {
        found.push_back(std::move(run));
        run.clear();
      }
    }
    return found;
  }

  bool singular(const Ring& ring) const { return gaps(ring).size() > (ring.closed ? 1u : 0u); }

  // ---- mending ----------------------------------------------------------------------------------------------------

  bool mend(std::uint32_t v) { return mend_edges(v) && mend_link(v); }

  /// Visits each edge at v that has both kept and removed tetrahedra around it, once, with one kept tetrahedron on it.
  template <class Visit>
  bool each_mixed_edge(std::uint32_t v, Visit visit) {
    ++edge_epoch_;
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s) {
      const std::uint32_t t = star_[s];
      if (!in(t)) continue;
      const SlabTetrahedron& tet = tets_[t];
      for (int i = 0; i < 4; ++i) {
        if (tet.v[i] == v || tet.nb[i] == none || in(tet.nb[i])) continue;
        for (const std::uint32_t w : tet.v) {
          if (w == v || w == tet.v[i] || seen_vertex_[w] == edge_epoch_) continue;
          seen_vertex_[w] = edge_epoch_;
          if (!visit(w, t)) return false;
        }
      }
    }
    return true;
  }

  bool mend_edges(std::uint32_t v) {
    return each_mixed_edge(v, [this, v](std::uint32_t w, std::uint32_t t) {
      const Ring& ring = ring_of(v, w, t);
      for (;;) {
        const auto open = gaps(ring);
        if (open.size() <= (ring.closed ? 1u : 0u)) return true;
        const std::vector<std::uint32_t>* cheapest = nullptr;
        for (const auto& gap : open) {
          const bool allowed = std::all_of(gap.begin(), gap.end(), [this](std::uint32_t g) { return may_restore_[g]; });
          if (allowed && (!cheapest || gap.size() < cheapest->size())) cheapest = &gap;
        }
        if (!cheapest) return false;
        for (const std::uint32_t g : *cheapest) restore(g);
      }
    });
  }

  void restore(std::uint32_t t) {
    fate_[t] = Fate::restored;
    restored_.push_back(t);
    for (const std::uint32_t v : tets_[t].v)
      if (!queued_[v]) {
        queued_[v] = true;
        queue_.push_back(v);
      }
  }

  /// Marks what can be reached from `seeds` within v's star through faces at v, staying on the side `kept`.
  void flood(std::uint32_t v, std::vector<std::uint32_t> seeds, bool kept) {
    for (const std::uint32_t t : seeds) seen_tet_[t] = tet_epoch_;
    while (!seeds.empty()) {
      const SlabTetrahedron& tet = tets_[seeds.back()];
      seeds.pop_back();
      for (int i = 0; i < 4; ++i) {
        const std::uint32_t other = tet.nb[i];
        if (tet.v[i] == v || other == none || in(other) != kept || seen_tet_[other] == tet_epoch_) continue;
        seen_tet_[other] = tet_epoch_;
        seeds.push_back(other);
      }
    }
  }

  /// Kept tetrahedra at v that are not connected to the first kept one.
  std::vector<std::uint32_t> cut_off(std::uint32_t v) {
    ++tet_epoch_;
    std::vector<std::uint32_t> apart;
    bool started = false;
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s) {
      const std::uint32_t t = star_[s];
      if (!in(t)) continue;
      if (!started) flood(v, {t}, true);
      started = true;
      if (seen_tet_[t] != tet_epoch_) apart.push_back(t);
    }
    return apart;
  }

  /// Removed tetrahedra at v that are shut in by kept ones: not connected to what lies beyond the hull and the slices.
  std::vector<std::uint32_t> shut_in(std::uint32_t v) {
    ++tet_epoch_;
    std::vector<std::uint32_t> at_border, enclosed;
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s) {
      const SlabTetrahedron& tet = tets_[star_[s]];
      if (in(star_[s])) continue;
      for (int i = 0; i < 4; ++i)
        if (tet.v[i] != v && tet.nb[i] == none) {
          at_border.push_back(star_[s]);
          break;
        }
    }
    flood(v, std::move(at_border), false);
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s)
      if (!in(star_[s]) && seen_tet_[star_[s]] != tet_epoch_) enclosed.push_back(star_[s]);
    return enclosed;
  }

  bool mend_link(std::uint32_t v) {
    while (!cut_off(v).empty())
      if (!join(v)) return false;
    for (const std::uint32_t t : shut_in(v)) {
      if (!may_restore_[t]) return false;
      restore(t);
    }
    return true;
  }

  /// Joins the first fan of v to another by the shortest way through removed tetrahedra of its star. Precondition: cut_off(v) was
  /// just called and is not empty, so that the first fan is marked.
  bool join(std::uint32_t v) {
    std::vector<std::pair<std::uint32_t, std::size_t>> way;   // tetrahedron, and its forerunner's place in `way`
    constexpr std::size_t start = static_cast<std::size_t>(-1);
    for (std::uint32_t s = first_[v]; s < first_[v + 1]; ++s)
      if (in(star_[s]) && seen_tet_[star_[s]] == tet_epoch_) way.emplace_back(star_[s], start);
    for (std::size_t at = 0; at < way.size(); ++at) {
      const SlabTetrahedron& tet = tets_[way[at].first];
      for (int i = 0; i < 4; ++i) {
        const std::uint32_t other = tet.nb[i];
        if (tet.v[i] == v || other == none || seen_tet_[other] == tet_epoch_) continue;
        if (in(other)) {
          for (std::size_t back = at; way[back].second != start; back = way[back].second) restore(way[back].first);
          return true;
        }
        if (!may_restore_[other]) continue;
        seen_tet_[other] = tet_epoch_;
        way.emplace_back(other, at);
      }
    }
    return false;
  }

  // ---- pruning ----------------------------------------------------------------------------------------------------

  bool regular(std::uint32_t v) {
    const bool edges = each_mixed_edge(v, [this, v](std::uint32_t w, std::uint32_t t) { return !singular(ring_of(v, w, t)); });
    return edges && cut_off(v).empty() && shut_in(v).empty();
  }

  /// What was put back early may have become needless by what was put back later.
  void prune() {
    for (bool changed = true; changed;) {
      changed = false;
      for (auto it = restored_.rbegin(); it != restored_.rend(); ++it) {
        if (fate_[*it] != Fate::restored) continue;
        fate_[*it] = Fate::removed;
        const auto& v = tets_[*it].v;
        if (std::all_of(v.begin(), v.end(), [this](std::uint32_t w) { return regular(w); })) {
          changed = true;
        } else {
          fate_[*it] = Fate::restored;
        }
      }
    }
  }

  const std::vector<SlabTetrahedron>& tets_;
  const std::vector<bool>& may_restore_;
  std::vector<Fate>& fate_;
  std::vector<std::uint32_t> first_, star_;   // tetrahedra at v: star_[first_[v]] to star_[first_[v+1]]
  std::deque<std::uint32_t> queue_;
  std::vector<bool> queued_;
  std::vector<std::uint32_t> restored_;
  std::vector<std::uint32_t> seen_vertex_, seen_tet_;
  std::uint32_t edge_epoch_ = 0, tet_epoch_ = 0;
  Ring ring_;
};

/// The faces between the kept tetrahedra and anything else, except those that lie in a region.
std::vector<std::array<std::uint32_t, 3>> interface_of(const std::vector<SlabTetrahedron>& tets, const std::vector<Fate>& fate) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::size_t t = 0; t < tets.size(); ++t) {
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

/// Vertices around which the kept tetrahedra may be singular. Around a regular one the interface is a single strip of faces, from the
/// contour edge on one side of the vertex to that on the other: then the kept part of its link is a disc. So the graph that the faces leave
/// on the vertex's neighbours is one simple path between its two contour neighbours, through points of the other slice only (a point of
/// its own slice would be the far end of an internal edge with a gap above it). Precondition: nothing is restored yet.
std::vector<std::uint32_t> suspects(const std::vector<SlabTetrahedron>& tets, const Planar& lower, const Planar& upper,
                                    const std::vector<Fate>& fate) {
  const auto faces = interface_of(tets, fate);
  const auto offset = static_cast<std::uint32_t>(lower.points.size());
  const auto points = static_cast<std::uint32_t>(lower.points.size() + upper.points.size());
  std::vector<std::uint32_t> first(points + 1, 0);
  for (const auto& face : faces)
    for (const std::uint32_t v : face) ++first[v + 1];
  for (std::uint32_t v = 0; v < points; ++v) first[v + 1] += first[v];
  std::vector<std::array<std::uint32_t, 2>> strip(first[points]);
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (const auto& face : faces)
    for (int i = 0; i < 3; ++i) strip[fill[face[i]]++] = {face[(i + 1) % 3], face[(i + 2) % 3]};

  std::vector<std::uint32_t> found, passed(points, none);
  for (std::uint32_t v = 0; v < points; ++v) {
    const std::uint32_t start = v < offset ? lower.previous[v] : offset + upper.previous[v - offset];
    const std::uint32_t end = v < offset ? lower.next[v] : offset + upper.next[v - offset];
    std::uint32_t at = start, left = first[v + 1] - first[v];
    const std::uint32_t from = first[v];
    while (left > 0 && at != end) {   // eat the strip from its start; each step takes one face out
      std::uint32_t s = from;
      while (s < from + left && strip[s][0] != at && strip[s][1] != at) ++s;
      if (s == from + left) break;
      at = strip[s][0] == at ? strip[s][1] : strip[s][0];
      std::swap(strip[s], strip[from + --left]);
      if (at != end && ((at < offset) == (v < offset) || passed[at] == v)) break;
      passed[at] = v;
    }
    if (left > 0 || at != end) found.push_back(v);
  }
  return found;
}

}  // namespace

bool repair(const std::vector<SlabTetrahedron>& tetrahedra, const Planar& lower, const Planar& upper,
            const std::vector<bool>& may_restore, std::vector<Fate>& fate) {
  const std::vector<std::uint32_t> doubtful = suspects(tetrahedra, lower, upper, fate);
  if (doubtful.empty()) return true;
  return Repair(tetrahedra, lower.points.size() + upper.points.size(), may_restore, doubtful, fate).run();
}

}  // namespace odontoscope::delaunay
