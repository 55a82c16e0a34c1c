#include "recon/formats/cut_polygon.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "recon/core/geometry.h"
#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

using Corner = std::uint32_t;
using CornerTriangles = std::vector<std::array<Corner, 3>>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct FaceInfo {
  bool visited = false, inside = false;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr Corner nobody = 0xffffffff;

std::array<double, 3> numbers(const Point3& p) { return {p.x, p.y, p.z}; }

/// Twice the area, seen along each axis.
std::array<double, 3> newell_normal(const std::vector<Point3>& corners) {
  const auto o = numbers(corners.front());
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto a = numbers(corners[i]), b = numbers(corners[(i + 1) % corners.size()]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] += (a[u] - o[u]) * (b[v] - o[v]) - (b[u] - o[u]) * (a[v] - o[v]);
    }
  }
  return normal;
}

/// The one nearest to the normal first; equal ones from z on.
std::array<std::size_t, 3> axes_by_nearness(const std::array<double, 3>& normal) {
  std::array<std::size_t, 3> axes{2, 1, 0};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(normal[a]) > std::abs(normal[b]); });
  return axes;
}

std::vector<Kernel::Point_2> seen_along(const std::vector<Point3>& corners, std::size_t axis) {
  std::vector<Kernel::Point_2> seen;
  for (const Point3& corner : corners) {
    const auto p = numbers(corner);
    seen.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  }
  return seen;
}

CornerTriangles halves(Corner from) { return {{from, from + 1, from + 2}, {from, from + 2, (from + 3) % 4}}; }

/// Along the diagonal that begins at corner 0 or 1.
bool lies_inside(Corner from, const std::vector<Kernel::Point_2>& seen, double sense) {
  const auto wanted = sense > 0 ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN;
  for (const auto& [a, b, c] : halves(from)) {
    if (CGAL::orientation(seen[a], seen[b], seen[c]) != wanted) return false;
  }
  return true;
}

double squared_distance(const Point3& a, const Point3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

std::optional<CornerTriangles> cut_four(const std::vector<Point3>& corners, std::size_t axis, double sense) {
  const auto seen = seen_along(corners, axis);
  const bool first = lies_inside(0, seen, sense), second = lies_inside(1, seen, sense);
  if (!first && !second) return std::nullopt;
  const bool shorter = squared_distance(corners[1], corners[3]) < squared_distance(corners[0], corners[2]);
  return halves(second && (!first || shorter) ? 1 : 0);
}

/// Edges by their corners, the lesser first, and how often they run that way rather than the other.
using Balance = std::map<std::pair<Corner, Corner>, int>;
void count(Balance& balance, Corner a, Corner b, int times) {
  if (a < b)
    balance[{a, b}] += times;
  else
    balance[{b, a}] -= times;
}

/// Cuts what is seen along one axis.
class ManyCorners {
 public:
  ManyCorners(const std::vector<Point3>& corners, std::size_t axis)
      : corners_(corners), seen_(seen_along(corners, axis)) {}

  /// Nothing if the polygon meets itself otherwise than in corners and along its own edges.
  std::optional<CornerTriangles> cut() {
    if (!insert() || triangulation_.dimension() < 2) return std::nullopt;
    tell_inside();
    CornerTriangles triangles;
    for (const auto face : triangulation_.finite_face_handles()) {
      if (face->info().inside)
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    if (triangles.size() != corners_.size() - 2) return std::nullopt;
    std::sort(triangles.begin(), triangles.end());
    if (is_bounded_by_polygon(triangles)) return triangles;
    for (auto& t : triangles) std::swap(t[1], t[2]);
    return is_bounded_by_polygon(triangles) ? std::optional(triangles) : std::nullopt;
  }

 private:
  bool insert() {
    Triangulation::Face_handle near;
    std::vector<Triangulation::Vertex_handle> vertices;
    for (Corner i = 0; i < corners_.size(); ++i) {
      const std::size_t before = triangulation_.number_of_vertices();
      const auto vertex = triangulation_.insert(seen_[i], near);
      near = vertex->face();
      if (triangulation_.number_of_vertices() > before) vertex->info() = i;
      // Two corners one behind the other are no corner of a plane figure.
      if (!(corners_[vertex->info()] == corners_[i])) return false;
      vertices.push_back(vertex);
      first_at_place_.push_back(vertex->info());
    }
    try {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto from = vertices[i], to = vertices[(i + 1) % vertices.size()];
        if (from == to) continue;
        triangulation_.insert_constraint(from, to);
        ++times_[std::minmax(from->info(), to->info())];
      }
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  bool is_border(Triangulation::Face_handle face, int i) const {
    const auto edge = times_.find(
        std::minmax(face->vertex(Triangulation::ccw(i))->info(), face->vertex(Triangulation::cw(i))->info()));
    return edge != times_.end() && edge->second % 2 != 0;
  }

  /// From outside in; what is passed twice (a bridge to a hole) parts nothing.
  void tell_inside() {
    triangulation_.infinite_vertex()->info() = nobody;
    std::vector<Triangulation::Face_handle> open{triangulation_.infinite_face()};
    open.front()->info().visited = true;
    while (!open.empty()) {
      const auto face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto beyond = face->neighbor(i);
        if (beyond->info().visited) continue;
        beyond->info() = {true, face->info().inside != is_border(face, i)};
        open.push_back(beyond);
      }
    }
  }

  bool is_bounded_by_polygon(const CornerTriangles& triangles) const {
    Balance balance;
    for (std::size_t i = 0; i < first_at_place_.size(); ++i)
      count(balance, first_at_place_[i], first_at_place_[(i + 1) % first_at_place_.size()], 1);
    for (const auto& [a, b, c] : triangles) {
      count(balance, a, b, -1);
      count(balance, b, c, -1);
      count(balance, c, a, -1);
    }
    return std::all_of(balance.begin(), balance.end(),
                       [](const auto& edge) { return edge.first.first == edge.first.second || edge.second == 0; });
  }

  const std::vector<Point3>& corners_;
  std::vector<Kernel::Point_2> seen_;
  Triangulation triangulation_;
  std::vector<Corner> first_at_place_;
  std::map<std::pair<Corner, Corner>, int> times_;
};

CornerTriangles fan(std::size_t corners) {
  CornerTriangles triangles;
  for (Corner i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

void measure(const std::vector<Point3>& corners, const std::array<double, 3>& normal, CutPolygon& cut) {
  std::array<double, 3> middle{}, low = numbers(corners.front()), high = low;
  for (const Point3& corner : corners) {
    const auto p = numbers(corner);
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] += p[k] / static_cast<double>(corners.size());
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) cut.size = std::max(cut.size, high[k] - low[k]);
  const double length = portable::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0)) return;
  for (const Point3& corner : corners) {
    const auto p = numbers(corner);
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) off += (p[k] - middle[k]) * normal[k] / length;
    cut.off_plane = std::max(cut.off_plane, std::abs(off));
  }
}

}  // namespace

CutPolygon cut_polygon(const std::vector<Point3>& corners) {
  CutPolygon cut;
  if (corners.size() == 3) {
    cut.triangles = fan(3);
    return cut;
  }
  const std::array<double, 3> normal = newell_normal(corners);
  measure(corners, normal, cut);
  for (const std::size_t axis : axes_by_nearness(normal)) {
    const auto triangles =
        corners.size() == 4 ? cut_four(corners, axis, normal[axis]) : ManyCorners(corners, axis).cut();
    if (!triangles) continue;
    cut.triangles = *triangles;
    return cut;
  }
  cut.fan = true;
  cut.triangles = fan(corners.size());
  return cut;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> cut_along_diagonal(const std::vector<Point3>& corners,
                                                                            std::uint32_t from) {
  const std::array<double, 3> normal = newell_normal(corners);
  const std::size_t axis = axes_by_nearness(normal).front();
  if (!lies_inside(from, seen_along(corners, axis), normal[axis])) return std::nullopt;
  return halves(from);
}

}  // namespace odontoscope
