#pragma once
// From a crooked way through the medial graph to a smooth, centred line.

#include <vector>

#include "recon/cavity/centre_lines.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope::cavity {

enum class LineEnd {
  blind,       // go on straight towards the wall, see limits::tip_clearance
  both_blind,  // the first point likewise
  joined,      // it meets another line: stays where it is
  closed,      // the path's last point is its first: a loop
};

/// Points evenly apart, moved within their cross-sections to where clearance is largest, and smoothed in turn. The
/// first point stays where it is if only the end is blind. `end` of the result is set; its name and orifice are not.
/// Precondition: at least two places; the first in the void.
CentreLine centred(std::vector<Point3> path, const WallTree& tree, LineEnd end);

}  // namespace odontoscope::cavity
