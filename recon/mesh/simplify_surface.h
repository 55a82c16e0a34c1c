#pragma once
// Fewer triangles for finished surfaces, with their topology untouched.
//
// Edges are collapsed in order of a quadratic volume error without memory of the original: P. Lindstrom, G. Turk, "Fast
// and memory efficient polygonal simplification", IEEE Visualization 1998, as implemented by CGAL's
// Surface_mesh_simplification. Of CGAL's error measures it lies closest to the surfaces of stacked contours: mean
// distance, in voxels, of a CT molar of 97,588 triangles brought down to 8,000 and 5,000: 0.040 and 0.053;
// Garland-Heckbert with triangle quadrics 0.052 and 0.072, with plane quadrics 0.055 and 0.075, with probabilistic ones
// 0.072 and more.
//
// A collapse is refused that would change the topology (link condition), turn a triangle over, go astray, or make a
// triangle that cuts or touches another (collapse_guard.h). Several surfaces are simplified in one queue: the cheapest
// collapse of all comes next, so each keeps what its shape needs. If that stops above the aim, refused edges are tried
// again, into their middle and ends too; then triangles may turn over where nothing is cut. What is left then cannot
// be reached by collapsing edges, and `obstacles` says why.

#include <cstddef>
#include <vector>

#include "recon/core/progress.h"
#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_distance.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct SimplifyOptions {
  /// The aim, all surfaces together. The result has at most so many, or as few as the refusals above allow.
  std::size_t triangles = 8'000;
  DistanceOptions distance;
};

struct SimplifiedSurface {
  SurfaceMesh surface;
  SurfaceReport report;      // of `surface`; structure names are empty
  SurfaceDistance distance;  // `a_to_b`: from the simplified surface to the full one; zero if nothing was to be done
  /// Pairs of triangles that cut through each other, in the full surface and in the simplified one. The latter is zero
  /// unless the former is not.
  std::size_t full_self_intersections = 0, self_intersections = 0;
  /// Vertices of the full surface that were kept in place, since rounding turned a speck inside out.
  std::size_t kept_vertices = 0;
};

struct SimplifiedSurfaces {
  /// In the order given.
  std::vector<SimplifiedSurface> surfaces;
  std::size_t triangles = 0;
  bool reached = true;
  /// If not reached: edges that could not be collapsed, by what stood against it when they were tried last.
  struct Obstacles {
    std::size_t topology = 0;  // pieces, handles or tunnels would change
    std::size_t cuts = 0;      // the surface would cut through itself
    std::size_t shape = 0;     // a triangle would turn over, lose its area, or lie far off
  };
  Obstacles obstacles;
  /// Times that the work began anew.
  std::size_t restarts = 0;
};

/// Precondition: each is a closed oriented manifold (UsageError if not). Each result is one, too, with the same
/// shells, each of the same kind and genus. A surface that no collapse touched is returned as it was. Runs on one
/// thread, the distance in the caller's TBB arena; deterministic. Stages: "simplify", "measure distance".
SimplifiedSurfaces simplify(const std::vector<const SurfaceMesh*>& surfaces, const SimplifyOptions& options = {},
                            const Progress& progress = {});

/// The same of one.
SimplifiedSurface simplify(const SurfaceMesh& surface, const SimplifyOptions& options = {},
                           const Progress& progress = {});

}  // namespace odontoscope
