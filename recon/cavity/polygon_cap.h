#pragma once
// A simple polygon as triangles.

#include <optional>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::cavity {

/// Triangles between the polygon's corners (counter-clockwise), themselves counter-clockwise; nothing if its sides
/// cross or touch.
std::optional<std::vector<Triangle>> triangulated(const std::vector<Point2>& polygon);

}  // namespace odontoscope::cavity
