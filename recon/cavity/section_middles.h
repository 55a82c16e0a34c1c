#pragma once
// Where is the middle of a canal, by its sections?

#include <vector>

#include "recon/cavity/centre_lines.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::cavity {

/// Of the section across a line at one of its points.
struct SectionMiddle {
  Point3 at;             // the section's centroid, or the line's point where the section is not compact
  bool compact = false;  // see limits::section_solidity
  double reach =
      0;  // from the middle to the section's far side: of an ellipse of its area that the widest ball touches
};

/// One for each of the points [first, last) of the line. A flat canal's widest ball fits in many places along its
/// section, so that the line wanders there; the centroid of an oval section does not. Where fins, other canals or a
/// bent section would draw the centroid away from the canal it is not taken. Precondition: the line lies in the void.
std::vector<SectionMiddle> section_middles(const SurfaceMesh& wall, const CentreLine& line, std::size_t first,
                                           std::size_t last);

}  // namespace odontoscope::cavity
