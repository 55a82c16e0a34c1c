#pragma once
// How far is it from a canal to the outside of the tooth?

#include <vector>

#include "recon/cavity/anatomy.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::cavity {

/// The outer shells of the solid that the void lies in, without the lining of what opens to the outside.
struct Outside {
  SurfaceMesh surface;                // empty: the solid is not there
  std::vector<Cavity::Mouth> mouths;  // where the lining ends
};

/// What is called dentine or tooth is the solid of a void that a body of pulp fills, and it may open to the outside
/// there. `reports`: of the model's parts.
Outside outside_of(const std::vector<StructureSurface>& model, const std::vector<SurfaceReport>& reports,
                   const Cavity& cavity);

/// Fills in the canals' thinnest walls, and tells where there is none: from each point of the void's wall that is
/// nearest to a canal's line, below its orifice, to the outside.
std::vector<Opening> measure_walls(const Cavity& cavity, const CentreLines& lines, const Outside& outer,
                                   std::vector<MeasuredCanal>& canals, const Progress& progress);

}  // namespace odontoscope::cavity
