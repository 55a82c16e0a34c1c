#include "recon/output/simplify_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "recon/core/error.h"
#include "recon/mesh/simplify_surface.h"

namespace odontoscope {
namespace {

double diagonal_of(const SurfaceMesh& surface) {
  Point3 low = surface.points.front(), high = low;
  for (const Point3& p : surface.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

StructureSimplification replaced_by(SimplifiedSurface& simple, Solid& solid) {
  if (!simple.report.closed_oriented_manifold()) {
    throw InternalError(fmt::format("simplifying {} broke its surface", solid.structure));
  }
  for (Shell& shell : simple.report.shells) shell.structure = solid.structure;
  StructureSimplification told{.structure = solid.structure,
                               .triangles_before = solid.surface.triangles.size(),
                               .triangles = simple.surface.triangles.size(),
                               .distance = simple.distance,
                               .self_intersections = simple.self_intersections,
                               .kept_vertices = simple.kept_vertices,
                               .diagonal = diagonal_of(solid.surface)};
  solid.surface = std::move(simple.surface);
  solid.report = std::move(simple.report);
  return told;
}

}  // namespace

ModelSimplification simplify_surfaces(Reconstruction& reconstruction, std::size_t triangles, const Progress& progress) {
  std::size_t before = 0;
  std::vector<const SurfaceMesh*> surfaces;
  for (const Solid& solid : reconstruction.solids) {
    before += solid.surface.triangles.size();
    surfaces.push_back(&solid.surface);
  }
  if (triangles >= before) return {};
  const auto start = std::chrono::steady_clock::now();
  SimplifiedSurfaces simple = simplify(surfaces, {.triangles = triangles, .distance = {}}, progress);
  ModelSimplification done;
  for (std::size_t n = 0; n < simple.surfaces.size(); ++n)
    done.structures.push_back(replaced_by(simple.surfaces[n], reconstruction.solids[n]));
  done.aim = SimplificationAim{triangles, simple.triangles, simple.obstacles, simple.restarts};
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  reconstruction.seconds.push_back({"simplify", taken.count()});
  return done;
}

}  // namespace odontoscope
