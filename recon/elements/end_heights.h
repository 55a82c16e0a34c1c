#pragma once
// Where materials begin and end along z: flat ends there stay flat.

#include <vector>

#include "recon/mesh/interface_web.h"

namespace odontoscope::elements {

/// The lowest and the highest coordinate of each material, in no order.
std::vector<double> end_heights(const InterfaceWeb& web);

/// Do all three corners lie at one of these heights?
bool is_level(const InterfaceWeb& web, std::uint32_t face, const std::vector<double>& heights);

}  // namespace odontoscope::elements
