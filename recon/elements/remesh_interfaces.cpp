#include "recon/elements/remesh_interfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "recon/elements/end_heights.h"
#include "recon/elements/face_groups.h"
#include "recon/elements/interface_shape.h"
#include "recon/elements/limits.h"
#include "recon/elements/size_field.h"
#include "recon/mesh/corners.h"

namespace odontoscope::elements {
namespace {

using Ring = InterfaceWeb::Ring;
using Stratum = InterfaceWeb::Stratum;

Point3 middle_of(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

/// A face as it would be.
struct Planned {
  std::uint32_t face;  // that it replaces
  Triangle triangle;
};

class Remesher {
 public:
  Remesher(InterfaceWeb& web, double size, const Progress& progress)
      : web_(web),
        shape_(web),
        size_(size_field(web, size)),
        ends_(end_heights(web)),
        groups_(web),
        progress_(progress) {}

  void run() {
    for (int round = 0; round < limits::rounds; ++round) {
      progress_.tell("remesh", static_cast<double>(round) / limits::rounds);
      groups_ = FaceGroups(web_);
      split_long();
      groups_ = FaceGroups(web_);
      collapse_short();
      flip_all();
      smooth_all();
    }
  }

 private:
  double aimed(PointIndex a, PointIndex b) const { return std::min(size_[a], size_[b]); }
  double distance(PointIndex a, PointIndex b) const { return length(web_.points()[a] - web_.points()[b]); }
  LabelPair labels(std::uint32_t face) const { return {web_.faces()[face].inner, web_.faces()[face].outer}; }

  // Flat ends of a material keep their rim: whoever holds a tooth there in a simulation finds the nodes at the height
  // of its first or last slice.

  /// Lies in a plane in which a material begins or ends.
  bool level(std::uint32_t face) const { return is_level(web_, face, ends_); }
  bool is_rim(PointIndex a, PointIndex b) const {
    if (web_.points()[a].z != web_.points()[b].z) return false;
    const std::vector<std::uint32_t> faces = web_.faces_between(a, b);
    return faces.size() == 2 && level(faces[0]) != level(faces[1]);
  }
  Stratum stratum(PointIndex v, const Ring& ring) const {
    const Stratum own = InterfaceWeb::stratum(ring);
    const auto rims =
        std::count_if(ring.begin(), ring.end(), [&](const auto& n) { return n.on_surface() && is_rim(v, n.vertex); });
    if (rims == 0) return own;
    return rims == 2 && own == Stratum::surface ? Stratum::line : Stratum::point;
  }

  struct Edge {
    double order;  // smallest first
    PointIndex a, b;
    friend bool operator<(const Edge& s, const Edge& t) {
      return std::tie(s.order, s.a, s.b) < std::tie(t.order, t.a, t.b);
    }
  };
  template <class Order>
  std::vector<Edge> edges(Order order) const {
    std::vector<Edge> all;
    for (PointIndex v = 0; v < web_.points().size(); ++v) {
      for (const auto& n : web_.ring(v))
        if (n.vertex > v)
          if (const std::optional<double> place = order(v, n.vertex)) all.push_back({*place, v, n.vertex});
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// What a step would make, with vertex `moved` at `at`.
  Corners corners(const Triangle& t, PointIndex moved, const Point3& at) const {
    const auto place = [&](PointIndex v) { return v == moved ? at : web_.points()[v]; };
    return {place(t[0]), place(t[1]), place(t[2])};
  }
  Corners corners(std::uint32_t face) const {
    const Triangle& t = web_.faces()[face].triangle;
    return {web_.points()[t[0]], web_.points()[t[1]], web_.points()[t[2]]};
  }

  /// Do the planned faces turn little, stay near the surface, and meet no other face? Those that they replace, and
  /// `gone`, are not looked at.
  bool fits(const std::vector<Planned>& planned, const std::vector<std::uint32_t>& gone, PointIndex moved,
            const Point3& at, double allowed) const {
    for (const Planned& plan : planned) {
      const Corners made = corners(plan.triangle, moved, at), was = corners(plan.face);
      const Direction is = normal_of(made), before = normal_of(was);
      if (!(dot(is, before) > limits::turned_cosine * length(is) * length(before)) && dot(before, before) > 0)
        return false;
      if (off_the_surface(made, labels(plan.face)) > allowed) return false;
    }
    std::vector<NumberedTriangle> triangles;
    std::vector<std::uint32_t> without = gone;
    for (const Planned& plan : planned) {
      triangles.push_back(numbered(plan.triangle, corners(plan.triangle, moved, at)));
      without.push_back(plan.face);
    }
    return groups_.fit(triangles, without);
  }

  double off_the_surface(const Corners& face, const LabelPair& sides) const {
    const Point3 middle = middle_of(face);
    double most = shape_.on_faces(sides, middle).distance;
    for (int i = 0; i < 3; ++i)
      most = std::max(most, shape_.on_faces(sides, middle_of(face[i], face[(i + 1) % 3])).distance);
    return most;
  }

  double worst_quality(const std::vector<std::uint32_t>& faces) const {
    double worst = 1;
    for (const std::uint32_t f : faces) worst = std::min(worst, quality_of(corners(f)));
    return worst;
  }
  double worst_quality(const std::vector<Planned>& planned, PointIndex moved, const Point3& at) const {
    double worst = 1;
    for (const Planned& plan : planned) worst = std::min(worst, quality_of(corners(plan.triangle, moved, at)));
    return worst;
  }

  // --- splitting

  void split_long() {
    const auto too_long = [&](PointIndex a, PointIndex b) -> std::optional<double> {
      const double l = distance(a, b);
      if (l <= limits::longest * aimed(a, b)) return std::nullopt;
      return -l;
    };
    for (const Edge& edge : edges(too_long)) split(edge.a, edge.b);
  }

  void split(PointIndex a, PointIndex b) {
    progress_.check();
    const Point3 at = middle_of(web_.points()[a], web_.points()[b]);
    const auto made = static_cast<PointIndex>(web_.points().size());
    std::vector<NumberedTriangle> halves;
    const std::vector<std::uint32_t> faces = web_.faces_between(a, b);
    for (const std::uint32_t f : faces) {
      for (const PointIndex end : {a, b}) {
        Triangle half = web_.faces()[f].triangle;
        std::replace(half.begin(), half.end(), end, made);
        halves.push_back(numbered(half, corners(half, made, at)));
      }
    }
    if (!groups_.fit(halves, faces)) return;  // two sheets are so close that rounding would let them touch
    const auto first_new = static_cast<std::uint32_t>(web_.faces().size());
    web_.split(a, b, at);
    size_.push_back((size_[a] + size_[b]) / 2);
    for (std::size_t n = 0; n < faces.size(); ++n)
      groups_.join(first_new + static_cast<std::uint32_t>(n), faces[n], web_);
    for (const std::uint32_t f : faces) groups_.update(f, web_);
  }

  // --- collapsing

  void collapse_short() {
    const auto too_short = [&](PointIndex a, PointIndex b) -> std::optional<double> {
      const double l = distance(a, b), least = limits::shortest * aimed(a, b);
      if (l >= least) return std::nullopt;
      return l / least;
    };
    for (const Edge& edge : edges(too_short)) {
      // Others have moved its ends meanwhile, or taken one away.
      if (web_.faces_between(edge.a, edge.b).empty() || !too_short(edge.a, edge.b)) continue;
      collapse(edge.a, edge.b);
    }
  }

  bool collapse(PointIndex a, PointIndex b) {
    progress_.check();
    const Ring ring_a = web_.ring(a), ring_b = web_.ring(b);
    if (!web_.keeps_topology(ring_a, b, ring_b)) return false;
    const Stratum of_a = stratum(a, ring_a), of_b = stratum(b, ring_b);
    const bool rim = is_rim(a, b), along_line = rim || InterfaceWeb::triangles_between(ring_a, b) != 2;
    if (!along_line && of_a != Stratum::surface && of_b != Stratum::surface) return false;  // two lines would meet
    if (of_a == Stratum::point && of_b == Stratum::point) return false;
    if (rim && closes_a_rim(a, ring_a, b)) return false;
    if (of_b > of_a) return collapse_to(b, a, web_.points()[b]);
    if (of_a > of_b || of_a == Stratum::point) return collapse_to(a, b, web_.points()[a]);
    const Point3 middle = middle_of(web_.points()[a], web_.points()[b]);
    const Point3 at = rim                        ? middle
                      : of_a == Stratum::surface ? shape_.on_faces(labels(web_.faces_of(a)[0]), middle).at
                                                 : shape_.on_lines(junction_kind(web_, a, b), middle).at;
    return collapse_to(a, b, at) || collapse_to(a, b, web_.points()[a]) || collapse_to(b, a, web_.points()[b]);
  }

  /// A rim of three edges has nothing to spare.
  bool closes_a_rim(PointIndex a, const Ring& ring_a, PointIndex b) const {
    return std::any_of(ring_a.begin(), ring_a.end(),
                       [&](const auto& n) { return n.vertex != b && is_rim(a, n.vertex) && is_rim(b, n.vertex); });
  }

  bool collapse_to(PointIndex kept, PointIndex gone, const Point3& at) {
    const double aim = aimed(kept, gone), allowed = limits::astray * aim;
    const std::vector<std::uint32_t> vanish = web_.faces_between(kept, gone);
    std::vector<Planned> planned;
    std::vector<std::uint32_t> old;
    for (const PointIndex v : {kept, gone}) {
      for (const std::uint32_t f : web_.faces_of(v)) {
        old.push_back(f);
        if (std::binary_search(vanish.begin(), vanish.end(), f)) continue;
        Triangle t = web_.faces()[f].triangle;
        std::replace(t.begin(), t.end(), gone, kept);
        planned.push_back({f, t});
      }
    }
    for (const PointIndex v : {kept, gone}) {
      for (const auto& n : web_.ring(v))
        if (length(web_.points()[n.vertex] - at) >
                std::max(limits::longest * std::min(aim, size_[n.vertex]), distance(v, n.vertex)) &&
            n.vertex != kept && n.vertex != gone)
          return false;
    }
    if (worst_quality(planned, kept, at) < std::min(limits::least_quality, worst_quality(old))) return false;
    if (left_behind(planned, kept, at, web_.points()[gone]) > allowed ||
        left_behind(planned, kept, at, web_.points()[kept]) > allowed)
      return false;
    if (!fits(planned, vanish, kept, at, allowed)) return false;
    web_.collapse(kept, gone, at);
    size_[kept] = aim;
    for (const std::uint32_t f : vanish) groups_.update(f, web_);
    for (const std::uint32_t f : web_.faces_of(kept)) groups_.update(f, web_);
    return true;
  }

  /// From a vertex that was there to the faces that would be.
  double left_behind(const std::vector<Planned>& planned, PointIndex moved, const Point3& at,
                     const Point3& from) const {
    double least = length(from - at);
    for (const Planned& plan : planned) least = std::min(least, distance_to(corners(plan.triangle, moved, at), from));
    return least;
  }

  // --- flipping

  void flip_all() {
    const auto worst_first = [&](PointIndex a, PointIndex b) -> std::optional<double> {
      const std::vector<std::uint32_t> faces = web_.faces_between(a, b);
      if (faces.size() != 2) return std::nullopt;
      const double worst = worst_quality(faces);
      if (worst >= 0.95) return std::nullopt;
      return worst;
    };
    for (const Edge& edge : edges(worst_first)) flip(edge.a, edge.b);
  }

  void flip(PointIndex a, PointIndex b) {
    progress_.check();
    const std::vector<std::uint32_t> faces = web_.faces_between(a, b);
    if (faces.size() != 2 || level(faces[0]) != level(faces[1])) return;  // another flip was here; or a rim
    const auto opposite = [&](std::uint32_t f) {
      const Triangle& t = web_.faces()[f].triangle;
      return *std::find_if(t.begin(), t.end(), [&](PointIndex v) { return v != a && v != b; });
    };
    const PointIndex c = opposite(faces[0]), d = opposite(faces[1]);
    if (!web_.faces_between(c, d).empty()) return;
    std::vector<Planned> planned{{faces[0], web_.faces()[faces[0]].triangle},
                                 {faces[1], web_.faces()[faces[1]].triangle}};
    std::replace(planned[0].triangle.begin(), planned[0].triangle.end(), b, d);
    std::replace(planned[1].triangle.begin(), planned[1].triangle.end(), a, c);
    if (worst_quality(planned, a, web_.points()[a]) < worst_quality(faces) + limits::least_gain) return;
    if (!fits(planned, {}, a, web_.points()[a], limits::astray * aimed(a, b))) return;
    web_.flip(a, b);
    for (const std::uint32_t f : faces) groups_.update(f, web_);
  }

  // --- moving

  void smooth_all() {
    for (PointIndex v = 0; v < web_.points().size(); ++v) {
      const auto faces = web_.faces_of(v);
      if (faces.empty()) continue;
      progress_.check();
      const Ring ring = web_.ring(v);
      const Stratum own = stratum(v, ring);
      if (own == Stratum::surface) move(v, keeping_volume(v, shape_.on_faces(labels(faces[0]), middle_of_star(v)).at));
      if (own == Stratum::line && InterfaceWeb::stratum(ring) == Stratum::line) move(v, on_line(v, ring));
    }
  }

  Point3 middle_of_star(PointIndex v) const {
    double whole = 0;
    Direction sum;
    const Point3& own = web_.points()[v];
    for (const std::uint32_t f : web_.faces_of(v)) {
      const Corners face = corners(f);
      const double area = length(normal_of(face));
      const Direction off = (1.0 / 3) * ((face[0] - own) + (face[1] - own) + (face[2] - own));
      whole += area;
      sum = sum + area * off;
    }
    if (!(whole > 0)) return own;
    const Direction off = (1 / whole) * sum;
    return {own.x + off.x, own.y + off.y, own.z + off.z};
  }

  /// Vertices on a bent surface have their triangles inside of it, and a thin pulp would lose a tenth: they are put off
  /// it by as much as the triangles would be, on average.
  Point3 keeping_volume(PointIndex v, const Point3& on_surface) const {
    double off = 0, whole = 0;
    Direction normals;
    for (const std::uint32_t f : web_.faces_of(v)) {
      const Corners face = corners(web_.faces()[f].triangle, v, on_surface);
      const Direction normal = normal_of(face);
      const double area = length(normal);
      if (!(area > 0)) continue;
      const Point3 middle = middle_of(face);
      off += dot(shape_.on_faces(labels(f), middle).at - middle, normal);
      whole += area;
      normals = normals + normal;
    }
    const double l = length(normals);
    if (!(whole > 0) || !(l > 0)) return on_surface;
    const Direction shift = (limits::volume_shift * off / (whole * l)) * normals;
    return {on_surface.x + shift.x, on_surface.y + shift.y, on_surface.z + shift.z};
  }

  Point3 on_line(PointIndex v, const Ring& ring) const {
    std::vector<PointIndex> along;
    for (const auto& n : ring)
      if (!n.on_surface()) along.push_back(n.vertex);
    return shape_
        .on_lines(junction_kind(web_, v, along[0]), middle_of(web_.points()[along[0]], web_.points()[along[1]]))
        .at;
  }

  void move(PointIndex v, const Point3& target) {
    const std::vector<std::uint32_t> faces(web_.faces_of(v).begin(), web_.faces_of(v).end());
    const double before = worst_quality(faces);
    std::vector<Planned> planned;
    for (const std::uint32_t f : faces) planned.push_back({f, web_.faces()[f].triangle});
    Point3 at = target;
    for (int halving = 0; halving < 3; ++halving, at = middle_of(at, web_.points()[v])) {
      if (worst_quality(planned, v, at) < std::min(before, limits::good_quality)) continue;
      const double allowed = limits::astray * size_[v];
      if (left_behind(planned, v, at, web_.points()[v]) > allowed || !fits(planned, {}, v, at, allowed)) continue;
      web_.move(v, at);
      for (const std::uint32_t f : faces) groups_.update(f, web_);
      return;
    }
  }

  InterfaceWeb& web_;
  const InterfaceShape shape_;
  std::vector<double> size_;        // of edges, at each vertex
  const std::vector<double> ends_;  // heights at which a material begins or ends
  FaceGroups groups_;
  const Progress& progress_;
};

}  // namespace

void remesh_interfaces(InterfaceWeb& web, double size, const Progress& progress) {
  Remesher(web, size, progress).run();
}

}  // namespace odontoscope::elements
