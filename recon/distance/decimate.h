#pragma once
// Fewer triangles for a DB surface, cracked or not.
//
// Edges are collapsed onto one of their ends in order of quadric error, by the meshoptimizer library
// (meshopt_simplify), which bears meshes that are no manifolds: open borders collapse along themselves, vertices where
// more meets stay. It works in single precision on coordinates taken relative to the surface, but the points of the
// result are points of the surface, bit for bit. It does not promise to keep topology, nor to keep the surface from
// cutting through itself: the report tells what came out. One thread; the same input gives the same result.

#include <cstddef>
#include <optional>
#include <string>

#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct DecimateOptions {
  /// The aim; the result may keep more where no collapse is left. Nothing: to the most possible within `largest_error`.
  std::optional<std::size_t> triangles;
  /// mm, in the library's measure (distance to the planes of the triangles that went in). Only without `triangles`.
  double largest_error = 0;
};

struct DecimatedSurface {
  SurfaceMesh surface;
  SurfaceReport report;
  double error = 0;  // mm, as the library measures it
};

/// Precondition: indices in range. An empty surface stays empty.
DecimatedSurface decimate(const SurfaceMesh& surface, const DecimateOptions& options);

/// "meshoptimizer 0.18": for reports.
std::string decimation_library();

}  // namespace odontoscope
