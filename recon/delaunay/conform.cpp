#include "recon/delaunay/conform.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_conformer_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::uint32_t> spatial_order(const std::vector<Point2>& points) {
  std::vector<Kernel::Point_2> sites;
  sites.reserve(points.size());
  for (const Point2 p : points) sites.emplace_back(p.x, p.y);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
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

bool gabriel(const Cdt& cdt, Face face, int i) {
  const auto& a = face->vertex(Cdt::ccw(i))->point();
  const auto& b = face->vertex(Cdt::cw(i))->point();
  for (const auto& [f, k] : {std::pair{face, i}, std::pair{face->neighbor(i), cdt.mirror_index(face, i)}})
    if (!cdt.is_infinite(f) && CGAL::angle(a, f->vertex(k)->point(), b) == CGAL::OBTUSE) return false;
  return true;
}

bool all_gabriel(const Cdt& cdt) {
  for (auto edge = cdt.finite_edges_begin(); edge != cdt.finite_edges_end(); ++edge)
    if (edge->first->is_constrained(edge->second) && !gabriel(cdt, edge->first, edge->second)) return false;
  return true;
}

// Rounded midpoints lie beside their edge; the triangulation that they were inserted into may then hold folded triangles.
bool sound(const Cdt& cdt) {
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    const auto& a = face->vertex(0)->point();
    const auto& b = face->vertex(1)->point();
    const auto& c = face->vertex(2)->point();
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return false;
    for (int i = 0; i < 3; ++i) {
      const Face other = face->neighbor(i);
      if (cdt.is_infinite(other)) continue;
      const auto& d = other->vertex(cdt.mirror_index(face, i))->point();
      if (CGAL::side_of_oriented_circle(a, b, c, d) == CGAL::ON_POSITIVE_SIDE) return false;
    }
  }
  return all_gabriel(cdt);
}

class Conformer {
 public:
  Conformer(const Slice& slice, std::size_t number, const std::string& source, const Progress& progress)
      : slice_(slice), number_(number), source_(source), progress_(progress) {}

  /// Refines `rings` and leaves its triangulation in `cdt`, both sound.
  void run(Rings& rings, Cdt& cdt, std::vector<std::uint32_t>& order) {
    const std::size_t most = limits::steiner_factor * rings.points.size() + limits::steiner_free;
    for (int round = 0; round < limits::conform_rounds; ++round) {
      cdt.clear();
      order = spatial_order(rings.points);
      const std::vector<Vertex> vertices = triangulate(rings, cdt, order);
      if (all_gabriel(cdt)) return;
      refine(cdt, most);
      read_back(rings, vertices);
      if (sound(cdt)) {
        order = spatial_order(rings.points);
        return;
      }
    }
    too_close(rings.points.front());
  }

 private:
  std::vector<Vertex> triangulate(const Rings& rings, Cdt& cdt, const std::vector<std::uint32_t>& order) const {
    std::vector<Vertex> vertices = insert_points(cdt, rings.points, order);
    const std::vector<std::uint32_t> next = rings.next();
    for (std::uint32_t p = 0; p < next.size(); ++p) {
      if (vertices[p] == vertices[next[p]]) too_close(rings.points[p]);
      try {
        cdt.insert_constraint(vertices[p], vertices[next[p]]);
      } catch (const Cdt::Intersection_of_constraints_exception&) {
        too_close(rings.points[p]);
      }
    }
    return vertices;
  }

  void refine(Cdt& cdt, std::size_t most) const {
    CGAL::Triangulation_conformer_2<Cdt> conformer(cdt);
    conformer.init_Gabriel();
    while (!conformer.is_conforming_done()) {
      const auto before = cdt.number_of_vertices();
      conformer.try_one_step_conforming_Gabriel();
      if (cdt.number_of_vertices() > most) {
        const auto& last = cdt.finite_vertices_begin()->point();
        too_close({last.x(), last.y()});
      }
      if (before % 1024 == 0) progress_.check();
    }
  }

  // Follows the constrained edges from each point to its follower and takes up the points added between.
  void read_back(Rings& rings, const std::vector<Vertex>& vertices) const {
    const std::vector<std::uint32_t> next = rings.next();
    Rings refined;
    for (std::size_t c = 0; c + 1 < rings.first_point.size(); ++c) {
      for (std::uint32_t p = rings.first_point[c]; p < rings.first_point[c + 1]; ++p) {
        vertices[p]->info().value = static_cast<std::uint32_t>(refined.points.size());
        refined.points.push_back(rings.points[p]);
        for (const Vertex added : between(vertices[p], vertices[next[p]])) {
          added->info().value = static_cast<std::uint32_t>(refined.points.size());
          refined.points.push_back({added->point().x(), added->point().y()});
        }
      }
      refined.first_point.push_back(static_cast<std::uint32_t>(refined.points.size()));
    }
    rings = std::move(refined);
  }

  static std::vector<Vertex> constrained_neighbours(Vertex v) {
    std::vector<Vertex> ends;
    Face face = v->face();
    const Face start = face;
    do {   // the face's edge from v to its next vertex clockwise is opposite ccw
      const int i = face->index(v);
      if (face->is_constrained(Cdt::cw(i))) ends.push_back(face->vertex(Cdt::ccw(i)));
      face = face->neighbor(Cdt::ccw(i));
    } while (face != start);
    return ends;
  }

  static std::vector<Vertex> between(Vertex from, Vertex to) {
    for (Vertex step : constrained_neighbours(from)) {
      std::vector<Vertex> path;
      Vertex behind = from;
      while (step->info().value == none) {
        path.push_back(step);
        const std::vector<Vertex> ends = constrained_neighbours(step);
        if (ends.size() != 2) throw InternalError("a refined contour forks");
        const Vertex ahead = ends[0] == behind ? ends[1] : ends[0];
        behind = step;
        step = ahead;
      }
      if (step == to) return path;
    }
    throw InternalError("a refined contour lost an edge");
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

// The triangle on the left of each point's contour edge; none where the triangulation lacks the edge.
std::vector<std::uint32_t> left_triangles(const Planar& planar) {
  std::vector<std::uint32_t> left(planar.points.size(), none);
  for (std::uint32_t t = 0; t < planar.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = planar.triangles[t].v[(k + 1) % 3], b = planar.triangles[t].v[(k + 2) % 3];
      if (planar.next[a] == b) left[a] = t;
    }
  return left;
}

void collect_spokes(Planar& planar) {
  const auto count = static_cast<std::uint32_t>(planar.points.size());
  std::vector<std::uint32_t> any(count, none), first(count, none);   // a triangle at v; the one after the hull's gap
  std::vector<std::uint32_t> degree(count + 1, 0);
  for (std::uint32_t t = 0; t < planar.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const std::uint32_t v = triangle.v[k];
      any[v] = t;
      ++degree[v];
      if (triangle.nb[(k + 2) % 3] == none) {   // its edge from v to the next vertex lies on the hull
        first[v] = t;
        ++degree[v];
      }
    }
  planar.first_spoke.assign(count + 1, 0);
  for (std::uint32_t v = 0; v < count; ++v) planar.first_spoke[v + 1] = planar.first_spoke[v] + degree[v];
  planar.spokes.resize(planar.first_spoke[count]);
  const auto kind = [&planar](std::uint32_t v, std::uint32_t w, std::uint32_t beside) {
    if (planar.contour_edge(v, w)) return EdgeKind::contour;
    return planar.inside(beside) ? EdgeKind::internal : EdgeKind::external;
  };
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t t = first[v] != none ? first[v] : any[v];
    for (std::uint32_t s = planar.first_spoke[v]; s < planar.first_spoke[v + 1]; ++s) {
      const PlanarTriangle& triangle = planar.triangles[t];
      const int k = triangle.v[0] == v ? 0 : triangle.v[1] == v ? 1 : 2;
      const std::uint32_t w = triangle.v[(k + 1) % 3];
      planar.spokes[s] = {w, t, kind(v, w, t)};
      if (triangle.nb[(k + 1) % 3] == none && s + 2 == planar.first_spoke[v + 1]) {   // the hull's gap follows
        const std::uint32_t last = triangle.v[(k + 2) % 3];
        planar.spokes[++s] = {last, none, kind(v, last, t)};
      } else {
        t = triangle.nb[(k + 1) % 3];
      }
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
  Conformer(slice, number, source, progress).run(rings, cdt, order);
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
