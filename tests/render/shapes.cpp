#include "tests/render/shapes.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::testing_support {
namespace {

constexpr double pi = std::numbers::pi;

/// Points of a grid that closes around in one or both directions become triangles.
void add_quad(SurfaceMesh& mesh, PointIndex a, PointIndex b, PointIndex c, PointIndex d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

PointIndex middle(SurfaceMesh& mesh, std::map<std::pair<PointIndex, PointIndex>, PointIndex>& middles, PointIndex a,
                  PointIndex b, double radius) {
  const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<PointIndex>(mesh.points.size()));
  if (!fresh) return found->second;
  const Point3 p = mesh.points[a], q = mesh.points[b];
  const Point3 sum{p.x + q.x, p.y + q.y, p.z + q.z};
  const double scale = radius / std::hypot(sum.x, sum.y, sum.z);
  mesh.points.push_back({scale * sum.x, scale * sum.y, scale * sum.z});
  return found->second;
}

}  // namespace

SurfaceMesh ball(const Ball& ball) {
  SurfaceMesh mesh;
  const int around = 2 * ball.rings;
  const auto at = [&](double polar, double azimuth) {
    return Point3{ball.centre.x + ball.radius * std::sin(polar) * std::cos(azimuth),
                  ball.centre.y + ball.radius * std::sin(polar) * std::sin(azimuth),
                  ball.centre.z + ball.radius * std::cos(polar)};
  };
  const auto index = [&](int ring, int step) {
    return static_cast<PointIndex>(1 + (ring - 1) * around + step % around);
  };
  mesh.points.push_back(at(0, 0));
  for (int ring = 1; ring < ball.rings; ++ring)
    for (int step = 0; step < around; ++step) mesh.points.push_back(at(pi * ring / ball.rings, 2 * pi * step / around));
  mesh.points.push_back(at(pi, 0));
  const auto south = static_cast<PointIndex>(mesh.points.size() - 1);
  for (int step = 0; step < around; ++step) {
    mesh.triangles.push_back({0, index(1, step), index(1, step + 1)});
    for (int ring = 1; ring + 1 < ball.rings; ++ring)
      add_quad(mesh, index(ring, step), index(ring + 1, step), index(ring + 1, step + 1), index(ring, step + 1));
    mesh.triangles.push_back({south, index(ball.rings - 1, step + 1), index(ball.rings - 1, step)});
  }
  return mesh;
}

SurfaceMesh ring(const Ring& ring) {
  SurfaceMesh mesh;
  for (int i = 0; i < ring.around; ++i)
    for (int j = 0; j < ring.across; ++j) {
      const double u = 2 * pi * i / ring.around, v = 2 * pi * j / ring.across;
      const double distance = ring.radius + ring.tube * std::cos(v);
      mesh.points.push_back({distance * std::cos(u), distance * std::sin(u), ring.tube * std::sin(v)});
    }
  const auto index = [&](int i, int j) {
    return static_cast<PointIndex>(i % ring.around * ring.across + j % ring.across);
  };
  for (int i = 0; i < ring.around; ++i)
    for (int j = 0; j < ring.across; ++j)
      add_quad(mesh, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
  return mesh;
}

SurfaceMesh box(const Point3& low, const Point3& high) {
  SurfaceMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1u ? high.x : low.x, i & 2u ? high.y : low.y, i & 4u ? high.z : low.z});
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

SurfaceMesh coarse_ball(double radius) {
  const double golden = (1 + std::sqrt(5.0)) / 2, scale = radius / std::hypot(1.0, golden);
  SurfaceMesh icosahedron;
  for (const auto& [a, b] : {std::pair{1, 1}, std::pair{-1, 1}, std::pair{1, -1}, std::pair{-1, -1}}) {
    icosahedron.points.push_back({0, a * scale, b * scale * golden});
    icosahedron.points.push_back({a * scale, b * scale * golden, 0});
    icosahedron.points.push_back({b * scale * golden, 0, a * scale});
  }
  // Every three points at the edge's length from each other, turned outwards.
  const double edge = 2 * scale;
  const auto apart = [&](PointIndex i, PointIndex j) {
    const Point3 &p = icosahedron.points[i], &q = icosahedron.points[j];
    return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
  };
  const auto near_edge = [&](PointIndex i, PointIndex j) { return std::abs(apart(i, j) - edge) < 1e-6 * radius; };
  for (PointIndex i = 0; i < 12; ++i)
    for (PointIndex j = i + 1; j < 12; ++j)
      for (PointIndex k = j + 1; k < 12; ++k) {
        if (!near_edge(i, j) || !near_edge(j, k) || !near_edge(i, k)) continue;
        const Point3 &p = icosahedron.points[i], &q = icosahedron.points[j], &r = icosahedron.points[k];
        const double turn =
            p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
        icosahedron.triangles.push_back(turn > 0 ? Triangle{i, j, k} : Triangle{i, k, j});
      }
  SurfaceMesh mesh{icosahedron.points, {}};
  std::map<std::pair<PointIndex, PointIndex>, PointIndex> middles;
  for (const auto& [a, b, c] : icosahedron.triangles) {
    const PointIndex ab = middle(mesh, middles, a, b, radius), bc = middle(mesh, middles, b, c, radius),
                     ca = middle(mesh, middles, c, a, radius);
    for (const Triangle& part : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      mesh.triangles.push_back(part);
  }
  return mesh;
}

SurfaceMesh reversed(SurfaceMesh mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

Model hollow_ball_model() {
  return make_model(
      {{"shell", ball({{0, 0, 0}, 5}), "shell"}, {"shell cavity", reversed(ball({{0, 0, 0}, 2})), "shell", true}});
}

namespace {

struct SmallMolar {
  std::vector<NamedSurface> surfaces;
  OverlaySource overlays;
};

const SmallMolar& the_small_molar() {
  static const SmallMolar molar = [] {
    SampleOptions coarse;
    coarse.slice_spacing = 0.35;
    coarse.point_spacing = 0.5;
    SmallMolar made;
    made.overlays.contours = sample_tooth(ToothKind::molar, coarse);
    for (Solid& solid : reconstruct(made.overlays.contours).solids) {
      made.surfaces.push_back({solid.structure, std::move(solid.surface)});
      made.overlays.solids.push_back({solid.structure, std::move(solid.tetrahedra)});
    }
    return made;
  }();
  return molar;
}

}  // namespace

const std::vector<NamedSurface>& small_molar_surfaces() { return the_small_molar().surfaces; }
const OverlaySource& small_molar_overlays() { return the_small_molar().overlays; }

SurfaceMesh faulty_ring() {
  SurfaceMesh mesh = ring({.radius = 4, .tube = 1.5, .around = 16, .across = 8});
  // Where buccal is: a quarter of the way round, on the outside of the tube and just above.
  const std::size_t there = 2 * 4 * 8;
  std::swap(mesh.triangles[there - 16][1], mesh.triangles[there - 16][2]);
  const Triangle edge_of = mesh.triangles[there + 16];
  mesh.triangles.push_back({edge_of[1], edge_of[0], static_cast<PointIndex>(mesh.points.size())});
  mesh.points.push_back({-1.2, 7.2, 1.4});
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(there));
  return mesh;
}

const Model& small_molar() {
  static const Model model = make_model(small_molar_surfaces());
  return model;
}

}  // namespace odontoscope::testing_support
