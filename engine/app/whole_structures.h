#pragma once
// Outer surfaces and cavities of what is shown, put together again.

#include <string>
#include <vector>

#include "engine/scene/model.h"
#include "recon/cavity/cavity.h"
#include "recon/mesh/named_mesh.h"

namespace odontoscope::app {

/// One for each solid, in order of first appearance.
inline std::vector<NamedMesh> whole_structures(const std::vector<NamedSurface>& surfaces) {
  std::vector<NamedMesh> whole;
  for (const NamedSurface& part : surfaces) {
    const std::string& name = part.solid.empty() ? part.structure : part.solid;
    NamedMesh* solid = nullptr;
    for (NamedMesh& known : whole)
      if (known.name == name) solid = &known;
    if (solid == nullptr) solid = &whole.emplace_back(NamedMesh{name, {}});
    SurfaceMesh& mesh = solid->surface;
    const auto base = static_cast<PointIndex>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), part.surface.points.begin(), part.surface.points.end());
    for (const auto& [a, b, c] : part.surface.triangles) mesh.triangles.push_back({base + a, base + b, base + c});
  }
  return whole;
}

/// Views of them, for what is computed from a whole model.
inline std::vector<StructureSurface> looked_at(const std::vector<NamedMesh>& whole) {
  std::vector<StructureSurface> views;
  for (const NamedMesh& solid : whole) views.push_back({solid.name, &solid.surface});
  return views;
}

}  // namespace odontoscope::app
