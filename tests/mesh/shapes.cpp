#include "tests/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "recon/mesh/append.h"

namespace odontoscope::shapes {
namespace {

void add_quad(SurfaceMesh& mesh, PointIndex a, PointIndex b, PointIndex c, PointIndex d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

PointIndex index(std::size_t i) { return static_cast<PointIndex>(i); }

/// Renumbers the vertices of `mesh` so that `from[i]` becomes `to[i]`; the old ones stay unused.
SurfaceMesh identified(SurfaceMesh mesh, const std::map<PointIndex, PointIndex>& renamed) {
  for (Triangle& t : mesh.triangles) {
    for (PointIndex& v : t) {
      if (const auto found = renamed.find(v); found != renamed.end()) v = found->second;
    }
  }
  return mesh;
}

}  // namespace

SurfaceMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

SurfaceMesh cube(double x, double y, double z, double side) {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back({x + side * (i & 1), y + side * (i >> 1 & 1), z + side * (i >> 2 & 1)});
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

SurfaceMesh sphere(double radius, int levels) {
  SurfaceMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<PointIndex, PointIndex>, PointIndex> middles;
    const auto middle = [&](PointIndex a, PointIndex b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), index(mesh.points.size()));
      if (fresh) {
        const Point3 p = mesh.points[a], q = mesh.points[b];
        mesh.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      }
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const auto [a, b, c] : mesh.triangles) {
      const PointIndex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back(t);
    }
    mesh.triangles = std::move(finer);
  }
  for (Point3& p : mesh.points) {
    const double scale = radius / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    p = {p.x * scale, p.y * scale, p.z * scale};
  }
  return mesh;
}

SurfaceMesh torus(double radius, double tube, std::size_t around, std::size_t across) {
  SurfaceMesh mesh;
  const double full = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t j = 0; j < across; ++j) {
      const double u = full * static_cast<double>(i) / static_cast<double>(around);
      const double v = full * static_cast<double>(j) / static_cast<double>(across);
      const double r = radius + tube * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
    }
  }
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t j = 0; j < across; ++j) {
      const std::size_t i1 = (i + 1) % around, j1 = (j + 1) % across;
      add_quad(mesh, index(i * across + j), index(i1 * across + j), index(i1 * across + j1), index(i * across + j1));
    }
  }
  return mesh;
}

SurfaceMesh column(const ColumnOptions& options) {
  SurfaceMesh mesh;
  const std::size_t n = options.around;
  for (std::size_t layer = 0; layer < options.layers; ++layer) {
    const std::size_t shape = options.terraced ? layer / 2 * 2 : layer;
    const std::size_t height = options.terraced ? (layer + 1) / 2 : layer;
    const double along = static_cast<double>(shape) / static_cast<double>(options.layers);
    for (std::size_t i = 0; i < n; ++i) {
      const double u = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double r = 10 + 4 * std::sin(3 * along) + 1.5 * std::cos(3 * u + 2 * along);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), static_cast<double>(height)});
    }
  }
  const PointIndex bottom = index(mesh.points.size()), top = bottom + 1;
  mesh.points.push_back({0, 0, mesh.points.front().z});
  mesh.points.push_back({0, 0, mesh.points[options.layers * n - 1].z});
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n, last = (options.layers - 1) * n;
    mesh.triangles.push_back({bottom, index(j), index(i)});
    mesh.triangles.push_back({top, index(last + i), index(last + j)});
    for (std::size_t below = 0; below < last; below += n) {
      add_quad(mesh, index(below + i), index(below + j), index(below + n + j), index(below + n + i));
    }
  }
  return mesh;
}

SurfaceMesh inside_out(SurfaceMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

SurfaceMesh together(const SurfaceMesh& a, const SurfaceMesh& b) {
  SurfaceMesh both = a;
  append(b, both);
  return both;
}

SurfaceMesh moved(SurfaceMesh mesh, double x, double y, double z) {
  for (Point3& p : mesh.points) p = {p.x + x, p.y + y, p.z + z};
  return mesh;
}

SurfaceMesh holed(SurfaceMesh mesh, std::size_t which) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(which));
  return mesh;
}

SurfaceMesh flipped(SurfaceMesh mesh, std::size_t which) {
  std::swap(mesh.triangles[which][1], mesh.triangles[which][2]);
  return mesh;
}

SurfaceMesh cubes_on_one_edge() {
  // Corners 3 and 7 of the first are corners 0 and 4 of the second.
  return identified(together(cube(), cube(1, 1, 0)), {{8, 3}, {12, 7}});
}

SurfaceMesh cubes_on_one_vertex() { return identified(together(cube(), cube(1, 1, 1)), {{8, 7}}); }

SurfaceMesh moebius_strip(std::size_t n) {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    for (const double w : {-1.0, 1.0}) {
      const double r = 5 + w * std::cos(u / 2);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), w * std::sin(u / 2)});
    }
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    add_quad(mesh, index(2 * i), index(2 * i + 2), index(2 * i + 3), index(2 * i + 1));
  add_quad(mesh, index(2 * n - 2), 1, 0, index(2 * n - 1));
  return mesh;
}

TetraMesh cube_of_five() {
  TetraMesh mesh;
  mesh.points = cube().points;
  mesh.tetrahedra = {{0, 3, 6, 5}, {1, 0, 3, 5}, {2, 0, 6, 3}, {4, 0, 5, 6}, {7, 3, 5, 6}};
  for (Tetrahedron& t : mesh.tetrahedra) {
    const Point3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
    const double det = (b.x - a.x) * ((c.y - a.y) * (d.z - a.z) - (c.z - a.z) * (d.y - a.y)) -
                       (b.y - a.y) * ((c.x - a.x) * (d.z - a.z) - (c.z - a.z) * (d.x - a.x)) +
                       (b.z - a.z) * ((c.x - a.x) * (d.y - a.y) - (c.y - a.y) * (d.x - a.x));
    if (det < 0) std::swap(t[2], t[3]);
  }
  mesh.labels.assign(5, 1);
  return mesh;
}

TetraMesh regular_tetrahedron() {
  const double h = std::sqrt(3.0) / 2, third = h / 3, height = std::sqrt(2.0 / 3);
  return {{{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, third, height}}, {{0, 1, 2, 3}}, {1}};
}

}  // namespace odontoscope::shapes
