#pragma once
// Where does a canal leave the chamber?

#include <cstddef>

#include "recon/cavity/centre_lines.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope::cavity {

/// See CentreLine::orifice.
std::size_t orifice_of(const CentreLine& line, double chamber_radius, const WallTree& tree);

}  // namespace odontoscope::cavity
