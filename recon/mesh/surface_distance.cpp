#include "recon/mesh/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "recon/mesh/vector.h"

namespace odontoscope {
namespace {

// Distances are measured in plain doubles: no decision hangs on them.
using DoubleKernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<DoubleKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<DoubleKernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<DoubleKernel, Primitive>>;

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
Triangles triangles_with_area(const SurfaceMesh& mesh) {
  Triangles triangles;
  const auto point = [&](PointIndex i) {
    return DoubleKernel::Point_3(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
  };
  for (const Triangle& t : mesh.triangles) {
    if (area(mesh, t) > 0) triangles.emplace_back(point(t[0]), point(t[1]), point(t[2]));
  }
  return triangles;
}

struct Share {
  double from, to;  // of the progress bar
};

std::vector<double> distances(const std::vector<Point3>& points, const Tree& tree, const Progress& progress,
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
      distance[i] = std::sqrt(tree.squared_distance({points[i].x, points[i].y, points[i].z}));
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

OneWayDistance one_way(const SurfaceMesh& from, const Tree& to, const DistanceOptions& options,
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

std::unique_ptr<Tree> tree_of(const Triangles& triangles) {
  auto tree = std::make_unique<Tree>(triangles.begin(), triangles.end());
  tree->build();
  tree->accelerate_distance_queries();  // before the threads start: queries then only read
  return tree;
}

}  // namespace

std::optional<OneWayDistance> distance_to_surface(const std::vector<Point3>& points, const SurfaceMesh& surface,
                                                  const Progress& progress) {
  const Triangles triangles = triangles_with_area(surface);
  if (triangles.empty() || points.empty()) return std::nullopt;
  const std::vector<double> distance = distances(points, *tree_of(triangles), progress, {0, 1});
  double sum = 0;
  for (const double d : distance) sum += d;
  return OneWayDistance{largest(distance), sum / static_cast<double>(distance.size())};
}

std::optional<SurfaceDistance> surface_distance(const SurfaceMesh& a, const SurfaceMesh& b,
                                                const DistanceOptions& options, const Progress& progress) {
  const Triangles of_a = triangles_with_area(a), of_b = triangles_with_area(b);
  if (of_a.empty() || of_b.empty()) return std::nullopt;
  progress.tell(distance_stage, 0);
  const auto tree_a = tree_of(of_a), tree_b = tree_of(of_b);
  progress.check();
  SurfaceDistance distance;
  distance.a_to_b = one_way(a, *tree_b, options, progress, {0, 0.5});
  distance.b_to_a = one_way(b, *tree_a, options, progress, {0.5, 1});
  return distance;
}

}  // namespace odontoscope
