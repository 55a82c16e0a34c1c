#include "recon/output/simplify_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "recon/core/error.h"
#include "recon/mesh/complex_parts.h"
#include "recon/mesh/extent.h"
#include "recon/mesh/simplify_interfaces.h"

namespace odontoscope {
namespace {

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
                               .diagonal = diagonal_of(solid.surface.points)};
  solid.surface = std::move(simple.surface);
  solid.report = std::move(simple.report);
  return told;
}

/// Interfaces once for both their materials.
SimplifiedSurfaces simplified(const Reconstruction& reconstruction, const LabelledComplex& complex,
                              std::size_t triangles, const Progress& progress) {
  const SimplifiedInterfaces simple = simplify_interfaces(complex, triangles, progress);
  SimplifiedSurfaces all{{}, simple.triangles, simple.reached, simple.obstacles, simple.restarts};
  for (const Solid& solid : reconstruction.solids) {
    SimplifiedSurface one;
    one.surface = surface_of(simple.complex, label_of(complex, solid.structure));
    one.report = inspect(one.surface);
    if (const auto distance = surface_distance(one.surface, solid.surface, {}, progress)) one.distance = *distance;
    all.surfaces.push_back(std::move(one));
  }
  return all;
}

SimplifiedSurfaces simplified(const Reconstruction& reconstruction, std::size_t triangles, const Progress& progress) {
  if (reconstruction.complex) return simplified(reconstruction, *reconstruction.complex, triangles, progress);
  std::vector<const SurfaceMesh*> surfaces;
  for (const Solid& solid : reconstruction.solids) surfaces.push_back(&solid.surface);
  return simplify(surfaces, {.triangles = triangles, .distance = {}}, progress);
}

}  // namespace

ModelSimplification simplify_surfaces(Reconstruction& reconstruction, std::size_t triangles, const Progress& progress) {
  std::size_t before = 0;
  for (const Solid& solid : reconstruction.solids) before += solid.surface.triangles.size();
  if (triangles >= before) return {};
  const auto start = std::chrono::steady_clock::now();
  SimplifiedSurfaces simple = simplified(reconstruction, triangles, progress);
  ModelSimplification done;
  for (std::size_t n = 0; n < simple.surfaces.size(); ++n)
    done.structures.push_back(replaced_by(simple.surfaces[n], reconstruction.solids[n]));
  done.aim = SimplificationAim{triangles, simple.triangles, simple.obstacles, simple.restarts};
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  reconstruction.seconds.push_back({"simplify", taken.count()});
  return done;
}

}  // namespace odontoscope
