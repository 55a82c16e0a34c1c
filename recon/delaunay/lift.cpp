#include "recon/delaunay/lift.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/overhang.h"
#include "recon/delaunay/predicates.h"

namespace odontoscope::delaunay {
namespace {

struct Piece {
  std::array<SlabPoint, 4> v;  // those on the slices, then those that lifting adds
  bool in;                     // part of the solid
  float reach;
};

using PieceIndex = Index<struct PieceKind>;
using SplitEdge = std::array<SlabPoint, 2>;
using Star = std::vector<PieceIndex>;

class Lift {
 public:
  Lift(const SlabTetrahedra& tets, const Fates& fate, const Planar& lower, const Planar& upper, SlabHeights heights)
      : lower_(lower), upper_(upper), heights_(heights), numbers_(lower) {
    points_.reserve(lower.points.size() + upper.points.size());
    for (const Point2 p : lower.points) points_.push_back({p.x, p.y, heights.lower});
    for (const Point2 p : upper.points) points_.push_back({p.x, p.y, heights.upper});
    for (const TetIndex t : tets.indices()) {
      const bool in = fate[t] != Fate::removed;
      pieces_.push_back({tets[t].v, in, in ? static_cast<float>(reach(tets[t], lower, upper)) : 0.0f});
      if (fate[t] == Fate::restored) collect_external(tets[t]);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  bool run() {
    if (!edges_.empty() || !faces_.empty()) collect_stars();
    for (const SplitEdge& edge : edges_)
      if (!lift_edge(edge)) return false;
    for (const auto& face : faces_)
      if (!lift_face(face)) return false;
    return true;
  }

  const Table<PieceIndex, Piece>& pieces() const { return pieces_; }
  const Table<SlabPoint, Point3>& points() const { return points_; }
  double largest_sideways() const { return largest_sideways_; }

 private:
  // ---- what has to leave the plane ----------------------------------------------------------------------------------

  void collect_external(const SlabTetrahedron& tet) {
    if (tet.lower_count == 2) {
      if (tet.lower_edge == EdgeKind::external) edges_.push_back(sorted(tet.v[0], tet.v[1]));
      if (tet.upper_edge == EdgeKind::external) edges_.push_back(sorted(tet.v[2], tet.v[3]));
      return;
    }
    const bool below = tet.lower_count == 3;
    const Planar& slice = below ? lower_ : upper_;
    if (slice.inside(tet.triangle)) return;
    bool any = false;
    for (int i = below ? 0 : 1, first = i; i < first + 3; ++i) {
      const SlabPoint a = tet.v[i], b = tet.v[first + (i - first + 1) % 3];
      if (slice.contour_edge(numbers_.own(a), numbers_.own(b))) continue;
      edges_.push_back(sorted(a, b));
      any = true;
    }
    // A hole of three points has no external edge at all: its triangle gets a point of its own.
    if (!any)
      faces_.push_back(below ? std::array{tet.v[0], tet.v[1], tet.v[2]} : std::array{tet.v[1], tet.v[2], tet.v[3]});
  }

  static SplitEdge sorted(SlabPoint a, SlabPoint b) { return a < b ? SplitEdge{a, b} : SplitEdge{b, a}; }

  // ---- stars --------------------------------------------------------------------------------------------------------

  void collect_stars() {
    for (const SplitEdge& edge : edges_)
      for (const SlabPoint v : edge) stars_[v];
    for (const auto& face : faces_)
      for (const SlabPoint v : face) stars_[v];
    for (const PieceIndex p : pieces_.indices()) enlist(p);
  }

  void enlist(PieceIndex piece) {
    for (const SlabPoint v : pieces_[piece].v)
      if (const auto star = stars_.find(v); star != stars_.end()) star->second.push_back(piece);
  }

  bool has(PieceIndex piece, SlabPoint v) const {
    const auto& p = pieces_[piece].v;
    return p[0] == v || p[1] == v || p[2] == v || p[3] == v;
  }

  template <std::size_t N>
  Star star_of(const std::array<SlabPoint, N>& simplex) {
    Star star;
    for (const PieceIndex p : stars_[simplex[0]])
      if (std::all_of(simplex.begin(), simplex.end(), [&](SlabPoint v) { return has(p, v); })) star.push_back(p);
    std::sort(star.begin(), star.end());
    star.erase(std::unique(star.begin(), star.end()), star.end());
    return star;
  }

  // ---- where a point may go -----------------------------------------------------------------------------------------

  static std::array<SlabPoint, 4> with(std::array<SlabPoint, 4> v, SlabPoint out, SlabPoint in) {
    std::replace(v.begin(), v.end(), out, in);
    return v;
  }

  bool positive(const std::array<SlabPoint, 4>& v) const {
    return orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) > 0;
  }

  /// Would every piece of the star stay positive with the last point put in for each corner of the simplex in turn?
  template <std::size_t N>
  bool fits(const std::array<SlabPoint, N>& simplex, const Star& star) const {
    const SlabPoint added(points_.size() - 1);
    for (const PieceIndex p : star)
      for (const SlabPoint corner : simplex)
        if (!positive(with(pieces_[p].v, corner, added))) return false;
    return true;
  }

  /// Faces of the hull at an edge: the new point stays on their inner side, or it could run into another component.
  bool within_hull(const SplitEdge& edge, const Star& star) const {
    const double plane = points_[edge[0]].z;
    for (const PieceIndex p : star)
      for (const SlabPoint x : pieces_[p].v) {
        if (x == edge[0] || x == edge[1] || points_[x].z == plane) continue;
        const auto sharing = std::count_if(star.begin(), star.end(), [&](PieceIndex s) { return has(s, x); });
        if (sharing != 1) continue;
        // Put the new point in for the piece's fourth corner: the sign must not turn.
        for (const SlabPoint y : pieces_[p].v)
          if (y != edge[0] && y != edge[1] && y != x) {
            const auto v = with(pieces_[p].v, y, SlabPoint(points_.size() - 1));
            if (orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) < 0) return false;
          }
      }
    return true;
  }

  double height_share(double z, double plane) const { return std::abs(z - plane) / (heights_.upper - heights_.lower); }

  /// Tries base + t (target - base) for falling t; `fit` judges the point, which is points_.back().
  template <class Fit>
  bool try_towards(const Point3& base, const Point3& target, double scale, Fit fit) {
    const double sideways = portable::hypot(target.x - base.x, target.y - base.y);
    double step = limits::lift_height / height_share(target.z, base.z);
    if (sideways > 0) step = std::min(step, limits::lift_sideways * scale / sideways);
    for (int halving = 0; halving < limits::lift_halvings; ++halving, step /= 2) {
      Point3& p = points_.back();
      const auto fits_at = [&](double share) {
        p = {base.x + share * (target.x - base.x), base.y + share * (target.y - base.y),
             base.z + share * (target.z - base.z)};
        return p.z > heights_.lower && p.z < heights_.upper && fit();
      };
      // The last step that fits may all but touch a face; a good deal nearer there is room around the point.
      if (!fits_at(step) || !fits_at(step * limits::lift_margin)) continue;
      largest_sideways_ = std::max(largest_sideways_, portable::hypot(p.x - base.x, p.y - base.y) / scale);
      return true;
    }
    return false;
  }

  Point3 centroid(const std::array<SlabPoint, 4>& v) const {
    Point3 c;
    for (const SlabPoint p : v) c = {c.x + points_[p].x / 4, c.y + points_[p].y / 4, c.z + points_[p].z / 4};
    return c;
  }

  /// Straight along z; else towards the middle of a piece of the star, the one that leads least far sideways first:
  /// from the edge into a convex piece there is always a way.
  template <class Fit>
  bool place(const Point3& base, double scale, const Star& star, Fit fit) {
    points_.push_back(base);
    const bool below = base.z == heights_.lower;
    if (try_towards(base, {base.x, base.y, below ? heights_.upper : heights_.lower}, scale, fit)) return true;
    std::vector<std::pair<double, Point3>> targets;
    for (const PieceIndex p : star) {
      const Point3 c = centroid(pieces_[p].v);
      targets.emplace_back(portable::hypot(c.x - base.x, c.y - base.y) / height_share(c.z, base.z), c);
    }
    std::stable_sort(targets.begin(), targets.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return std::any_of(targets.begin(), targets.end(),
                       [&](const auto& target) { return try_towards(base, target.second, scale, fit); });
  }

  // ---- splitting ----------------------------------------------------------------------------------------------------

  template <std::size_t N>
  void split(const std::array<SlabPoint, N>& simplex, const Star& star) {
    const SlabPoint added(points_.size() - 1);
    stars_[added];
    for (const PieceIndex p : star) {
      const Piece whole = pieces_[p];
      for (std::size_t corner = 0; corner < N; ++corner) {
        const Piece part{with(whole.v, simplex[corner], added), whole.in, whole.reach};
        PieceIndex number = p;
        if (corner == 0) {
          pieces_[p] = part;
        } else {
          number = PieceIndex(pieces_.size());
          pieces_.push_back(part);
        }
        enlist(number);
      }
    }
  }

  bool lift_edge(const SplitEdge& edge) {
    const Point3 a = points_[edge[0]], b = points_[edge[1]];
    const Star star = star_of(edge);
    const Point3 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z};
    const double length = portable::hypot(b.x - a.x, b.y - a.y);
    if (!place(middle, length, star, [&] { return fits(edge, star) && within_hull(edge, star); })) return false;
    split(edge, star);
    return true;
  }

  bool lift_face(const std::array<SlabPoint, 3>& face) {
    const Point3 a = points_[face[0]], b = points_[face[1]], c = points_[face[2]];
    const Star star = star_of(face);
    const Point3 middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, a.z};
    const double length = std::max({portable::hypot(b.x - a.x, b.y - a.y), portable::hypot(c.x - b.x, c.y - b.y),
                                    portable::hypot(a.x - c.x, a.y - c.y)});
    if (!place(middle, length, star, [&] { return fits(face, star); })) return false;
    split(face, star);
    return true;
  }

  const Planar& lower_;
  const Planar& upper_;
  SlabHeights heights_;
  SlabNumbers numbers_;
  Table<SlabPoint, Point3> points_;
  Table<PieceIndex, Piece> pieces_;
  std::vector<SplitEdge> edges_;
  std::vector<std::array<SlabPoint, 3>> faces_;
  std::unordered_map<SlabPoint, Star> stars_;  // of the corners that lifting touches; looked up, never walked
  double largest_sideways_ = 0;
};

}  // namespace

void drop_unused(SlabSolid& solid, std::uint32_t on_slices) {
  std::vector<std::uint32_t> number(solid.added.size(), none);
  for (const auto& v : solid.tetrahedra)
    for (const std::uint32_t p : v)
      if (p >= on_slices) number[p - on_slices] = 0;
  std::vector<Point3> used;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] == none) continue;
    number[p] = on_slices + static_cast<std::uint32_t>(used.size());
    used.push_back(solid.added[p]);
  }
  solid.added = std::move(used);
  for (auto& v : solid.tetrahedra)
    for (std::uint32_t& p : v)
      if (p >= on_slices) p = number[p - on_slices];
}

bool lift(const SlabTetrahedra& tetrahedra, const Fates& fate, const Planar& lower, const Planar& upper,
          SlabHeights heights, std::uint32_t whole_lower, std::uint32_t whole_upper, SlabSolid& solid) {
  Lift work(tetrahedra, fate, lower, upper, heights);
  if (!work.run()) return false;
  const auto given = static_cast<std::uint32_t>(lower.points.size() + upper.points.size());
  const auto first_added = static_cast<std::uint32_t>(whole_lower + whole_upper + solid.added.size());
  const SlabNumbers numbers(lower);
  const auto number = [&](SlabPoint v) {
    if (numbers.is_lower(v)) return lower.slice_point[numbers.own(v)];
    if (v < given) return whole_lower + upper.slice_point[numbers.own(v)];
    return first_added + (v - given);
  };
  for (const Piece& piece : work.pieces()) {
    if (!piece.in) continue;
    solid.tetrahedra.push_back({number(piece.v[0]), number(piece.v[1]), number(piece.v[2]), number(piece.v[3])});
    solid.reach.push_back(piece.reach);
  }
  solid.added.insert(solid.added.end(), work.points().begin() + given, work.points().end());
  solid.restored += static_cast<std::size_t>(std::count(fate.begin(), fate.end(), Fate::restored));
  solid.largest_sideways = std::max(solid.largest_sideways, work.largest_sideways());
  return true;
}

}  // namespace odontoscope::delaunay
