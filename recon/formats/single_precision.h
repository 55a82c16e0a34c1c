#pragma once
// Coordinates as floats in which distinct points stay distinct.
//
// Formats without vertex numbers (STL), or with doubled vertices (glTF), are put together again by equal coordinates;
// were two points rounded to one, a manifold would come out broken.

#include <array>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/formats/written_model.h"

namespace odontoscope {

using FloatPoint = std::array<float, 3>;

/// `scale` times each point, rounded; a point whose place is taken gets the nearest free one, first come first served:
/// neighbours in the lattice of floats, so off by some units in the last place. Bit-equal points stay equal.
/// Deterministic.
std::vector<FloatPoint> distinct_floats(const std::vector<Point3>& points, double scale);

/// Of all solids of a model together, so that points that two of them share stay equal to the bit.
std::vector<std::vector<FloatPoint>> distinct_floats(const WrittenModel& model, double scale);

}  // namespace odontoscope
