#pragma once
// Regions with holes as one closed line each, as DICOM wants them (PS3.3, C.8.8.6.3): along a bridge from the outline
// to the hole, around it, and back along the very same bridge.
//
// A bridge runs from the hole's point of least x (and y) to the nearest point of the line so far that is in plain view;
// holes are joined by ascending x. That there is one: D. Eberly, "Triangulation by ear clipping" (2002), section 5.
// Exact predicates.

#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

using Ring = std::vector<Point2>;

/// Lines for the contours of one structure in one slice, outer ones counter-clockwise and holes clockwise as `ordered`
/// (validate.h) has them: one line for each outer contour, in their order. The region within an odd number of lines is
/// that of the contours, and no point is moved. Preconditions: as after `validate` and `ordered`.
std::vector<Ring> with_keyholes(const std::vector<Ring>& contours);

}  // namespace odontoscope
