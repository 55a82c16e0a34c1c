#pragma once
// The shape of a canal as micro-CT studies tell it: sections near the apex, thirds, structure model index.

#include <array>
#include <optional>
#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/cavity/centre_lines.h"
#include "recon/core/progress.h"

namespace odontoscope {

/// Across a canal's line, so far from its apical end along it.
struct ApicalSection {
  double from_apex = 0;  // mm
  double width = 0;      // of the widest ball
  double area = 0;  // mm^2, of what is joined to the line's place in the plane across; shared where canals run together
};

/// A third of a canal's length: 0 coronal, 1 middle, 2 apical.
struct CanalThird {
  double volume = 0;  // mm^3: section areas over the line; shared where canals run together
  double area = 0;    // mm^2, of the wall that is nearest to it, without caps, and without the chamber's floor round an
                      // orifice (limits::floor_cosine)
};

struct CanalShape {
  std::vector<ApicalSection> apical;  // at 1, 2, 3 and 4 mm, as far as the canal is long: M. K. Wu et al., "Prevalence
                                      // and extent of long oval canals in the apical third", 2000
  std::array<CanalThird, 3> thirds;
  /// T. Hildebrand, P. Ruegsegger, "Quantification of bone microarchitecture with the structure model index", 1997: 6
  /// S' V / S^2, 0 for plates, 3 for rods, 4 for balls. S', the growth of the surface where it is moved outwards, is
  /// taken exactly: the sum over the wall's edges of length times outer angle (J. Steiner, 1840). Nothing without a
  /// wall.
  std::optional<double> structure_model_index;
};

/// One for each of the lines' canals. Precondition: the lines are those of the cavity.
std::vector<CanalShape> canal_shapes(const Cavity& cavity, const CentreLines& lines, const Progress& progress);

namespace cavity {

/// Of the section of the void across `along`, what lies round `at`: 0 if that is not in the void.
double section_area(const SurfaceMesh& wall, const Point3& at, const Direction& along);

/// The line's place so far along it, between two of its points.
Point3 place_along(const CentreLine& line, double along);
Direction direction_at(const CentreLine& line, double along);

}  // namespace cavity

}  // namespace odontoscope
