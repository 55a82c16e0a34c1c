#include "recon/mesh/surface_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"
#include "recon/mesh/distribution.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/mesh/half_edges.h"
#include "recon/mesh/vector.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t no_shell = std::numeric_limits<std::uint32_t>::max();

/// Numbers the components in order of their first triangle. Edges with more than two triangles connect, too.
std::uint32_t number_shells(const SurfaceMesh& mesh, const EdgeMates& edges, std::vector<std::uint32_t>& shell_of) {
  shell_of.assign(mesh.triangles.size(), no_shell);
  std::vector<std::uint32_t> stack;
  std::uint32_t shells = 0;
  for (std::uint32_t seed = 0; seed < shell_of.size(); ++seed) {
    if (shell_of[seed] != no_shell) continue;
    const std::uint32_t shell = shells++;
    shell_of[seed] = shell;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        if (edges.mate[h] >= EdgeMates::no_edge || shell_of[edges.mate[h] / 3] != no_shell) continue;
        shell_of[edges.mate[h] / 3] = shell;
        stack.push_back(edges.mate[h] / 3);
      }
    }
  }
  if (edges.crowded.empty()) return shells;

  const auto same_edge = [&](HalfEdge a, HalfEdge b) {
    return std::minmax(start(mesh, a), end(mesh, a)) == std::minmax(start(mesh, b), end(mesh, b));
  };
  UnionFind joined(shells);
  for (std::size_t i = 1; i < edges.crowded.size(); ++i) {
    if (same_edge(edges.crowded[i - 1], edges.crowded[i]))
      joined.join(shell_of[edges.crowded[i - 1] / 3], shell_of[edges.crowded[i] / 3]);
  }
  std::vector<std::uint32_t> number(shells, no_shell);
  std::uint32_t count = 0;
  for (std::uint32_t& shell : shell_of) {
    std::uint32_t& renumbered = number[joined.find(shell)];
    if (renumbered == no_shell) renumbered = count++;
    shell = renumbered;
  }
  return count;
}

/// The corners of each vertex: how many, and one of them. Triangles that name a vertex twice are left out.
struct CornersByVertex {
  std::vector<HalfEdge> any;
  std::vector<std::uint32_t> count;
};

CornersByVertex corners_of(const SurfaceMesh& mesh) {
  CornersByVertex corners;
  corners.any.assign(mesh.points.size(), EdgeMates::none);
  corners.count.assign(mesh.points.size(), 0);
  for (HalfEdge h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (h % 3 == 0 && repeats_a_vertex(mesh.triangles[h / 3])) {
      h += 2;
      continue;
    }
    const PointIndex v = start(mesh, h);
    if (corners.count[v]++ == 0) corners.any[v] = h;
  }
  return corners;
}

/// Walks round a vertex from `corner`, leaving its triangle through the edge `through`; returns the corners passed
/// after the first. `closed` tells whether the walk came back to the start. Works for misoriented neighbours too.
std::uint32_t walk(const SurfaceMesh& mesh, const EdgeMates& edges, HalfEdge corner, HalfEdge through, bool& closed) {
  const PointIndex v = start(mesh, corner);
  std::uint32_t passed = 0;
  for (;;) {
    const HalfEdge entered = edges.mate[through];
    if (entered >= EdgeMates::no_edge) {
      closed = false;
      return passed;
    }
    const bool outgoing = start(mesh, entered) == v;
    const HalfEdge there = outgoing ? entered : next(entered);
    if (there == corner) {
      closed = true;
      return passed;
    }
    ++passed;
    through = outgoing ? previous(there) : there;
  }
}

/// One fan, open or full, of edges with at most two triangles.
bool is_one_fan(const SurfaceMesh& mesh, const EdgeMates& edges, HalfEdge corner, std::uint32_t corners) {
  bool closed = false;
  std::uint32_t passed = 1 + walk(mesh, edges, corner, corner, closed);
  if (!closed) passed += walk(mesh, edges, corner, previous(corner), closed);
  return passed == corners;
}

std::vector<char> singular_vertices(const SurfaceMesh& mesh, const EdgeMates& edges, const CornersByVertex& corners) {
  std::vector<char> singular(mesh.points.size(), 0);
  for (const HalfEdge h : edges.crowded) singular[start(mesh, h)] = singular[end(mesh, h)] = 1;
  for (std::size_t v = 0; v < singular.size(); ++v) {
    if (singular[v] || corners.count[v] == 0) continue;
    singular[v] = !is_one_fan(mesh, edges, corners.any[v], corners.count[v]);
  }
  return singular;
}

/// A vertex counts once in each shell that it belongs to.
void count_shell_vertices(const SurfaceMesh& mesh, const CornersByVertex& corners, const std::vector<char>& singular,
                          SurfaceReport& report) {
  std::vector<std::pair<std::uint32_t, PointIndex>> shared;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (corners.count[v] != 0 && !singular[v]) ++report.shells[report.shell_of[corners.any[v] / 3]].vertices;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const PointIndex v : mesh.triangles[t]) {
      if (singular[v] || repeats_a_vertex(mesh.triangles[t])) shared.emplace_back(report.shell_of[t], v);
    }
  }
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  for (const auto& [shell, v] : shared) ++report.shells[shell].vertices;
}

std::size_t count_used(const SurfaceMesh& mesh, const CornersByVertex& corners) {
  std::vector<char> used(mesh.points.size());
  for (std::size_t v = 0; v < used.size(); ++v) used[v] = corners.count[v] != 0;
  for (const Triangle& t : mesh.triangles) {
    if (repeats_a_vertex(t)) used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

/// What adds up over the triangles of a shell.
struct ShellSums {
  PointIndex origin = 0;  // volumes are taken from here: less cancellation than from (0, 0, 0)
  bool closed = true;
  double six_volumes = 0;
  double magnitude = 0;  // bounds the rounding error of six_volumes
};

/// Smallest angle in degrees, circumradius over twice the inradius, area: from the sides, stable for slivers.
void measure_triangle(const SurfaceMesh& mesh, std::size_t t, ShellSums& sums, Shell& shell,
                      std::vector<double>& angles, std::vector<double>& aspects, std::size_t& degenerate) {
  const auto [i, j, k] = mesh.triangles[t];
  const Point3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
  const Direction ab = b - a, ac = c - a, bc = c - b;
  const Direction normal = cross(ab, ac);
  const double twice_area = length(normal);
  const Direction from_origin = a - mesh.points[sums.origin];
  const double six_volumes = dot(from_origin, normal);
  shell.area += twice_area / 2;
  sums.six_volumes += six_volumes;
  sums.magnitude += (std::abs(from_origin.x) + std::abs(from_origin.y) + std::abs(from_origin.z)) *
                    std::sqrt(dot(ab, ab) * dot(ac, ac));
  if (collinear(a, b, c)) {
    ++degenerate;
    return;
  }
  double sides[3] = {length(ab), length(ac), length(bc)};
  std::sort(sides, sides + 3);
  // The smallest angle lies between the two longer sides and is at most 60 degrees, so its sine tells it.
  // Sides below 1e-154 leave no product: then it counts as 0.
  const double ratio = twice_area / (sides[1] * sides[2]);
  const double sine = ratio > 0 ? std::min(ratio, 1.0) : 0;
  angles.push_back(portable::asin(sine) * 180 / std::numbers::pi);
  const double semiperimeter = (sides[0] + sides[1] + sides[2]) / 2;
  const double aspect = sides[0] * sides[1] * sides[2] * semiperimeter / (2 * twice_area * twice_area);
  aspects.push_back(aspect < limits::largest_aspect_ratio ? aspect : limits::largest_aspect_ratio);
}

int sign_of_volume(const SurfaceMesh& mesh, const ShellSums& sums, std::uint32_t shell, const SurfaceReport& report) {
  const double terms = 16 + static_cast<double>(report.shells[shell].triangles);
  const double error = terms * std::numeric_limits<double>::epsilon() * sums.magnitude;
  if (std::abs(sums.six_volumes) > error) return sums.six_volumes > 0 ? 1 : -1;
  std::vector<std::size_t> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (report.shell_of[t] == shell) triangles.push_back(t);
  }
  return volume_sign(mesh, triangles);
}

void finish_shell(const SurfaceMesh& mesh, const ShellSums& sums, std::uint32_t number, SurfaceReport& report) {
  Shell& shell = report.shells[number];
  shell.volume = sums.six_volumes / 6;
  if (!sums.closed) return;
  const auto v = static_cast<long>(shell.vertices), f = static_cast<long>(shell.triangles);
  shell.genus = (2 - (v - f * 3 / 2 + f)) / 2;
  const int sign = sign_of_volume(mesh, sums, number, report);
  if (sign != 0) shell.kind = sign > 0 ? Shell::Kind::external : Shell::Kind::cavity;
}

void measure(const SurfaceMesh& mesh, const EdgeMates& edges, SurfaceReport& report) {
  std::vector<ShellSums> sums(report.shells.size());
  std::vector<double> angles, aspects;
  angles.reserve(mesh.triangles.size());
  aspects.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t number = report.shell_of[t];
    Shell& shell = report.shells[number];
    if (shell.triangles++ == 0) sums[number].origin = mesh.triangles[t][0];
    for (HalfEdge h = static_cast<HalfEdge>(3 * t); h < 3 * t + 3; ++h) {
      const HalfEdge mate = edges.mate[h];
      if (mate >= EdgeMates::no_edge || start(mesh, mate) == start(mesh, h)) sums[number].closed = false;
    }
    measure_triangle(mesh, t, sums[number], shell, angles, aspects, report.degenerate_triangles);
  }
  for (std::uint32_t i = 0; i < report.shells.size(); ++i) finish_shell(mesh, sums[i], i, report);
  report.smallest_angle_deg = distribution_of(angles, 0, limits::angle_histogram_high);
  report.aspect_ratio = distribution_of(aspects, 1, limits::aspect_histogram_high);
}

void sort_shells(SurfaceReport& report) {
  std::vector<std::uint32_t> order(report.shells.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return report.shells[a].area > report.shells[b].area; });
  std::vector<Shell> sorted;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.push_back(std::move(report.shells[order[i]]));
  }
  report.shells = std::move(sorted);
  for (std::uint32_t& shell : report.shell_of) shell = place[shell];
}

}  // namespace

bool SurfaceReport::closed_oriented_manifold() const {
  return triangles != 0 && boundary_edges == 0 && nonmanifold_edges == 0 && misoriented_edges == 0 &&
         nonmanifold_vertices == 0 && degenerate_triangles == 0;
}

SurfaceReport inspect(const SurfaceMesh& mesh) {
  const EdgeMates edges = edge_mates(mesh);
  const CornersByVertex corners = corners_of(mesh);
  SurfaceReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = count_used(mesh, corners);
  report.boundary_edges = edges.boundary_edges;
  report.nonmanifold_edges = edges.nonmanifold_edges;
  report.misoriented_edges = edges.misoriented_edges;
  report.shells.resize(number_shells(mesh, edges, report.shell_of));
  const std::vector<char> singular = singular_vertices(mesh, edges, corners);
  report.nonmanifold_vertices = static_cast<std::size_t>(std::count(singular.begin(), singular.end(), 1));
  count_shell_vertices(mesh, corners, singular, report);
  measure(mesh, edges, report);
  sort_shells(report);
  return report;
}

}  // namespace odontoscope
