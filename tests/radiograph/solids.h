#pragma once
// Closed surfaces and films by name, and chords found another way than the room finds them.

#include <cmath>
#include <limits>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/radiograph/film.h"

namespace odontoscope::test {

/// Outwards; every square is cut along one diagonal.
inline SurfaceMesh block(Point3 low, Point3 high) {
  SurfaceMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1u ? high.x : low.x, i & 2u ? high.y : low.y, i & 4u ? high.z : low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline SurfaceMesh turned_inside_out(SurfaceMesh mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Outwards, poles along z.
inline SurfaceMesh ball(Point3 centre, double radius, unsigned meridians = 96, unsigned rings = 64) {
  const double pi = std::acos(-1.0);
  SurfaceMesh mesh;
  mesh.points.push_back({centre.x, centre.y, centre.z - radius});
  for (unsigned r = 1; r < rings; ++r)
    for (unsigned m = 0; m < meridians; ++m) {
      const double down = pi * r / rings, round = 2 * pi * m / meridians;
      mesh.points.push_back({centre.x + radius * std::sin(down) * std::cos(round),
                             centre.y + radius * std::sin(down) * std::sin(round), centre.z - radius * std::cos(down)});
    }
  mesh.points.push_back({centre.x, centre.y, centre.z + radius});
  const auto at = [&](unsigned r, unsigned m) { return 1 + (r - 1) * meridians + m % meridians; };
  for (unsigned m = 0; m < meridians; ++m) {
    mesh.triangles.push_back({0, at(1, m + 1), at(1, m)});
    for (unsigned r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, m), at(r, m + 1), at(r + 1, m)});
      mesh.triangles.push_back({at(r, m + 1), at(r + 1, m + 1), at(r + 1, m)});
    }
    mesh.triangles.push_back({at(rings - 1, m), at(rings - 1, m + 1), static_cast<PointIndex>(mesh.points.size() - 1)});
  }
  return mesh;
}

/// Seen from -y, z upwards; x runs to the right. The film stands at y = `behind`.
inline FilmView film_behind(double behind, int columns, int rows, double pixel) {
  FilmView view;
  view.centre = {0, behind, 0};
  view.columns = columns;
  view.rows = rows;
  view.pixel = pixel;
  return view;
}

/// Shone through aslant, so that nothing lies along a ray.
inline FilmView aslant(FilmView view) {
  const double length = std::sqrt(0.31 * 0.31 + 1 + 0.17 * 0.17);
  view.towards_tube = {0.31 / length, -1 / length, 0.17 / length};
  return view;
}

inline FilmView with_focus(FilmView view, Point3 focus) {
  view.beam = FilmView::Beam::cone;
  view.focus = focus;
  return view;
}

inline Point3 minus(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// 2 sqrt(r^2 - d^2).
inline double chord_of_ball(const FilmRay& ray, Point3 centre, double radius) {
  const Point3 way = minus(ray.end, centre);
  const double along = dot(way, ray.direction), squared = radius * radius - (dot(way, way) - along * along);
  return squared > 0 ? 2 * std::sqrt(squared) : 0;
}

/// The part of the line within four half-spaces.
inline double chord_of_tetrahedron(const FilmRay& ray, const std::vector<Point3>& points, const Tetrahedron& corners) {
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (const auto& face : outward_face) {
    const Point3 a = points[corners[static_cast<std::size_t>(face[0])]],
                 b = points[corners[static_cast<std::size_t>(face[1])]],
                 c = points[corners[static_cast<std::size_t>(face[2])]];
    const Point3 u = minus(b, a), v = minus(c, a);
    const Point3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double speed = dot(normal, ray.direction), place = dot(normal, minus(ray.end, a));
    if (speed == 0 && place > 0) return 0;
    if (speed > 0) to = std::min(to, -place / speed);
    if (speed < 0) from = std::max(from, -place / speed);
  }
  return std::max(to - from, 0.0);
}

}  // namespace odontoscope::test
