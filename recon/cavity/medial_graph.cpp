#include "recon/cavity/medial_graph.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/cavity/limits.h"
#include "recon/core/portable_math.h"
#include "recon/core/spatial_order.h"

namespace odontoscope::cavity {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();
/// Times that a way is halved to see whether it stays in the void.
constexpr int way_halvings = 3;
/// A centre that is nearer to the wall than this share of its sphere's radius belongs to a flat tetrahedron beside the
/// wall.
constexpr double least_clear = 0.25;

struct Sphere {
  Point3 centre;
  double radius, volume;
};

/// Nothing for a tetrahedron so flat that its centre is out of reach.
std::optional<Sphere> circumsphere(const std::array<Point3, 4>& p) {
  const Direction a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Direction bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double det = dot(a, bc), aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  constexpr double flat = 1e-9;
  if (!(std::abs(det) > flat * std::sqrt(aa * bb * cc))) return std::nullopt;
  const Direction offset = (0.5 / det) * (aa * bc + bb * ca + cc * ab);
  return Sphere{{p[0].x + offset.x, p[0].y + offset.y, p[0].z + offset.z}, length(offset), std::abs(det) / 6};
}

/// The union of two balls that touch holds the line between their centres.
bool stays_inside(const WallTree& tree, const Point3& a, double a_radius, const Point3& b, double b_radius,
                  int halvings) {
  const Direction way = b - a;
  if (length(way) <= a_radius + b_radius) return true;
  if (halvings == 0) return false;
  const Point3 middle{a.x + way.x / 2, a.y + way.y / 2, a.z + way.z / 2};
  const double radius = tree.clearance(middle);
  return radius > 0 && stays_inside(tree, a, a_radius, middle, radius, halvings - 1) &&
         stays_inside(tree, middle, radius, b, b_radius, halvings - 1);
}

/// A point of the wall that the triangulation sees.
struct Sample {
  Point3 at;
  Direction normal;    // into the void; any length
  double spacing = 0;  // longest edge that ends here
};

/// Halves the longest edge until it is short enough.
void divide(const std::array<Point3, 3>& corners, const Direction& normal, double longest,
            std::vector<Sample>& samples) {
  std::size_t k = 0;
  std::array<double, 3> edges{};
  for (std::size_t e = 0; e < 3; ++e) {
    edges[e] = length(corners[(e + 1) % 3] - corners[e]);
    if (edges[e] > edges[k]) k = e;
  }
  if (edges[k] <= longest) return;
  const Point3 &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
  const Point3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  samples.push_back({middle, normal, longest});
  divide({a, middle, c}, normal, longest, samples);
  divide({middle, b, c}, normal, longest, samples);
}

/// As a GLB holds it: metres, in single precision. Contours lie on lattices, so that many points lie on one sphere
/// exactly, and how those are triangulated decides between ways of nearly one length: a tooth and its file are to have
/// the same.
Point3 as_in_a_file(const Point3& p) {
  constexpr double mm = 1000;  // in a metre
  const auto rounded = [](double x) { return mm * static_cast<double>(static_cast<float>(x / mm)); };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

std::vector<Sample> samples_of(const SurfaceMesh& wall) {
  std::vector<Sample> samples;
  std::vector<Point3> points;
  for (const Point3& p : wall.points) points.push_back(as_in_a_file(p));
  for (const Point3& p : points) samples.push_back({p, {}, 0});
  std::vector<Direction> normals;
  double area = 0;
  for (const Triangle& t : wall.triangles) {
    normals.push_back(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    area += length(normals.back()) / 2;
  }
  constexpr double of_even_triangles = 0.8660254;  // area a point stands for, over the square of the edge
  const double longest = 2 * std::sqrt(area / (of_even_triangles * limits::wall_samples));
  for (std::size_t n = 0; n < wall.triangles.size(); ++n) {
    const Triangle& t = wall.triangles[n];
    const std::array corners{points[t[0]], points[t[1]], points[t[2]]};
    const double size = length(normals[n]);
    const Direction unit = size > 0 ? (1 / size) * normals[n] : Direction{};
    for (std::size_t k = 0; k < 3; ++k) {
      Sample& sample = samples[t[k]];
      const Direction u = corners[(k + 1) % 3] - corners[k], v = corners[(k + 2) % 3] - corners[k];
      const double angle = portable::atan2(size, dot(u, v));
      sample.normal = sample.normal + angle * unit;
      sample.spacing = std::max({sample.spacing, std::min(length(u), longest), std::min(length(v), longest)});
    }
    divide(corners, unit, longest, samples);
  }
  return samples;
}

/// In front of how many of its corners' wall does a centre lie?
int in_front_of_corners(const std::array<const Sample*, 4>& corners, const Point3& centre) {
  int front = 0;
  for (const Sample* corner : corners) front += dot(centre - corner->at, corner->normal) > 0 ? 1 : 0;
  return front;
}

/// Distance of a tetrahedron's circumcentre to the wall; nothing if it lies outside the void or in a corner of it. No
/// sample lies in the circumsphere, so that triangles with edges of length e reach into it no farther than to sqrt(R^2
/// - e^2 / 3): where that says enough, the wall is not asked.
std::optional<double> radius_of(const std::array<const Sample*, 4>& corners, const Sphere& sphere,
                                const WallTree& tree) {
  constexpr double fine_enough = 0.5;  // of the radius: the rest is right to 4 %
  double edge = 0;
  for (const Sample* corner : corners) edge = std::max(edge, corner->spacing);
  const int front = in_front_of_corners(corners, sphere.centre);
  if (front < 2) return std::nullopt;
  if (front == 4 && edge <= fine_enough * sphere.radius)
    return std::sqrt(sphere.radius * sphere.radius - edge * edge / 3);
  const double least = least_clear * sphere.radius, radius = tree.clearance_above(sphere.centre, least, sphere.radius);
  if (!(radius > least)) return std::nullopt;
  return radius;
}

/// Inserted in an order of our own: that of the cells, and so which of a cell's corners its centre is reckoned from,
/// would otherwise be the library's.
Delaunay triangulated(const std::vector<Point3>& points) {
  Delaunay delaunay;
  Delaunay::Cell_handle near;
  for (const std::uint32_t i : spatial_order(points)) {
    const auto vertex = delaunay.insert(Kernel::Point_3(points[i].x, points[i].y, points[i].z), near);
    vertex->info() = i;
    near = vertex->cell();
  }
  return delaunay;
}

}  // namespace

MedialGraph medial_graph(const SurfaceMesh& wall, const WallTree& tree, const Progress& progress) {
  const std::vector<Sample> samples = samples_of(wall);
  std::vector<Point3> points;
  points.reserve(samples.size());
  Point3 low = wall.points.front(), high = low;
  for (const Sample& sample : samples) {
    const Point3& p = sample.at;
    points.push_back(p);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Delaunay delaunay = triangulated(points);
  progress.check();
  MedialGraph graph;
  std::vector<Delaunay::Cell_handle> cells;
  for (const auto& cell : delaunay.finite_cell_handles()) {
    cell->info() = unnumbered;
    std::array<const Sample*, 4> corners{};
    for (int k = 0; k < 4; ++k) corners[static_cast<std::size_t>(k)] = &samples[cell->vertex(k)->info()];
    const auto sphere = circumsphere({corners[0]->at, corners[1]->at, corners[2]->at, corners[3]->at});
    if (!sphere) continue;
    const Point3& c = sphere->centre;
    if (!(c.x > low.x && c.y > low.y && c.z > low.z && c.x < high.x && c.y < high.y && c.z < high.z)) continue;
    const std::optional<double> radius = radius_of(corners, *sphere, tree);
    if (!radius) continue;
    cell->info() = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.push_back({c, *radius, sphere->volume});
    cells.push_back(cell);
  }
  progress.check();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t n = 0; n < cells.size(); ++n) {
    for (int k = 0; k < 4; ++k) {
      const auto neighbour = cells[n]->neighbor(k);
      if (delaunay.is_infinite(neighbour)) continue;
      const std::uint32_t m = neighbour->info();
      if (m == unnumbered || m < n) continue;
      if (stays_inside(tree, graph.nodes[n].at, graph.nodes[n].radius, graph.nodes[m].at, graph.nodes[m].radius,
                       way_halvings)) {
        pairs.emplace_back(n, m);
        pairs.emplace_back(m, n);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  graph.first_way.assign(graph.nodes.size() + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++graph.first_way[from + 1];
    graph.ways.push_back({to, static_cast<float>(length(graph.nodes[to].at - graph.nodes[from].at))});
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) graph.first_way[n + 1] += graph.first_way[n];
  return graph;
}

}  // namespace odontoscope::cavity
