#pragma once
// From borders back to contours: of one material, or of several taken as one.

#include <functional>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/partition/contour_overlay.h"

namespace odontoscope::partition {

/// Contours round all faces whose label is chosen, with these on their left: outer ones counter-clockwise, holes
/// clockwise, simple and disjoint. Without points where nothing but labels within the set meet.
std::vector<Contour> face_contours(const Borders& borders, const std::string& name,
                                   const std::function<bool(Label)>& chosen);

}  // namespace odontoscope::partition
