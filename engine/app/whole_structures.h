#pragma once
// Structures as solids: outer surfaces and cavities put together again, and which of them voids can be looked for in.

#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/model.h"
#include "recon/cavity/cavity.h"
#include "recon/formats/shell_groups.h"
#include "recon/mesh/append.h"
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
    append(part.surface, solid->surface);
  }
  return whole;
}

/// Views of them, for what is computed from a whole model.
inline std::vector<StructureSurface> looked_at(const std::vector<NamedMesh>& whole) {
  std::vector<StructureSurface> views;
  for (const NamedMesh& solid : whole) views.push_back({solid.name, &solid.surface});
  return views;
}

/// Those that are closed oriented manifolds: only they have an inside.
inline std::vector<StructureSurface> sound_structures(const WrittenModel& model) {
  std::vector<StructureSurface> views;
  for (const WrittenSurface& solid : model.solids)
    if (solid.report.closed_oriented_manifold()) views.push_back({solid.structure, &solid.surface});
  return views;
}

/// What to tell whose model has no void (see cavities_in).
inline constexpr const char* what_a_void_takes =
    "A pulp must be closed off from the outside, open along z and deep for its mouth, or be a body with \"pulp\" in "
    "its name.";

}  // namespace odontoscope::app
