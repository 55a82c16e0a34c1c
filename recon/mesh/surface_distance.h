#pragma once
// How far two surfaces are apart, measured by samples.

#include <cstddef>
#include <optional>
#include <vector>

#include "recon/core/progress.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

struct DistanceOptions {
  /// Sample points on each surface, spread evenly over its area.
  std::size_t samples = 200'000;
};

/// From points of one surface to the nearest point of the other, mm.
struct OneWayDistance {
  double largest = 0;  // over all samples and all vertices of the one: at most the true one
  double mean = 0;     // over the samples, and so over the area
};

struct SurfaceDistance {
  OneWayDistance a_to_b, b_to_a;  // from `a` to `b`, from `b` to `a`
  double largest() const { return a_to_b.largest > b_to_a.largest ? a_to_b.largest : b_to_a.largest; }
  /// The larger of the two means: the safe one to quote.
  double mean() const { return a_to_b.mean > b_to_a.mean ? a_to_b.mean : b_to_a.mean; }
};

/// Samples are placed at equal steps of accumulated area, triangle after triangle, and within a triangle by a
/// low-discrepancy sequence: the same points each time. Nothing for a mesh without a triangle that has area (then there
/// is no distance). Runs in the caller's TBB arena; the result does not depend on the number of threads. Stage:
/// "measure distance".
std::optional<SurfaceDistance> surface_distance(const SurfaceMesh& a, const SurfaceMesh& b,
                                                const DistanceOptions& options = {}, const Progress& progress = {});

/// From given points to the nearest point of a surface; the mean is over the points. Nothing if there is no point, or
/// no triangle that has area. Runs and tells as above.
std::optional<OneWayDistance> distance_to_surface(const std::vector<Point3>& points, const SurfaceMesh& surface,
                                                  const Progress& progress = {});

}  // namespace odontoscope
