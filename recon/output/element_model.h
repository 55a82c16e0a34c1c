#pragma once
// A finished reconstruction meshed anew in elements for simulation (recon/elements): tetrahedra and surfaces are
// replaced.

#include <optional>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/elements/elements.h"

namespace odontoscope {

struct ModelElements {
  double size = 0;                                    // of edges, mm: the smallest that was meshed with
  double asked = 0;                                   // the smallest that was asked for or suggested
  std::vector<elements::MaterialElements> materials;  // in the order of the solids
};

/// `size` of edges, mm; nothing: as suggested_size says. A partition stays one complex; structures by themselves are
/// meshed one by one. Adds a stage "elements" to the times. Throws as make_elements does; nothing is changed then.
ModelElements mesh_elements(Reconstruction& reconstruction, std::optional<double> size, const Progress& progress = {});

}  // namespace odontoscope
