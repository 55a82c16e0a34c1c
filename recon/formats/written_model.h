#pragma once
// What the writers of surfaces need of a model, whichever engine made it: borrowed, not copied.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct WrittenSurface {
  const std::string& structure;
  const SurfaceMesh& surface;
  const SurfaceReport& report;  // of `surface`
};

/// Lives no longer than the model that it was made of.
struct WrittenModel {
  std::vector<WrittenSurface> solids;
  bool certified = false;          // by the engine; a writer still looks at the reports
  std::size_t slices_checked = 0;  // whose section was proven; 0 for DB, which proves none

  WrittenModel() = default;
  /// Of solids whose sections were proven (Reconstruction), or of surfaces alone (DbReconstruction).
  template <class Made>
  requires requires(const Made& made) { made.certified; }
  WrittenModel(const Made& made) : certified(made.certified) {
    const auto take = [this](const auto& parts) {
      for (const auto& one : parts) solids.push_back({one.structure, one.surface, one.report});
    };
    if constexpr (requires { made.slices_checked; }) {
      slices_checked = made.slices_checked;
      take(made.solids);
    } else {
      take(made.surfaces);
    }
  }
};

}  // namespace odontoscope
