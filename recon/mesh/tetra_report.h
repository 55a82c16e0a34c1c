#pragma once
// The judge of tetrahedral meshes: are all elements positive, and how well shaped are they?

#include <cstddef>

#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

struct TetraReport {
  std::size_t tetrahedra = 0;
  std::size_t non_positive = 0;        // flat or inverted, by exact predicate
  double volume = 0;                   // signed sum, mm^3
  Distribution smallest_dihedral_deg;  // of the six angles of each tetrahedron; 70.53 if regular
  Distribution largest_dihedral_deg;
  Distribution radius_ratio;       // three times the inscribed ball's radius over that of the circumscribed one; 1 if
                                   // regular, 0 if flat
  Distribution radius_edge_ratio;  // circumradius over shortest edge; 0.612 if regular
};

/// Precondition: indices in range. Elements are judged one by one; whether they fit together is not looked at. Runs in
/// the caller's TBB arena; the result does not depend on the number of threads.
TetraReport inspect(const TetraMesh& mesh);

}  // namespace odontoscope
