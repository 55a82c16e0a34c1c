#include "recon/mesh/surface_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string_view>
#include <vector>

#include "recon/mesh/surface_tree.h"

namespace odontoscope {
namespace {

constexpr std::string_view distance_stage = "measure distance";

double area(const SurfaceMesh& mesh, const Triangle& t) {
  const Point3& a = mesh.points[t[0]];
  return length(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a)) / 2;
}

/// Fractional part of n / g and n / g^2, g the real root of x^3 = x + 1: the R2 sequence (Roberts 2018), folded into a
/// triangle.
Point3 point_in_triangle(const SurfaceMesh& mesh, const Triangle& t, std::size_t n) {
  constexpr double g = 1.32471795724474602596;
  double u = std::fmod(0.5 + static_cast<double>(n) / g, 1.0),
         v = std::fmod(0.5 + static_cast<double>(n) / (g * g), 1.0);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Point3& a = mesh.points[t[0]];
  const Direction offset = u * (mesh.points[t[1]] - a) + v * (mesh.points[t[2]] - a);
  return {a.x + offset.x, a.y + offset.y, a.z + offset.z};
}

std::vector<Point3> area_samples(const SurfaceMesh& mesh, std::size_t count) {
  double whole = 0;
  for (const Triangle& t : mesh.triangles) whole += area(mesh, t);
  std::vector<Point3> samples;
  if (!(whole > 0) || count == 0) return samples;
  samples.reserve(count + 1);
  const double step = whole / static_cast<double>(count);
  double passed = 0;
  for (const Triangle& t : mesh.triangles) {
    passed += area(mesh, t);
    while ((static_cast<double>(samples.size()) + 0.5) * step < passed) {
      samples.push_back(point_in_triangle(mesh, t, samples.size()));
    }
  }
  return samples;
}

std::vector<Point3> used_vertices(const SurfaceMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) used[t[0]] = used[t[1]] = used[t[2]] = 1;
  std::vector<Point3> vertices;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) vertices.push_back(mesh.points[v]);
  }
  return vertices;
}

/// Triangles that a distance can be measured to. Those without area are left out: their edges belong to others.
SurfaceTree tree_of(const SurfaceMesh& mesh) {
  SurfaceMesh with_area{mesh.points, {}};
  for (const Triangle& t : mesh.triangles)
    if (area(mesh, t) > 0) with_area.triangles.push_back(t);
  return SurfaceTree(with_area);
}

struct Share {
  double from, to;  // of the progress bar
};

std::vector<double> distances(const std::vector<Point3>& points, const SurfaceTree& tree, const Progress& progress,
                              Share share) {
  constexpr std::size_t chunk_size = 1024;
  std::vector<double> distance(points.size());
  const std::size_t chunks = (points.size() + chunk_size - 1) / chunk_size;
  std::atomic<std::size_t> done{0};
  std::mutex telling;
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
    if (progress.stop.stop_requested()) return;
    const std::size_t last = std::min(points.size(), (chunk + 1) * chunk_size);
    for (std::size_t i = chunk * chunk_size; i < last; ++i) {
      distance[i] = std::sqrt(tree.nearest(points[i]).square);
    }
    const double part = static_cast<double>(++done) / static_cast<double>(chunks);
    const std::lock_guard lock(telling);
    progress.tell(distance_stage, share.from + (share.to - share.from) * part);
  });
  progress.check();
  return distance;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

OneWayDistance one_way(const SurfaceMesh& from, const SurfaceTree& to, const DistanceOptions& options,
                       const Progress& progress, Share share) {
  const double middle = (share.from + share.to) / 2;
  const std::vector<double> over_area =
      distances(area_samples(from, options.samples), to, progress, {share.from, middle});
  const std::vector<double> at_vertices = distances(used_vertices(from), to, progress, {middle, share.to});
  double sum = 0;
  for (const double d : over_area) sum += d;
  return {std::max(largest(over_area), largest(at_vertices)),
          over_area.empty() ? 0 : sum / static_cast<double>(over_area.size())};
}

}  // namespace

std::optional<OneWayDistance> distance_to_surface(const std::vector<Point3>& points, const SurfaceMesh& surface,
                                                  const Progress& progress) {
  const SurfaceTree tree = tree_of(surface);
  if (tree.empty() || points.empty()) return std::nullopt;
  const std::vector<double> distance = distances(points, tree, progress, {0, 1});
  double sum = 0;
  for (const double d : distance) sum += d;
  return OneWayDistance{largest(distance), sum / static_cast<double>(distance.size())};
}

std::optional<SurfaceDistance> surface_distance(const SurfaceMesh& a, const SurfaceMesh& b,
                                                const DistanceOptions& options, const Progress& progress) {
  const SurfaceTree tree_a = tree_of(a), tree_b = tree_of(b);
  if (tree_a.empty() || tree_b.empty()) return std::nullopt;
  progress.tell(distance_stage, 0);
  progress.check();
  SurfaceDistance distance;
  distance.a_to_b = one_way(a, tree_b, options, progress, {0, 0.5});
  distance.b_to_a = one_way(b, tree_a, options, progress, {0.5, 1});
  return distance;
}

}  // namespace odontoscope
