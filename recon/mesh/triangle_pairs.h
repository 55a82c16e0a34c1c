#pragma once
// Do two triangles of one complex meet where they should not? Exact. Needs CGAL's headers: for .cpp files of this room.

#include <array>

#include "recon/mesh/cgal_surface.h"

namespace odontoscope {

/// A triangle with its corners' numbers.
struct NumberedTriangle {
  std::array<PointIndex, 3> number;
  std::array<ExactKernel::Point_3, 3> corner;
};

/// True if the triangles meet anywhere but in corners and the edge that they share by number, or share all three.
/// Precondition: both have an area, and what has one number lies in one place.
bool meet_elsewhere(const NumberedTriangle& s, const NumberedTriangle& t);

}  // namespace odontoscope
