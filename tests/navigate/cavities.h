#pragma once
// The cavities that people fly through: the CT molar's pulp and the sample molar's.

#include <optional>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::test {

/// Of the solid's cavities the one that holds most; wound towards the void.
SurfaceMesh largest_cavity(const SurfaceMesh& surface, const SurfaceReport& report);

/// Made once, then remembered. The CT molar's (lengths in voxels): none where that data set is not there.
const SurfaceMesh* ct_molar_pulp();
const SurfaceMesh& sample_molar_pulp();

/// All external shells of both.
const SurfaceMesh* ct_molar_outside();
const SurfaceMesh& sample_molar_outside();

}  // namespace odontoscope::test
