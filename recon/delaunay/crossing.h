#pragma once
// Do the solids of different components cross or touch? Exact triangle tests behind a box filter.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope::delaunay {

/// The boundary of a component, as triangles by place.
using Boundary = std::vector<std::array<Point3, 3>>;

/// Pairs (i < j) of boundaries that have a point in common, ascending. Tests only pairs whose bounding boxes meet.
std::vector<std::pair<std::size_t, std::size_t>> crossing_pairs(const std::vector<Boundary>& boundaries);

/// Has `one` a point in common with any of `boundaries`?
bool crosses_any(const std::vector<Boundary>& boundaries, const Boundary& one);

}  // namespace odontoscope::delaunay
