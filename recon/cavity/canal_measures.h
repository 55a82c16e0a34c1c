#pragma once
// The numbers of one canal that its line alone tells.

#include <cstddef>
#include <utility>
#include <vector>

#include "recon/cavity/anatomy.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope::cavity {

/// Name, places, length, Schneider's angle, bend and widths of the canal, see MeasuredCanal. `tree`: of the wall.
/// `spacing`: of the slices.
MeasuredCanal measured_canal(const CentreLine& line, const SurfaceMesh& wall, const WallTree& tree, double spacing);

/// Twice the widest balls at each of the line's points, where no narrow place is shorter than `spacing`: between two
/// slices a canal may be pinched that is not so in any slice, so that a narrow place as short as that is not known.
/// (Closing, of mathematical morphology: J. Serra, 1982.) What narrows on one side only stays as it is.
std::vector<double> known_widths(const CentreLine& line, double spacing);

/// MeasuredCanal::schneider_deg of the line from one of its points on; the line leaves its axis where it is farther
/// from it than half its local radius and `slack`, mm.
double schneider_of(const CentreLine& line, std::size_t orifice_point, double slack);

/// From the orifice on, the points [first, second) that are no nearer to a blind end than the canal is wide: what is
/// nearer tells of the end. May be empty.
std::pair<std::size_t, std::size_t> between_ends(const CentreLine& line);

}  // namespace odontoscope::cavity
