#pragma once
// Surfaces put together as one.

#include "recon/mesh/meshes.h"

namespace odontoscope {

/// Points and triangles follow those that are there; nothing is welded.
inline void append(const SurfaceMesh& more, SurfaceMesh& to) {
  const auto first = static_cast<PointIndex>(to.points.size());
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (const auto& [a, b, c] : more.triangles) to.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace odontoscope
