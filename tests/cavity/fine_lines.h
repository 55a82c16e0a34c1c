#pragma once
// What a sample tooth's canals are, by another way than the engine's: contours cut finely, and a field of distances
// with marching cubes over them.

#include <vector>

#include "recon/cavity/centre_lines.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::test {

/// Centre lines of the dentine's void. Slices and grid lie 0.1 mm apart.
const CentreLines& fine_lines(ToothKind kind);

/// Of its canals the one that ends nearest to a place.
const CentreLine& ending_at(const std::vector<CentreLine>& canals, const Point3& end);

/// From a canal's orifice down to a height, along its points.
double length_down_to(const CentreLine& line, double z);

}  // namespace odontoscope::test
