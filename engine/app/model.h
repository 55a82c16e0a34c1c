#pragma once
// What `reconstruct` made, on its way to files and words.

#include <cstddef>
#include <vector>

#include "engine/app/console.h"
#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/output/report_json.h"

namespace odontoscope::app {

struct Model {
  Reconstruction reconstruction;
  /// One for each solid whose surface in `reconstruction` is a simplified one; the tetrahedra stay as they were.
  std::vector<StructureSimplification> simplifications;
};

/// Replaces the surfaces by ones with at most `triangles` in all, shared out in proportion to what each has now. Each
/// keeps its topology, and therefore may keep more. InternalError if a result is no closed oriented manifold.
void simplify_model(Model& model, std::size_t triangles, const Progress& progress);

/// Shells, genus, volume, triangles, tetrahedra, seconds, and what is certified, in plain words.
void tell_model(const Model& model, double seconds, Console& console);
/// The same of a DB model, and what is wrong with it.
void tell_model(const DbReconstruction& model, double seconds, Console& console);

}  // namespace odontoscope::app
