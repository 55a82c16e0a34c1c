#pragma once
// Do structures share walls or overlap, so that a partition is what they want?

#include "recon/input/contour_stack.h"

namespace odontoscope {

/// True if in some slice a point of one structure's contours lies within another structure, or on one of its points. Of
/// each contour some points are asked, evenly spread. Structures that keep apart in all slices, hollow ones about
/// others too, do not meet.
bool structures_meet(const ContourStack& stack);

}  // namespace odontoscope
