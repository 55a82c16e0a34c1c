#pragma once
// The canal experiment as a plot.

#include <string>

#include "recon/compare/canal.h"

namespace odontoscope {

/// SVG: over the grid's size the share of slices in which the canal is open, filled dots where it is open all the way;
/// DT as a line.
std::string canal_plot(const CanalExperiment& experiment);

}  // namespace odontoscope
