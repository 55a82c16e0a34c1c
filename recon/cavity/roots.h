#pragma once
// Which canals share a root, and of which type is it?

#include <optional>
#include <vector>

#include "recon/cavity/anatomy.h"
#include "recon/core/polygon.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope::cavity {

/// Where a canal's line passes this height last, on its way to the apex; nothing if it does not, below the orifice.
std::optional<Point2> passes(const CentreLine& line, double z);
/// The number of the smallest loop round the place; as many as there are loops if none is.
std::size_t loop_round(const std::vector<Polygon>& loops, const std::optional<Point2>& place);

/// See MeasuredRoot. `outside`: of the solid that the canals run in. z runs along the tooth.
std::vector<MeasuredRoot> roots_of(const Cavity& cavity, const CentreLines& lines, const SurfaceMesh& outside,
                                   const std::vector<MeasuredCanal>& canals);

}  // namespace odontoscope::cavity
