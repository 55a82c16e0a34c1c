#pragma once
// What the writers of surfaces need of a model, whichever engine made it: borrowed, not copied.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"

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
  WrittenModel(const Reconstruction& made) : certified(made.certified), slices_checked(made.slices_checked) {
    for (const Solid& solid : made.solids) solids.push_back({solid.structure, solid.surface, solid.report});
  }
  WrittenModel(const DbReconstruction& made) : certified(made.certified) {
    for (const DbSurface& one : made.surfaces) solids.push_back({one.structure, one.surface, one.report});
  }
};

}  // namespace odontoscope
