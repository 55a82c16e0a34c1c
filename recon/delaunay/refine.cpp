#include "recon/delaunay/refine.h"

#include <algorithm>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/core/spatial_order.h"
#include "recon/delaunay/limits.h"

namespace odontoscope::delaunay {
namespace {

/// Splits contour edges until all are Gabriel, or Delaunay. Rounds of triangulating anew from the points alone: every
/// triangulation is sound by exact predicates although split points are rounded, and the result depends on the input
/// only. Edges at a sharp corner are split on circles around it whose radii are powers of two (Ruppert 1995), so that
/// the two never split each other for ever. Edges along a narrow gap are split opposite each other's points, which
/// takes a few points; halving them would take one for each gap's width.
class Conformer {
 public:
  Conformer(Fineness fineness, const Slice& slice, std::size_t number, const std::string& source,
            const Progress& progress)
      : fineness_(fineness), slice_(slice), number_(number), source_(source), progress_(progress) {}

  /// Refines `rings` and leaves its triangulation in `cdt`, points numbered as in `rings`.
  void run(Rings& rings, Cdt& cdt, std::vector<SlicePoint>& order) {
    const Rings given = rings;
    std::vector<Spot> spots;  // of each point of `rings`: where on the given contours it lies
    for (const SlicePoint p : given.points.indices()) spots.push_back({p, 0, 1});
    const std::size_t most = limits::steiner_factor * given.points.size() +
                             (fineness_ == Fineness::gabriel ? limits::gabriel_free : limits::delaunay_free);
    for (int round = 0; round < limits::conform_rounds; ++round) {
      progress_.check();
      cdt.clear();
      order = order_of(rings.points);
      triangulate(rings, cdt, order);
      if (fineness_ == Fineness::constrained) return;
      const Table<SlicePoint, SlicePoint> within = encroached(cdt, rings);
      const std::size_t splits =
          within.size() - static_cast<std::size_t>(std::count(within.begin(), within.end(), none));
      if (splits == 0) return;
      if (rings.points.size() + splits > most) {
        const auto first = std::find_if(within.begin(), within.end(), [](SlicePoint v) { return v != none; });
        too_close(rings.points[SlicePoint(first - within.begin())]);
      }
      refine(rings, spots, given, within);
    }
    too_close(rings.points.front());
  }

 private:
  /// On the given contour edge that starts at point `from`: a share `t` of the way from its start, `u` from its end.
  /// Both are kept, so that a contour and its mirror image, which runs the other way, are split alike to the last bit.
  struct Spot {
    SlicePoint from;
    double t, u;
  };

  void triangulate(const Rings& rings, Cdt& cdt, const std::vector<SlicePoint>& order) const {
    const Table<SlicePoint, Vertex> vertices = insert_points(cdt, rings.points, order);
    const Table<SlicePoint, SlicePoint> next = rings.next();
    for (const SlicePoint p : order) {
      if (vertices[p]->info() != p) too_close(rings.points[p]);  // rounded onto another point
      try {
        cdt.insert_constraint(vertices[p], vertices[next[p]]);
      } catch (const Cdt::Intersection_of_constraints_exception&) {
        too_close(rings.points[p]);
      }
    }
  }

  /// For each point: a point within the diametral circle of the contour edge that starts there, if because of it the
  /// edge must be split.
  Table<SlicePoint, SlicePoint> encroached(const Cdt& cdt, const Rings& rings) const {
    const Table<SlicePoint, SlicePoint> next = rings.next();
    Table<SlicePoint, SlicePoint> within(rings.points.size(), none);
    for (auto edge = cdt.finite_edges_begin(); edge != cdt.finite_edges_end(); ++edge) {
      if (!edge->first->is_constrained(edge->second)) continue;
      if (fineness_ == Fineness::delaunay && is_delaunay(cdt, edge->first, edge->second)) continue;
      const Vertex point = encroacher(cdt, edge->first, edge->second);
      if (point == Vertex()) continue;
      const SlicePoint a = edge->first->vertex(Cdt::ccw(edge->second))->info();
      const SlicePoint b = edge->first->vertex(Cdt::cw(edge->second))->info();
      within[next[a] == b ? a : b] = point->info();
    }
    return within;
  }

  void refine(Rings& rings, std::vector<Spot>& spots, const Rings& given,
              const Table<SlicePoint, SlicePoint>& within) const {
    const Table<SlicePoint, SlicePoint> next = rings.next(), given_next = given.next();
    Table<SlicePoint, SlicePoint> previous(next.size());
    for (const SlicePoint p : next.indices()) previous[next[p]] = p;
    Rings refined;
    std::vector<Spot> refined_spots;
    const auto add = [&](Point2 at, Spot spot) {
      refined.points.push_back(at);
      refined_spots.push_back(spot);
    };
    for (std::size_t c = 0; c + 1 < rings.first_point.size(); ++c) {
      for (const SlicePoint p : Indices(rings.first_point[c], rings.first_point[c + 1])) {
        add(rings.points[p], spots[p]);
        if (within[p] == none) continue;
        const Point2 a = given.points[spots[p].from], b = given.points[given_next[spots[p].from]];
        const Spot start = spots[p], end = spots[next[p]].t == 0 ? Spot{start.from, 1, 0} : spots[next[p]];
        const SlicePoint v = within[p];
        Spot split_at = opposite(start.from, a, b, rings.points[v]);
        if (!(start.t < split_at.t && split_at.t < end.t && end.u < split_at.u && split_at.u < start.u) ||
            !settles(rings.points[p], rings.points[next[p]], between(a, b, split_at), rings.points[v],
                     rings.points[previous[v]], rings.points[next[v]]))
          split_at = split_spot(start, end, portable::hypot(b.x - a.x, b.y - a.y), sharp(given, given_next, start.from),
                                sharp(given, given_next, given_next[start.from]));
        add(between(a, b, split_at), split_at);
      }
      refined.first_point.emplace_back(refined.points.size());
    }
    rings = std::move(refined);
    spots = std::move(refined_spots);
  }

  /// Always taken from the given edge, so that errors of rounding never add up.
  static Point2 between(Point2 a, Point2 b, Spot spot) {
    const auto mix = [&spot](double from, double to) { return from == to ? from : from * spot.u + to * spot.t; };
    return {mix(a.x, b.x), mix(a.y, b.y)};
  }

  /// The foot of v on the edge from a to b.
  static Spot opposite(SlicePoint from, Point2 a, Point2 b, Point2 v) {
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    double t = ((v.x - a.x) * x + (v.y - a.y) * y) / square, u = ((b.x - v.x) * x + (b.y - v.y) * y) / square;
    if (t < u)
      u = 1 - t;
    else
      t = 1 - u;
    return {from, t, u};
  }

  /// Is `foot` on the edge from a to b, opposite a point v with neighbours w and x, the place to split? Only where the
  /// gap is narrow for the edge's length, neither part is shorter than the gap, and, exactly, v leaves both parts alone
  /// and the foot leaves both edges at v alone (for Delaunay edges a rounding beside that place does no harm).
  bool settles(Point2 a, Point2 b, Point2 foot, Point2 v, Point2 w, Point2 x) const {
    const auto distance = [](Point2 p, Point2 q) { return portable::hypot(p.x - q.x, p.y - q.y); };
    const double gap = distance(foot, v);
    if (gap * limits::narrow_gap > distance(a, b) || distance(a, foot) < gap || distance(foot, b) < gap) return false;
    if (fineness_ == Fineness::delaunay) return true;
    const auto clear = [](Point2 from, Point2 at, Point2 to) {
      const auto point = [](Point2 p) { return Kernel::Point_2(p.x, p.y); };
      return CGAL::angle(point(from), point(at), point(to)) != CGAL::OBTUSE;
    };
    return clear(a, v, foot) && clear(foot, v, b) && clear(v, foot, w) && clear(v, foot, x);
  }

  /// Where to split between two spots of an edge of this length: on a circle around a sharp end, else in the middle.
  static Spot split_spot(Spot start, Spot end, double length, bool sharp_start, bool sharp_end) {
    const bool at_start = sharp_start && start.t == 0, at_end = sharp_end && end.u == 0;
    if (at_start == at_end) return {start.from, (start.t + end.t) / 2, (start.u + end.u) / 2};
    const double piece = at_start ? end.t : start.u;
    const double share = portable::nearest_power_of_two(piece * length / 2) / length;
    return at_start ? Spot{start.from, share, 1 - share} : Spot{start.from, 1 - share, share};
  }

  static bool sharp(const Rings& given, const Table<SlicePoint, SlicePoint>& next, SlicePoint p) {
    // The point before p on its contour: contours are contiguous.
    const auto c = std::upper_bound(given.first_point.begin(), given.first_point.end(), p);
    const SlicePoint first = *(c - 1), end = *c;
    const Point2 before = given.points[SlicePoint(p == first ? end - 1 : p - 1)], at = given.points[p],
                 after = given.points[next[p]];
    return (before.x - at.x) * (after.x - at.x) + (before.y - at.y) * (after.y - at.y) > 0;
  }

  [[noreturn]] void too_close(Point2 at) const {
    Place place;
    place.file = source_;
    place.slice = number_;
    place.z = slice_.z;
    place.at = at;
    throw InputError("too-close", place, "contours run too close to each other, or one to itself, to be told apart",
                     "Move them apart, or drop points that crowd together (simplify the contours)");
  }

  Fineness fineness_;
  const Slice& slice_;
  std::size_t number_;
  const std::string& source_;
  const Progress& progress_;
};

}  // namespace

std::vector<SlicePoint> order_of(const Table<SlicePoint, Point2>& points) {
  const std::vector<std::uint32_t> order = spatial_order(points);
  return std::vector<SlicePoint>(order.begin(), order.end());
}

Vertex encroacher(const Cdt& cdt, Face face, int i) {
  // Which of the edge's sides is asked about depends on where its triangles lie in memory, and rounded heights on which
  // end is the first.
  const auto ends = std::minmax(face->vertex(Cdt::ccw(i))->point(), face->vertex(Cdt::cw(i))->point());
  const auto &a = ends.first, &b = ends.second;
  const auto height = [&](Vertex v) {
    return std::abs((b.x() - a.x()) * (v->point().y() - a.y()) - (b.y() - a.y()) * (v->point().x() - a.x()));
  };
  Vertex nearest;
  for (const auto& [f, k] : {std::pair{face, i}, std::pair{face->neighbor(i), cdt.mirror_index(face, i)}}) {
    if (cdt.is_infinite(f) || CGAL::angle(a, f->vertex(k)->point(), b) != CGAL::OBTUSE) continue;
    const Vertex v = f->vertex(k);
    if (nearest == Vertex() || std::pair(height(v), v->point()) < std::pair(height(nearest), nearest->point()))
      nearest = v;
  }
  return nearest;
}

bool is_delaunay(const Cdt& cdt, Face face, int i) {
  const Face other = face->neighbor(i);
  if (cdt.is_infinite(face) || cdt.is_infinite(other)) return true;
  return CGAL::side_of_oriented_circle(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point(),
                                       other->vertex(cdt.mirror_index(face, i))->point()) != CGAL::ON_POSITIVE_SIDE;
}

Table<SlicePoint, Vertex> insert_points(Cdt& cdt, const Table<SlicePoint, Point2>& points,
                                        const std::vector<SlicePoint>& order) {
  Table<SlicePoint, Vertex> vertices(points.size());
  Face hint;
  for (const SlicePoint p : order) {
    vertices[p] = cdt.insert(Kernel::Point_2(points[p].x, points[p].y), hint);
    vertices[p]->info() = p;
    hint = vertices[p]->face();
  }
  return vertices;
}

void refine(Fineness fineness, const Slice& slice, std::size_t number, const std::string& source,
            const Progress& progress, const Refinement& refinement) {
  Conformer(fineness, slice, number, source, progress).run(refinement.rings, refinement.cdt, refinement.order);
}

}  // namespace odontoscope::delaunay
