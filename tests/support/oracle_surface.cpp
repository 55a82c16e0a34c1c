#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "tests/support/oracle_parts.h"

namespace odontoscope::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;
using DirectedEdge = std::array<PointIndex, 2>;
using ExactPoint = std::array<Exact, 3>;

ExactPoint exact(const Point3& p) { return {Exact(p.x), Exact(p.y), Exact(p.z)}; }

/// Six times the signed volume between the triangle and `apex`.
Exact six_volumes(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& apex) {
  ExactPoint u, v, w;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = a[i] - apex[i];
    v[i] = b[i] - apex[i];
    w[i] = c[i] - apex[i];
  }
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

std::vector<ExactPoint> exact_points(const TetraMesh& mesh) {
  std::vector<ExactPoint> points;
  for (const Point3& p : mesh.points) points.push_back(exact(p));
  return points;
}

std::map<DirectedEdge, std::size_t> triangle_at_edges(const std::vector<Triangle>& triangles) {
  std::map<DirectedEdge, std::size_t> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) at[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  return at;
}

/// For each triangle the number of its shell, through shared edges.
std::vector<std::size_t> shells_by_edges(const std::vector<Triangle>& triangles, std::size_t& count) {
  const auto at = triangle_at_edges(triangles);
  std::vector<std::size_t> shell(triangles.size(), triangles.size());
  count = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (shell[seed] != triangles.size()) continue;
    std::vector<std::size_t> open{seed};
    shell[seed] = count;
    while (!open.empty()) {
      const Triangle t = triangles[open.back()];
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = at.at({t[(i + 1) % 3], t[i]});
        if (shell[next] == triangles.size()) {
          shell[next] = count;
          open.push_back(next);
        }
      }
    }
    ++count;
  }
  return shell;
}

/// How a ray from `eye` to `far` passes the triangle: 1 out through it, -1 in, 0 beside it; none if it meets an edge, a
/// corner, or lies in its plane.
std::optional<int> passes(const ExactPoint& eye, const ExactPoint& far, const ExactPoint& a, const ExactPoint& b,
                          const ExactPoint& c) {
  const auto sign = [](const Exact& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  const int here = sign(six_volumes(a, b, c, eye)), there = sign(six_volumes(a, b, c, far));
  if (here != 0 && here == there) return 0;
  const int sides[] = {sign(six_volumes(far, a, b, eye)), sign(six_volumes(far, b, c, eye)),
                       sign(six_volumes(far, c, a, eye))};
  const bool left = std::count(std::begin(sides), std::end(sides), 1) > 0,
             right = std::count(std::begin(sides), std::end(sides), -1) > 0;
  if (left && right) return 0;
  if (here == 0 || there == 0 || std::count(std::begin(sides), std::end(sides), 0) > 0) return std::nullopt;
  return here;
}

/// How often the other shells wind round a point of this one: outside of all of them 0, in the material of one 1.
/// Exact: what a ray to far away passes; doubles only say what lies clearly beside it.
long winding_of_others(const std::vector<ExactPoint>& points, const TetraMesh& mesh,
                       const std::vector<Triangle>& triangles, const std::vector<std::size_t>& shell, std::size_t of) {
  const std::size_t first = std::size_t(std::find(shell.begin(), shell.end(), of) - shell.begin());
  const PointIndex at = triangles[first][0];
  const Point3 eye = mesh.points[at];
  double reach = 0;
  for (const Point3& p : mesh.points)
    reach = std::max({reach, std::abs(p.x - eye.x), std::abs(p.y - eye.y), std::abs(p.z - eye.z)});
  for (double lean = 0.1234567; lean < 1; lean *= 1.0371) {  // until nothing is met at an edge
    const double across = 0.7310585 * lean;
    const Exact beyond = 4 * Exact(reach);
    const ExactPoint far{points[at][0] + Exact(lean) * beyond, points[at][1] + Exact(across) * beyond,
                         points[at][2] + beyond};
    const auto beside = [&](PointIndex v) {
      const Point3& p = mesh.points[v];
      return std::array{(p.x - eye.x) - lean * (p.z - eye.z), (p.y - eye.y) - across * (p.z - eye.z)};
    };
    long winding = 0;
    bool clear = true;
    for (std::size_t t = 0; t < triangles.size() && clear; ++t) {
      if (shell[t] == of) continue;
      const auto [a, b, c] = triangles[t];
      const std::array off{beside(a), beside(b), beside(c)};
      const double slack = 1e-9 * reach;
      const auto apart = [&](std::size_t k) {
        const auto [low, high] = std::minmax({off[0][k], off[1][k], off[2][k]});
        return low > slack || high < -slack;
      };
      if (apart(0) || apart(1)) continue;
      const std::optional<int> passed = passes(points[at], far, points[a], points[b], points[c]);
      clear = passed.has_value();
      winding += passed.value_or(0);
    }
    if (clear) return winding;
  }
  return std::numeric_limits<long>::max();
}

}  // namespace

std::vector<Triangle> surface_in_solid(const Solid& solid, Faults& faults) {
  const auto& inner = solid.tetrahedra.points;
  std::vector<PointIndex> number;
  std::size_t next = 0;
  for (const Point3& p : solid.surface.points) {
    while (next < inner.size() && !(inner[next] == p)) ++next;
    if (next == inner.size()) {
      faults.add("the surface's points are not points of the solid in the same order");
      return {};
    }
    number.push_back(PointIndex(next++));
  }
  std::vector<Triangle> triangles;
  std::set<PointIndex> used;
  for (const Triangle& t : solid.surface.triangles) {
    Triangle mapped;
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] >= number.size()) {
        faults.add("an index beyond the surface's points");
        return {};
      }
      mapped[i] = number[t[i]];
      used.insert(t[i]);
    }
    std::rotate(mapped.begin(), std::min_element(mapped.begin(), mapped.end()), mapped.end());
    triangles.push_back(mapped);
  }
  if (used.size() != solid.surface.points.size()) faults.add("a point that no triangle of the surface uses");
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

bool judge_manifold(const std::vector<Triangle>& triangles, Faults& faults) {
  std::map<DirectedEdge, int> count;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++count[{t[i], t[(i + 1) % 3]}];
  bool good = !triangles.empty();
  for (const auto& [edge, times] : count) {
    const auto back = count.find({edge[1], edge[0]});
    if (times == 1 && back != count.end() && back->second == 1) continue;
    faults.add(times > 1 ? "a surface edge that is not manifold" : "a surface edge that is open or misoriented");
    good = false;
  }
  if (!good) return false;
  const auto at = triangle_at_edges(triangles);
  std::map<PointIndex, std::size_t> degree;
  for (const Triangle& t : triangles)
    for (PointIndex v : t) ++degree[v];
  std::set<PointIndex> walked;
  for (const Triangle& start : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const PointIndex v = start[i];
      if (!walked.insert(v).second) continue;
      std::size_t steps = 0;
      PointIndex spoke = start[(i + 1) % 3];
      do {  // across the edge v-spoke into the next triangle round v
        const Triangle& t = triangles[at.at({spoke, v})];
        const std::size_t j = std::size_t(std::find(t.begin(), t.end(), v) - t.begin());
        spoke = t[(j + 1) % 3];
        ++steps;
      } while (spoke != start[(i + 1) % 3]);
      if (steps != degree[v]) {
        faults.add("a surface vertex with more than one fan");
        good = false;
      }
    }
  return good;
}

std::vector<JudgedShell> judge_shells(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults) {
  std::size_t count = 0;
  const std::vector<std::size_t> shell = shells_by_edges(triangles, count);
  const std::vector<ExactPoint> points = exact_points(mesh);
  const ExactPoint origin{Exact(0), Exact(0), Exact(0)};
  std::vector<JudgedShell> shells;
  for (std::size_t s = 0; s < count; ++s) {
    std::set<PointIndex> vertices;
    std::size_t faces = 0;
    Exact six = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (shell[t] != s) continue;
      const auto [a, b, c] = triangles[t];
      vertices.insert({a, b, c});
      ++faces;
      six += six_volumes(points[a], points[b], points[c], origin);
    }
    const long euler = long(vertices.size()) - long(faces * 3 / 2) + long(faces);
    const Shell::Kind kind = six > 0 ? Shell::Kind::external : six < 0 ? Shell::Kind::cavity : Shell::Kind::open;
    if (euler % 2 != 0 || kind == Shell::Kind::open) faults.add("a shell that encloses nothing");
    shells.push_back({kind, (2 - euler) / 2, CGAL::to_double(six) / 6});
    if (winding_of_others(points, mesh, triangles, shell, s) != (kind == Shell::Kind::external ? 0 : 1))
      faults.add("shells that are not nested as material and cavities");
  }
  return shells;
}

void judge_self_intersections(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults) {
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  std::map<PointIndex, CGAL::SM_Vertex_index> vertex;
  for (const Triangle& t : triangles) {
    std::array<CGAL::SM_Vertex_index, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = vertex.find(t[i]);
      const Point3 p = mesh.points[t[i]];
      corner[i] = found != vertex.end() ? found->second
                                        : vertex.emplace(t[i], surface.add_vertex({p.x, p.y, p.z})).first->second;
    }
    if (surface.add_face(corner[0], corner[1], corner[2]) == surface.null_face()) {
      faults.add("CGAL refuses the surface as a half-edge mesh");
      return;
    }
  }
  if (CGAL::Polygon_mesh_processing::does_self_intersect(surface)) faults.add("the surface meets itself");
}

void judge_volume(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults) {
  const std::vector<ExactPoint> points = exact_points(mesh);
  const ExactPoint origin{Exact(0), Exact(0), Exact(0)};
  Exact of_tetrahedra = 0, of_surface = 0;
  // Positive: d on the side from which abc is counter-clockwise, so seen from d as apex the sign turns.
  for (const auto& [a, b, c, d] : mesh.tetrahedra)
    of_tetrahedra -= six_volumes(points[a], points[b], points[c], points[d]);
  for (const auto& [a, b, c] : triangles) of_surface += six_volumes(points[a], points[b], points[c], origin);
  if (of_tetrahedra != of_surface) faults.add("the tetrahedra's volume is not what the surface encloses");
}

}  // namespace odontoscope::test
