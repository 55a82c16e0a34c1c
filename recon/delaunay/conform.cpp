#include "recon/delaunay/conform.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/core/limits.h"
#include "recon/delaunay/predicates.h"

namespace odontoscope::delaunay {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Number {
  std::uint32_t value = none;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Number, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

// Contours as points in one array, each with its follower.
struct Rings {
  std::vector<Point2> points;
  std::vector<std::uint32_t> first_point{0};

  std::vector<std::uint32_t> next() const {
    std::vector<std::uint32_t> follower(points.size());
    for (std::size_t c = 0; c + 1 < first_point.size(); ++c)
      for (std::uint32_t p = first_point[c]; p < first_point[c + 1]; ++p)
        follower[p] = p + 1 < first_point[c + 1] ? p + 1 : first_point[c];
    return follower;
  }
};

/// Along a space-filling curve, which is fast to insert. It starts from the order of coordinates, so that the triangulation of points on
/// one circle does not depend on how contours are numbered.
std::vector<std::uint32_t> spatial_order(const std::vector<Point2>& points) {
  std::vector<Kernel::Point_2> sites;
  sites.reserve(points.size());
  for (const Point2 p : points) sites.emplace_back(p.x, p.y);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&sites](std::size_t a, std::size_t b) { return sites[a] < sites[b]; });
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(CGAL::make_property_map(sites)));
  return {order.begin(), order.end()};
}

std::vector<Vertex> insert_points(Cdt& cdt, const std::vector<Point2>& points, const std::vector<std::uint32_t>& order) {
  std::vector<Vertex> vertices(points.size());
  Face hint;
  for (const std::uint32_t p : order) {
    vertices[p] = cdt.insert(Kernel::Point_2(points[p].x, points[p].y), hint);
    vertices[p]->info().value = p;
    hint = vertices[p]->face();
  }
  return vertices;
}

/// A point of the two triangles beside the edge that lies within its diametral circle, the one nearest to the edge; a null handle if none
/// does: then no other point does, since the triangulation is constrained Delaunay.
Vertex encroacher(const Cdt& cdt, Face face, int i) {
  const auto& a = face->vertex(Cdt::ccw(i))->point();
  const auto& b = face->vertex(Cdt::cw(i))->point();
  const auto height = [&](Vertex v) {
    return std::abs((b.x() - a.x()) * (v->point().y() - a.y()) - (b.y() - a.y()) * (v->point().x() - a.x()));
  };
  Vertex nearest;
  for (const auto& [f, k] : {std::pair{face, i}, std::pair{face->neighbor(i), cdt.mirror_index(face, i)}}) {
    if (cdt.is_infinite(f) || CGAL::angle(a, f->vertex(k)->point(), b) != CGAL::OBTUSE) continue;
    const Vertex v = f->vertex(k);
    if (nearest == Vertex() || std::pair(height(v), v->point()) < std::pair(height(nearest), nearest->point())) nearest = v;
  }
  return nearest;
}

/// What is asked of each contour edge. Delaunay is less: of the two triangles beside the edge neither has the other's corner in its circumcircle.
/// It can be had wherever two numbers lie in a gap, while Gabriel edges along a gap must end opposite each other to within its width squared over
/// their length, which for needles is below the last place.
enum class Fineness { gabriel, delaunay };

bool is_delaunay(const Cdt& cdt, Face face, int i) {
  const Face other = face->neighbor(i);
  if (cdt.is_infinite(face) || cdt.is_infinite(other)) return true;
  return CGAL::side_of_oriented_circle(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point(),
                                       other->vertex(cdt.mirror_index(face, i))->point()) != CGAL::ON_POSITIVE_SIDE;
}

/// Splits contour edges until all are Gabriel, or Delaunay. Rounds of triangulating anew from the points alone: every triangulation is sound by exact
/// predicates although split points are rounded, and the result depends on the input only. Edges at a sharp corner are split on
/// circles around it whose radii are powers of two (Ruppert 1995), so that the two never split each other for ever. Edges along a narrow
/// gap are split opposite each other's points, which takes a few points; halving them would take one for each gap's width.
class Conformer {
 public:
  Conformer(Fineness fineness, const Slice& slice, std::size_t number, const std::string& source, const Progress& progress)
      : fineness_(fineness), slice_(slice), number_(number), source_(source), progress_(progress) {}

  /// Refines `rings` and leaves its triangulation in `cdt`, points numbered as in `rings`.
  void run(Rings& rings, Cdt& cdt, std::vector<std::uint32_t>& order) {
    const Rings given = rings;
    std::vector<Spot> spots;   // of each point of `rings`: where on the given contours it lies
    for (std::uint32_t p = 0; p < given.points.size(); ++p) spots.push_back({p, 0, 1});
    const std::size_t most = limits::steiner_factor * given.points.size() + limits::steiner_free;
    for (int round = 0; round < limits::conform_rounds; ++round) {
      progress_.check();
      cdt.clear();
      order = spatial_order(rings.points);
      triangulate(rings, cdt, order);
      const std::vector<std::uint32_t> within = encroached(cdt, rings);
      const std::size_t splits = within.size() - static_cast<std::size_t>(std::count(within.begin(), within.end(), none));
      if (splits == 0) return;
      if (rings.points.size() + splits > most) {
        const auto first = std::find_if(within.begin(), within.end(), [](std::uint32_t v) { return v != none; });
        too_close(rings.points[static_cast<std::size_t>(first - within.begin())]);
      }
      refine(rings, spots, given, within);
    }
    too_close(rings.points.front());
  }

 private:
  /// On the given contour edge that starts at point `from`: a share `t` of the way from its start, `u` from its end. Both are kept, so
  /// that a contour and its mirror image, which runs the other way, are split alike to the last bit.
  struct Spot {
    std::uint32_t from;
    double t, u;
  };

  void triangulate(const Rings& rings, Cdt& cdt, const std::vector<std::uint32_t>& order) const {
    const std::vector<Vertex> vertices = insert_points(cdt, rings.points, order);
    const std::vector<std::uint32_t> next = rings.next();
    for (const std::uint32_t p : order) {
      if (vertices[p]->info().value != p) too_close(rings.points[p]);   // rounded onto another point
      try {
        cdt.insert_constraint(vertices[p], vertices[next[p]]);
      } catch (const Cdt::Intersection_of_constraints_exception&) {
        too_close(rings.points[p]);
      }
    }
  }

  /// For each point: a point within the diametral circle of the contour edge that starts there, if because of it the edge must be split.
  std::vector<std::uint32_t> encroached(const Cdt& cdt, const Rings& rings) const {
    const std::vector<std::uint32_t> next = rings.next();
    std::vector<std::uint32_t> within(rings.points.size(), none);
    for (auto edge = cdt.finite_edges_begin(); edge != cdt.finite_edges_end(); ++edge) {
      if (!edge->first->is_constrained(edge->second)) continue;
      if (fineness_ == Fineness::delaunay && is_delaunay(cdt, edge->first, edge->second)) continue;
      const Vertex point = encroacher(cdt, edge->first, edge->second);
      if (point == Vertex()) continue;
      const std::uint32_t a = edge->first->vertex(Cdt::ccw(edge->second))->info().value;
      const std::uint32_t b = edge->first->vertex(Cdt::cw(edge->second))->info().value;
      within[next[a] == b ? a : b] = point->info().value;
    }
    return within;
  }

  void refine(Rings& rings, std::vector<Spot>& spots, const Rings& given, const std::vector<std::uint32_t>& within) const {
    const std::vector<std::uint32_t> next = rings.next(), given_next = given.next();
    std::vector<std::uint32_t> previous(next.size());
    for (std::uint32_t p = 0; p < next.size(); ++p) previous[next[p]] = p;
    Rings refined;
    std::vector<Spot> refined_spots;
    const auto add = [&](Point2 at, Spot spot) {
      refined.points.push_back(at);
      refined_spots.push_back(spot);
    };
    for (std::size_t c = 0; c + 1 < rings.first_point.size(); ++c) {
      for (std::uint32_t p = rings.first_point[c]; p < rings.first_point[c + 1]; ++p) {
        add(rings.points[p], spots[p]);
        if (within[p] == none) continue;
        const Point2 a = given.points[spots[p].from], b = given.points[given_next[spots[p].from]];
        const Spot start = spots[p], end = spots[next[p]].t == 0 ? Spot{start.from, 1, 0} : spots[next[p]];
        const std::uint32_t v = within[p];
        Spot split_at = opposite(start.from, a, b, rings.points[v]);
        if (!(start.t < split_at.t && split_at.t < end.t && end.u < split_at.u && split_at.u < start.u) ||
            !settles(rings.points[p], rings.points[next[p]], between(a, b, split_at), rings.points[v], rings.points[previous[v]],
                     rings.points[next[v]]))
          split_at = split_spot(start, end, std::hypot(b.x - a.x, b.y - a.y), sharp(given, given_next, start.from),
                                sharp(given, given_next, given_next[start.from]));
        add(between(a, b, split_at), split_at);
      }
      refined.first_point.push_back(static_cast<std::uint32_t>(refined.points.size()));
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
  static Spot opposite(std::uint32_t from, Point2 a, Point2 b, Point2 v) {
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    double t = ((v.x - a.x) * x + (v.y - a.y) * y) / square, u = ((b.x - v.x) * x + (b.y - v.y) * y) / square;
    if (t < u) u = 1 - t;
    else t = 1 - u;
    return {from, t, u};
  }

  /// Is `foot` on the edge from a to b, opposite a point v with neighbours w and x, the place to split? Only where the gap is narrow for the
  /// edge's length, neither part is shorter than the gap, and, exactly, v leaves both parts alone and the foot leaves both edges at v alone
  /// (for Delaunay edges a rounding beside that place does no harm).
  bool settles(Point2 a, Point2 b, Point2 foot, Point2 v, Point2 w, Point2 x) const {
    const auto distance = [](Point2 p, Point2 q) { return std::hypot(p.x - q.x, p.y - q.y); };
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
    const double share = std::exp2(std::round(std::log2(piece * length / 2))) / length;
    return at_start ? Spot{start.from, share, 1 - share} : Spot{start.from, 1 - share, share};
  }

  static bool sharp(const Rings& given, const std::vector<std::uint32_t>& next, std::uint32_t p) {
    // The point before p on its contour: contours are contiguous.
    const auto c = std::upper_bound(given.first_point.begin(), given.first_point.end(), p);
    const std::uint32_t first = *(c - 1), end = *c;
    const Point2 before = given.points[p == first ? end - 1 : p - 1], at = given.points[p], after = given.points[next[p]];
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

// ---- from CGAL's structure to arrays ------------------------------------------------------------------------------

void copy_triangles(const Cdt& cdt, Planar& planar) {
  std::uint32_t count = 0;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) face->info().value = count++;
  planar.triangles.resize(count);
  planar.centres.resize(count);
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    PlanarTriangle& triangle = planar.triangles[face->info().value];
    for (int i = 0; i < 3; ++i) {
      triangle.v[i] = face->vertex(i)->info().value;
      const Face other = face->neighbor(i);
      triangle.nb[i] = cdt.is_infinite(other) ? none : other->info().value;
    }
    planar.centres[face->info().value] =
        circumcentre(planar.points[triangle.v[0]], planar.points[triangle.v[1]], planar.points[triangle.v[2]]);
  }
}

// Regions spread over triangles from the left of each contour edge, never across one. A region takes the number that
// `region_of_contour` gives to the contour where its spreading begins.
template <class Visit>
void spread(Planar& planar, std::uint32_t seed, std::uint32_t region, Visit visit) {
  std::vector<std::uint32_t> stack{seed};
  planar.triangles[seed].region = region;
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const std::uint32_t a = triangle.v[(k + 1) % 3], b = triangle.v[(k + 2) % 3];
      if (planar.contour_edge(a, b)) {
        visit(a);
        continue;
      }
      const std::uint32_t other = triangle.nb[k];
      if (other == none) throw InternalError("a region reaches the hull without a contour");
      if (planar.triangles[other].region != none) continue;
      planar.triangles[other].region = region;
      stack.push_back(other);
    }
  }
}

Planar start_planar(Rings rings) {
  Planar planar;
  planar.next = rings.next();
  planar.previous.resize(planar.next.size());
  for (std::uint32_t p = 0; p < planar.next.size(); ++p) planar.previous[planar.next[p]] = p;
  planar.points = std::move(rings.points);
  planar.slice_point.resize(planar.points.size());
  std::iota(planar.slice_point.begin(), planar.slice_point.end(), 0u);
  planar.region_of.assign(planar.points.size(), none);
  return planar;
}

bool counter_clockwise(const Contour& contour) {
  const auto& p = contour.points;
  const auto lowest = static_cast<std::size_t>(
      std::min_element(p.begin(), p.end(), [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }) - p.begin());
  const std::size_t before = (lowest + p.size() - 1) % p.size(), after = (lowest + 1) % p.size();
  return turn(p[before], p[lowest], p[lowest], p[after]) > 0;
}

}  // namespace

ConformedSlice conform(const Slice& slice, const std::string& structure, std::size_t number, const std::string& source,
                       const Progress& progress) {
  ConformedSlice result;
  result.z = slice.z;
  Rings rings;
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    if (slice.contours[c].structure != structure) continue;
    const auto& points = slice.contours[c].points;
    rings.points.insert(rings.points.end(), points.begin(), points.end());
    rings.first_point.push_back(static_cast<std::uint32_t>(rings.points.size()));
    result.contour_number.push_back(c);
  }
  if (rings.points.empty()) {
    result.first_point = {0};
    return result;
  }
  const std::size_t given = rings.points.size();
  Cdt cdt;
  std::vector<std::uint32_t> order;
  const Rings as_given = rings;
  try {
    Conformer(Fineness::gabriel, slice, number, source, progress).run(rings, cdt, order);
  } catch (const InputError&) {
    rings = as_given;
    Conformer(Fineness::delaunay, slice, number, source, progress).run(rings, cdt, order);
  }
  result.steiner_points = rings.points.size() - given;
  result.first_point = rings.first_point;

  Planar& planar = result.planar = start_planar(std::move(rings));
  planar.insertion_order = std::move(order);
  copy_triangles(cdt, planar);
  const std::vector<std::uint32_t> left = left_triangles(planar);
  for (std::size_t c = 0; c < result.contour_number.size(); ++c) {
    if (!counter_clockwise(slice.contours[result.contour_number[c]])) continue;
    const std::uint32_t seed = left[result.first_point[c]];
    if (seed == none) throw InternalError("a contour edge is missing from the triangulation");
    const auto region = static_cast<std::uint32_t>(result.outer_contour.size());
    result.outer_contour.push_back(static_cast<std::uint32_t>(c));
    spread(planar, seed, region, [&planar, region](std::uint32_t p) { planar.region_of[p] = region; });
  }
  if (std::count(planar.region_of.begin(), planar.region_of.end(), none) != 0)
    throw InternalError("a contour bounds no region");
  collect_spokes(planar);
  return result;
}

Planar part_of(const Planar& whole, const std::vector<bool>& chosen) {
  Planar part;
  std::vector<std::uint32_t> number(whole.points.size(), none);
  for (std::uint32_t p = 0; p < whole.points.size(); ++p) {
    if (!chosen[whole.region_of[p]]) continue;
    number[p] = static_cast<std::uint32_t>(part.points.size());
    part.points.push_back(whole.points[p]);
    part.slice_point.push_back(whole.slice_point[p]);
    part.region_of.push_back(whole.region_of[p]);
  }
  part.next.resize(part.points.size());
  part.previous.resize(part.points.size());
  for (std::uint32_t p = 0; p < whole.points.size(); ++p)
    if (number[p] != none) {
      part.next[number[p]] = number[whole.next[p]];
      part.previous[number[p]] = number[whole.previous[p]];
    }
  for (const std::uint32_t p : whole.insertion_order)
    if (number[p] != none) part.insertion_order.push_back(number[p]);

  // Every edge of the regions' triangles is constrained, so that cocircular points are cut the same way as in the whole.
  Cdt cdt;
  const std::vector<Vertex> vertices = insert_points(cdt, part.points, part.insertion_order);
  for (const PlanarTriangle& triangle : whole.triangles) {
    if (triangle.region == none || !chosen[triangle.region]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = number[triangle.v[(k + 1) % 3]], b = number[triangle.v[(k + 2) % 3]];
      if (a < b || part.contour_edge(a, b)) cdt.insert_constraint(vertices[a], vertices[b]);
    }
  }
  copy_triangles(cdt, part);
  const std::vector<std::uint32_t> left = left_triangles(part);
  for (std::uint32_t p = 0; p < part.points.size(); ++p) {
    if (left[p] == none) throw InternalError("a contour edge is missing from a component's triangulation");
    if (part.triangles[left[p]].region == none) spread(part, left[p], part.region_of[p], [](std::uint32_t) {});
  }
  collect_spokes(part);
  return part;
}

}  // namespace odontoscope::delaunay
