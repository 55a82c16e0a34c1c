#include "recon/mesh/collapse_interfaces.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>

#include "recon/mesh/collapse_quadric.h"
#include "recon/mesh/collapse_star.h"

namespace odontoscope {
namespace {

using Stratum = InterfaceWeb::Stratum;
using ExactPoint = ExactKernel::Point_3;

std::size_t sides(const InterfaceTriangle& face) { return face.outer == void_label ? 1 : 2; }

ExactPoint exact(const Point3& p) { return {p.x, p.y, p.z}; }
Point3 middle_of(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

NumberedTriangle numbered(const InterfaceWeb& web, const Triangle& t) {
  const auto& points = web.points();
  return {{t[0], t[1], t[2]}, {exact(points[t[0]]), exact(points[t[1]]), exact(points[t[2]])}};
}

std::vector<MovingBox> boxes_of(const InterfaceWeb& web) {
  std::vector<MovingBox> boxes;
  for (const InterfaceTriangle& face : web.faces()) boxes.push_back(box_of(numbered(web, face.triangle)));
  return boxes;
}

struct Candidate {
  double cost;
  PointIndex a, b;      // a < b
  std::uint32_t stamp;  // of both
  friend bool operator<(const Candidate& s, const Candidate& t) {
    return std::tie(s.cost, s.a, s.b) > std::tie(t.cost, t.a, t.b);
  }  // cheapest on top
};

/// Where an edge may go: the best place first. `bound`: to one of its vertices, which must stay where it is.
struct Placed {
  Point3 best;
  double cost;
  bool bound;
  bool to_b = false;  // then it is the second one
};

class InterfaceCollapse {
 public:
  InterfaceCollapse(InterfaceWeb& web, const std::vector<char>& keep, std::size_t aim, const Progress& progress)
      : web_(web),
        keep_(keep),
        tree_(boxes_of(web)),
        stamps_(web.points().size(), 0),
        aim_(aim),
        progress_(progress),
        left_(triangles_of_surfaces(web.faces())),
        first_(left_) {}

  SimplifiedSurfaces::Obstacles run() {
    SimplifiedSurfaces::Obstacles obstacles;
    for (const bool elsewhere : {false, true}) {
      if (left_ <= aim_) break;
      obstacles = round(elsewhere);
    }
    return obstacles;
  }

 private:
  /// The cheapest edge first, until the aim is reached or all that is left was refused. `elsewhere`: the middle and the
  /// ends of an edge are tried, too.
  SimplifiedSurfaces::Obstacles round(bool elsewhere) {
    SimplifiedSurfaces::Obstacles obstacles;
    queue_ = {};
    for (PointIndex v = 0; v < web_.points().size(); ++v) push_edges(v, true);
    while (left_ > aim_ && !queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (next.stamp != stamp(next.a, next.b)) continue;
      tell();
      const InterfaceWeb::Ring ring_a = web_.ring(next.a), ring_b = web_.ring(next.b);
      if (!web_.keeps_topology(ring_a, next.b, ring_b)) {
        ++obstacles.topology;
        continue;
      }
      const Placed placed = place(next.a, ring_a, next.b, ring_b);
      std::optional<CollapseRefusal> refusal;
      if (const auto at = allowed(next.a, next.b, placed, elsewhere, refusal)) {
        // The vertex of the lesser stratum goes, so that what is left lies on all surfaces that met there.
        if (placed.to_b)
          collapse(next.b, next.a, *at);
        else
          collapse(next.a, next.b, *at);
      } else {
        ++(refusal == CollapseRefusal::cuts ? obstacles.cuts : obstacles.shape);
      }
    }
    return obstacles;
  }

  std::uint32_t stamp(PointIndex a, PointIndex b) const { return stamps_[a] + stamps_[b]; }

  void tell() {
    constexpr std::size_t pause = 1000;
    if (++calls_ % pause != 0) return;
    const double all = static_cast<double>(first_) - static_cast<double>(aim_);
    progress_.tell(
        "simplify",
        all > 0 ? std::clamp((static_cast<double>(first_) - static_cast<double>(left_)) / all, 0.0, 1.0) : 1.0);
  }

  /// Edges of a vertex; only those to higher ones if `upward`.
  void push_edges(PointIndex v, bool upward) {
    const InterfaceWeb::Ring ring = web_.ring(v);
    for (const InterfaceWeb::Neighbour& n : ring) {
      if (upward && n.vertex < v) continue;
      push(v, ring, n.vertex, web_.ring(n.vertex));
    }
  }

  void push(PointIndex v, const InterfaceWeb::Ring& ring_v, PointIndex w, const InterfaceWeb::Ring& ring_w) {
    if (keep_[v] && keep_[w]) return;
    const bool ordered = v < w;
    const PointIndex a = ordered ? v : w, b = ordered ? w : v;
    const Placed placed = ordered ? place(a, ring_v, b, ring_w) : place(a, ring_w, b, ring_v);
    queue_.push({placed.cost, a, b, stamp(a, b)});
  }

  Placed place(PointIndex a, const InterfaceWeb::Ring& ring_a, PointIndex b, const InterfaceWeb::Ring& ring_b) const {
    const auto& points = web_.points();
    const Point3 middle = middle_of(points[a], points[b]);
    const auto from_middle = [&](PointIndex v) { return points[v] - middle; };
    const Direction along = points[b] - points[a];
    CollapseQuadric quadric;
    const auto add_triangle = [&](std::uint32_t f) {
      const Triangle& t = web_.faces()[f].triangle;
      quadric.add_triangle(from_middle(t[0]), from_middle(t[1]), from_middle(t[2]));
    };
    for (const std::uint32_t f : web_.faces_of(a)) add_triangle(f);
    for (const std::uint32_t f : web_.faces_of(b)) {
      const Triangle& t = web_.faces()[f].triangle;
      if (std::find(t.begin(), t.end(), a) == t.end()) add_triangle(f);
    }
    const double square = dot(along, along);
    for (const auto& n : ring_a)
      if (!n.on_surface()) quadric.add_line(from_middle(a), from_middle(n.vertex), square);
    for (const auto& n : ring_b)
      if (!n.on_surface() && n.vertex != a) quadric.add_line(from_middle(b), from_middle(n.vertex), square);

    const auto stratum = [&](PointIndex v, const InterfaceWeb::Ring& ring) {
      return keep_[v] ? Stratum::point : InterfaceWeb::stratum(ring);
    };
    const Stratum of_a = stratum(a, ring_a), of_b = stratum(b, ring_b);
    const auto at_end = [&](PointIndex v) { return Placed{points[v], quadric.cost(from_middle(v)), true, v == b}; };
    if (of_a > of_b) return at_end(a);
    if (of_b > of_a || of_a == Stratum::point) return at_end(b);
    const Direction best = quadric.best(of_a == Stratum::surface);
    return {{middle.x + best.x, middle.y + best.y, middle.z + best.z}, quadric.cost(best), false};
  }

  CollapseStar star_of(PointIndex a, PointIndex b) const {
    CollapseStar star{a, b, exact(web_.points()[a]), exact(web_.points()[b]), {}};
    const auto add = [&](PointIndex moved, PointIndex without) {
      for (const std::uint32_t f : web_.faces_of(moved)) {
        Triangle t = web_.faces()[f].triangle;
        if (std::find(t.begin(), t.end(), without) != t.end()) continue;
        std::rotate(t.begin(), std::find(t.begin(), t.end(), moved), t.end());
        star.triangles.push_back(numbered(web_, {t[2], t[0], t[1]}));
      }
    };
    add(a, b);
    add(b, a);
    return star;
  }

  /// The first place that nothing speaks against; `refusal` says what spoke against the best.
  std::optional<Point3> allowed(PointIndex a, PointIndex b, const Placed& placed, bool elsewhere,
                                std::optional<CollapseRefusal>& refusal) const {
    const CollapseStar star = star_of(a, b);
    const Point3 &one = web_.points()[a], &other = web_.points()[b];
    std::vector<Point3> places{placed.best};
    if (elsewhere && !placed.bound) places.insert(places.end(), {middle_of(one, other), one, other});
    for (const Point3& at : places) {
      std::optional<CollapseRefusal> spoken = star.refusal(exact(at), CollapseStar::Turning::refused);
      if (!spoken && cuts(star, exact(at))) spoken = CollapseRefusal::cuts;
      if (!spoken) return at;
      if (!refusal) refusal = spoken;
    }
    return std::nullopt;
  }

  bool cuts(const CollapseStar& star, const ExactPoint& placed) const {
    const auto triangle = [&](std::uint32_t f) { return numbered(web_, web_.faces()[f].triangle); };
    return cuts_others(star, placed, tree_, triangle, [](const NumberedTriangle&) { return true; });
  }

  void collapse(PointIndex a, PointIndex b, const Point3& at) {
    for (const std::uint32_t f : web_.faces_of(b)) {
      const Triangle& t = web_.faces()[f].triangle;
      if (std::find(t.begin(), t.end(), a) != t.end()) left_ -= sides(web_.faces()[f]);
    }
    for (const std::uint32_t f : web_.collapse(a, b, at)) tree_.move(f, {});
    for (const std::uint32_t f : web_.faces_of(a)) tree_.move(f, box_of(numbered(web_, web_.faces()[f].triangle)));
    stamps_[a] += stamps_[b] + 1;  // more than before, whichever was looked at
    const InterfaceWeb::Ring ring = web_.ring(a);
    for (const auto& n : ring) ++stamps_[n.vertex];
    // What surrounds the neighbours' edges has changed as well.
    std::vector<PointIndex> done{a};
    push_edges(a, false);
    for (const auto& n : ring) {
      const InterfaceWeb::Ring own = web_.ring(n.vertex);
      for (const auto& m : own)
        if (std::find(done.begin(), done.end(), m.vertex) == done.end())
          push(n.vertex, own, m.vertex, web_.ring(m.vertex));
      done.push_back(n.vertex);
    }
  }

  InterfaceWeb& web_;
  const std::vector<char>& keep_;
  MovingBoxTree tree_;
  std::priority_queue<Candidate> queue_;
  std::vector<std::uint32_t> stamps_;  // grows when a vertex or what surrounds it changes
  const std::size_t aim_;
  const Progress& progress_;
  std::size_t left_;
  const std::size_t first_;
  std::size_t calls_ = 0;
};

}  // namespace

std::size_t triangles_of_surfaces(const std::vector<InterfaceTriangle>& faces) {
  std::size_t count = 0;
  for (const InterfaceTriangle& face : faces)
    if (face.inner != void_label) count += sides(face);
  return count;
}

SimplifiedSurfaces::Obstacles collapse_interfaces(InterfaceWeb& web, const std::vector<char>& keep,
                                                  std::size_t triangles, const Progress& progress) {
  return InterfaceCollapse(web, keep, triangles, progress).run();
}

}  // namespace odontoscope
