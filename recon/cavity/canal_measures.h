#pragma once
// The numbers of one canal that its line alone tells.

#include <cstddef>
#include <utility>

#include "recon/cavity/anatomy.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope::cavity {

/// Name, places, length, Schneider's angle, bend and widths of the canal, see MeasuredCanal.
MeasuredCanal measured_canal(const CentreLine& line, const WallTree& wall);

/// MeasuredCanal::schneider_deg of the line from one of its points on; the line leaves its axis where it is farther from it than half its local radius and `slack`, mm.
double schneider_of(const CentreLine& line, std::size_t orifice_point, double slack);

/// From the orifice on, the points [first, second) that are no nearer to a blind end than the canal is wide: what is nearer tells of the end. May be empty.
std::pair<std::size_t, std::size_t> between_ends(const CentreLine& line);

}  // namespace odontoscope::cavity
