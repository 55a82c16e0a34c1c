#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
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

/// The solid angle under which the triangle is seen (van Oosterom and Strackee 1983), positive from within an outward one.
double solid_angle(Point3 a, Point3 b, Point3 c, Point3 eye) {
  const auto from_eye = [&](Point3 p) { return Point3{p.x - eye.x, p.y - eye.y, p.z - eye.z}; };
  const auto dot = [](Point3 u, Point3 v) { return u.x * v.x + u.y * v.y + u.z * v.z; };
  const Point3 u = from_eye(a), v = from_eye(b), w = from_eye(c);
  const double lu = std::sqrt(dot(u, u)), lv = std::sqrt(dot(v, v)), lw = std::sqrt(dot(w, w));
  const Point3 cross{v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
  return 2 * std::atan2(dot(u, cross), lu * lv * lw + dot(u, v) * lw + dot(u, w) * lv + dot(v, w) * lu);
}

/// How often the other shells wind round a point of this one: outside of all of them 0, in the material of one 1.
long winding_of_others(const TetraMesh& mesh, const std::vector<Triangle>& triangles,
                       const std::vector<std::size_t>& shell, std::size_t of) {
  const std::size_t first = std::size_t(std::find(shell.begin(), shell.end(), of) - shell.begin());
  const Point3 eye = mesh.points[triangles[first][0]];
  double reach = 0;   // brought to about 1 below: products of three minute lengths would be 0
  for (const Point3& p : mesh.points) reach = std::max({reach, std::abs(p.x - eye.x), std::abs(p.y - eye.y), std::abs(p.z - eye.z)});
  const auto seen = [&, exponent = -std::ilogb(reach)](PointIndex v) {
    const Point3& p = mesh.points[v];
    return Point3{std::scalbn(p.x - eye.x, exponent), std::scalbn(p.y - eye.y, exponent), std::scalbn(p.z - eye.z, exponent)};
  };
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (shell[t] != of) sum += solid_angle(seen(triangles[t][0]), seen(triangles[t][1]), seen(triangles[t][2]), {0, 0, 0});
  return std::lround(sum / (4 * std::numbers::pi));
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
      do {   // across the edge v-spoke into the next triangle round v
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
    if (winding_of_others(mesh, triangles, shell, s) != (kind == Shell::Kind::external ? 0 : 1))
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
  for (const auto& [a, b, c, d] : mesh.tetrahedra) of_tetrahedra -= six_volumes(points[a], points[b], points[c], points[d]);
  for (const auto& [a, b, c] : triangles) of_surface += six_volumes(points[a], points[b], points[c], origin);
  if (of_tetrahedra != of_surface) faults.add("the tetrahedra's volume is not what the surface encloses");
}

}  // namespace odontoscope::test
