#include "recon/cavity/medial_graph.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace odontoscope::cavity {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_3<Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();
/// Times that a way is halved to see whether it stays in the void.
constexpr int way_halvings = 5;

struct Sphere {
  Point3 centre;
  double volume;
};

/// Nothing for a tetrahedron so flat that its centre is out of reach.
std::optional<Sphere> circumsphere(const std::array<Point3, 4>& p) {
  const Direction a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Direction bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double det = dot(a, bc), aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  constexpr double flat = 1e-9;
  if (!(std::abs(det) > flat * std::sqrt(aa * bb * cc))) return std::nullopt;
  const Direction offset = (0.5 / det) * (aa * bc + bb * ca + cc * ab);
  return Sphere{{p[0].x + offset.x, p[0].y + offset.y, p[0].z + offset.z}, std::abs(det) / 6};
}

/// The union of two balls that touch holds the line between their centres.
bool stays_inside(const WallTree& tree, const Point3& a, double a_radius, const Point3& b, double b_radius, int halvings) {
  const Direction way = b - a;
  if (length(way) <= a_radius + b_radius) return true;
  if (halvings == 0) return false;
  const Point3 middle{a.x + way.x / 2, a.y + way.y / 2, a.z + way.z / 2};
  const double radius = tree.clearance(middle);
  return radius > 0 && stays_inside(tree, a, a_radius, middle, radius, halvings - 1) &&
         stays_inside(tree, middle, radius, b, b_radius, halvings - 1);
}

Point3 plain(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

MedialGraph medial_graph(const SurfaceMesh& wall, const WallTree& tree, const Progress& progress) {
  std::vector<Kernel::Point_3> points;
  points.reserve(wall.points.size());
  Point3 low = wall.points.front(), high = low;
  for (const Point3& p : wall.points) {
    points.emplace_back(p.x, p.y, p.z);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Delaunay delaunay(points.begin(), points.end());
  progress.check();
  MedialGraph graph;
  std::vector<Delaunay::Cell_handle> cells;
  for (const auto& cell : delaunay.finite_cell_handles()) {
    cell->info() = no_node;
    const auto sphere = circumsphere({plain(cell->vertex(0)->point()), plain(cell->vertex(1)->point()), plain(cell->vertex(2)->point()),
                                      plain(cell->vertex(3)->point())});
    if (!sphere) continue;
    const Point3& c = sphere->centre;
    if (!(c.x > low.x && c.y > low.y && c.z > low.z && c.x < high.x && c.y < high.y && c.z < high.z)) continue;
    const double radius = tree.clearance(c);
    if (!(radius > 0)) continue;
    cell->info() = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.push_back({c, radius, sphere->volume});
    cells.push_back(cell);
  }
  progress.check();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t n = 0; n < cells.size(); ++n) {
    for (int k = 0; k < 4; ++k) {
      const auto neighbour = cells[n]->neighbor(k);
      if (delaunay.is_infinite(neighbour)) continue;
      const std::uint32_t m = neighbour->info();
      if (m == no_node || m < n) continue;
      if (stays_inside(tree, graph.nodes[n].at, graph.nodes[n].radius, graph.nodes[m].at, graph.nodes[m].radius, way_halvings)) {
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
