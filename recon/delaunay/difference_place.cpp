#include "recon/delaunay/difference_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <unordered_map>

#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"

namespace odontoscope::delaunay {
namespace {

Point3 difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

double determinant(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

double six_volumes(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return determinant(difference(b, a), difference(c, a), difference(d, a));
}

double length(const Point3& a, const Point3& b) { return portable::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

Point3 middle(const std::vector<Point3>& points) {
  Point3 sum;
  for (const Point3& p : points) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  const double n = static_cast<double>(std::max<std::size_t>(points.size(), 1));
  return {sum.x / n, sum.y / n, sum.z / n};
}

/// Groups of simplices that are joined by corners, in the order of their first.
template <class Simplex>
std::vector<std::vector<Simplex>> connected_groups(const std::vector<Simplex>& simplices) {
  std::unordered_map<PointIndex, std::uint32_t> number;
  for (const Simplex& simplex : simplices)
    for (const PointIndex v : simplex) number.emplace(v, static_cast<std::uint32_t>(number.size()));
  UnionFind joined(number.size());
  for (const Simplex& simplex : simplices)
    for (const PointIndex v : simplex) joined.join(number[simplex[0]], number[v]);
  std::map<std::uint32_t, std::size_t> group_of;
  std::vector<std::vector<Simplex>> groups;
  for (const Simplex& simplex : simplices) {
    const auto [at, added] = group_of.try_emplace(joined.find(number[simplex[0]]), groups.size());
    if (added) groups.emplace_back();
    groups[at->second].push_back(simplex);
  }
  return groups;
}

/// Loops of one closed surface that no disc of it bounds: two for each handle, short ones.
class Loops {
 public:
  Loops(const std::vector<Point3>& points, const std::vector<Triangle>& surface) {
    std::unordered_map<PointIndex, std::uint32_t> number;
    for (const Triangle& triangle : surface)
      for (const PointIndex v : triangle)
        if (number.emplace(v, static_cast<std::uint32_t>(at_.size())).second) at_.push_back(points[v]);
    around_.resize(at_.size());
    for (std::uint32_t t = 0; t < surface.size(); ++t)
      for (int i = 0; i < 3; ++i) add_side(number[surface[t][i]], number[surface[t][(i + 1) % 3]], t);
    faces_ = surface.size();
  }

  /// From a tree of shortest ways; the loops are the edges that neither it nor the tallest tree of faces beside it
  /// crosses.
  std::vector<std::vector<std::uint32_t>> from(std::uint32_t root) {
    grow_tree(root);
    std::vector<std::pair<double, std::uint32_t>>
        rest;  // by the length of the loop that the edge closes, longest first
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [a, b] = edges_[e].ends;
      if (parent_edge_[a] != e && parent_edge_[b] != e)
        rest.emplace_back(-(far_[a] + far_[b] + length(at_[a], at_[b])), e);
    }
    std::sort(rest.begin(), rest.end());
    UnionFind joined(faces_);
    std::vector<std::vector<std::uint32_t>> loops;
    for (const auto& [minus_length, e] : rest) {
      const auto [one, other] = edges_[e].faces;
      if (joined.find(one) == joined.find(other))
        loops.push_back(closed_by(e));
      else
        joined.join(one, other);
    }
    return loops;
  }

  std::uint32_t corners() const { return static_cast<std::uint32_t>(at_.size()); }

  std::vector<Point3> places(const std::vector<std::uint32_t>& corners) const {
    std::vector<Point3> places;
    for (const std::uint32_t v : corners) places.push_back(at_[v]);
    return places;
  }

 private:
  struct Edge {
    std::array<std::uint32_t, 2> ends{};
    std::array<std::uint32_t, 2> faces{};
  };

  void add_side(std::uint32_t a, std::uint32_t b, std::uint32_t face) {
    const std::uint64_t key = (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
    const auto [known, added] = edge_of_.try_emplace(key, static_cast<std::uint32_t>(edges_.size()));
    if (!added) {
      edges_[known->second].faces[1] = face;
      return;
    }
    edges_.push_back({{a, b}, {face, face}});
    around_[a].push_back(known->second);
    around_[b].push_back(known->second);
  }

  void grow_tree(std::uint32_t root) {
    constexpr double unreached = std::numeric_limits<double>::infinity();
    far_.assign(at_.size(), unreached);
    parent_edge_.assign(at_.size(), none);
    using Step = std::pair<double, std::uint32_t>;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> waiting;
    far_[root] = 0;
    waiting.emplace(0.0, root);
    while (!waiting.empty()) {
      const auto [way, v] = waiting.top();
      waiting.pop();
      if (way > far_[v]) continue;
      for (const std::uint32_t e : around_[v]) {
        const std::uint32_t w = other_end(e, v);
        const double longer = way + length(at_[v], at_[w]);
        if (!(longer < far_[w])) continue;
        far_[w] = longer;
        parent_edge_[w] = e;
        waiting.emplace(longer, w);
      }
    }
  }

  std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const {
    return edges_[e].ends[0] == v ? edges_[e].ends[1] : edges_[e].ends[0];
  }

  std::vector<std::uint32_t> to_root(std::uint32_t v) const {
    std::vector<std::uint32_t> way{v};
    while (parent_edge_[v] != none) way.push_back(v = other_end(parent_edge_[v], v));
    return way;
  }

  std::vector<std::uint32_t> closed_by(std::uint32_t e) const {
    std::vector<std::uint32_t> one = to_root(edges_[e].ends[0]), other = to_root(edges_[e].ends[1]);
    while (one.size() > 1 && other.size() > 1 && one[one.size() - 2] == other[other.size() - 2]) {
      one.pop_back();
      other.pop_back();
    }
    for (std::size_t i = other.size() - 1; i-- > 0;) one.push_back(other[i]);
    return one;
  }

  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<Point3> at_;
  std::vector<Edge> edges_;
  std::unordered_map<std::uint64_t, std::uint32_t> edge_of_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<double> far_;
  std::vector<std::uint32_t> parent_edge_;
  std::size_t faces_ = 0;
};

double length(const std::vector<Point3>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += length(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

bool in_solid(const SlabShape& slab, const Point3& p) {
  return std::any_of(slab.tetrahedra.begin(), slab.tetrahedra.end(), [&](const Tetrahedron& tet) {
    const auto at = [&](int i) { return slab.points[tet[i]]; };
    return std::all_of(std::begin(outward_face), std::end(outward_face),
                       [&](const auto& f) { return six_volumes(at(f[0]), at(f[2]), at(f[1]), p) >= 0; });
  });
}

/// With void in its middle, and round no hole of a slice: round a tunnel, or a window, that is not implied.
bool goes_round_a_tunnel(const SlabShape& slab, const std::vector<Point3>& loop) {
  Polygon from_above;
  for (const Point3& p : loop) from_above.push_back({p.x, p.y});
  const auto round_it = [&](const Polygon& hole) { return winding(from_above, centroid(hole)) != 0; };
  if (std::any_of(slab.holes.begin(), slab.holes.end(), round_it)) return false;
  return !in_solid(slab, middle(loop));  // round material: the wall of any ring has such a loop
}

std::optional<Point3> middle_of_tunnel(const SlabShape& slab) {
  std::optional<Point3> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& surface : connected_groups(slab.boundary)) {
    Loops loops(slab.points, surface);
    // A loop is the shorter the nearer to it its tree begins: many trees where they are cheap, then some from the best
    // loop's own corners.
    constexpr std::uint32_t least_roots = 8, corners_in_all = 200'000, next_roots = 4, rounds = 4;
    const std::uint32_t first_roots =
        std::min(loops.corners(), std::max(least_roots, corners_in_all / loops.corners()));
    std::vector<std::uint32_t> roots;
    for (std::uint64_t i = 0; i < first_roots; ++i)
      roots.push_back(static_cast<std::uint32_t>(i * loops.corners() / first_roots));
    for (std::uint32_t round = 0; round < rounds && !roots.empty(); ++round) {
      std::vector<std::uint32_t> shorter;  // corners of the best loop so far, if this round found it
      for (const std::uint32_t root : roots)
        for (const std::vector<std::uint32_t>& corners : loops.from(root)) {
          const std::vector<Point3> loop = loops.places(corners);
          const double around = length(loop);
          if (!(around < least) || !goes_round_a_tunnel(slab, loop)) continue;
          least = around;
          best = middle(loop);
          shorter = corners;
        }
      roots.clear();
      for (std::uint32_t i = 0; i < next_roots && !shorter.empty(); ++i)
        roots.push_back(shorter[i * shorter.size() / next_roots]);
    }
  }
  return best;
}

std::optional<Point3> middle_of_bubble(const SlabShape& slab) {
  for (const auto& surface : connected_groups(slab.boundary)) {
    double volume = 0;
    const Point3 origin = slab.points[surface.front()[0]];
    std::vector<Point3> corners;
    for (const Triangle& t : surface) {
      volume += six_volumes(origin, slab.points[t[0]], slab.points[t[1]], slab.points[t[2]]);
      for (const PointIndex v : t) corners.push_back(slab.points[v]);
    }
    if (volume < 0) return middle(corners);
  }
  return std::nullopt;
}

Point3 middle_of_smallest_piece(const SlabShape& slab) {
  Mass least;
  bool any = false;
  for (const auto& piece : connected_groups(slab.tetrahedra)) {
    const Mass mass = mass_of(slab.points, piece);
    if (any && mass.volume >= least.volume) continue;
    least = mass;
    any = true;
  }
  return least.centre;
}

}  // namespace

std::vector<Polygon> holes_beside(const ContourStack& stack, std::size_t slab, const std::string& structure) {
  std::vector<Polygon> holes;
  for (const std::size_t k : {slab, slab + 1})
    for (const Contour& contour : stack.slices[k].contours)
      if (contour.structure == structure && signed_area(contour.points) < 0) holes.push_back(contour.points);
  return holes;
}

Mass mass_of(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra) {
  Mass mass;
  Point3 sum;
  for (const Tetrahedron& tet : tetrahedra) {
    const double volume = six_volumes(points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]) / 6;
    const Point3 centre = middle(std::vector<Point3>{points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]});
    mass.volume += volume;
    sum = {sum.x + volume * centre.x, sum.y + volume * centre.y, sum.z + volume * centre.z};
  }
  if (mass.volume > 0) mass.centre = {sum.x / mass.volume, sum.y / mass.volume, sum.z / mass.volume};
  return mass;
}

Point3 place_of_difference(const SlabShape& slab, const Topology& implied, const Topology& found) {
  if (found.bubbles > implied.bubbles)
    if (const auto place = middle_of_bubble(slab)) return *place;
  if (found.pieces > implied.pieces) return middle_of_smallest_piece(slab);
  if (found.handles > implied.handles)
    if (const auto place = middle_of_tunnel(slab)) return *place;
  Point3 place = mass_of(slab.points, slab.tetrahedra).centre;
  const auto smallest = std::min_element(slab.holes.begin(), slab.holes.end(), [](const Polygon& a, const Polygon& b) {
    return std::abs(signed_area(a)) < std::abs(signed_area(b));
  });
  if (found.handles < implied.handles && smallest != slab.holes.end()) {
    const Point2 at = centroid(*smallest);
    place = {at.x, at.y, place.z};
  }
  return place;
}

}  // namespace odontoscope::delaunay
