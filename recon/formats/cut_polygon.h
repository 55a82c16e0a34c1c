#pragma once
// One polygon in space, planar or not, cut into triangles. For the .cpp files of this room only.
//
// The polygon is looked at along the axis nearest to its normal (M. Newell's, the sum over its edges), by dropping that
// coordinate, so that no number is rounded. There it is cut with exact predicates: four corners along the shorter
// diagonal that lies inside, more by a constrained Delaunay triangulation. Holes that are drawn in one line with the
// outside (a bridge there and back) are left open. Should it cross itself there, the other two axes are tried, and at
// last it is cut as a fan from its first corner.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

struct CutPolygon {
  /// Corners by number, oriented like the polygon; n - 2 of them for n corners.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool fan = false;      // it crosses itself whichever way it is looked at
  double off_plane = 0;  // the farthest that a corner lies off the plane through their middle, across the normal
  double size = 0;       // the longest side of the box around it
};

/// Precondition: three corners or more. Neighbours differ by number, places may be equal.
CutPolygon cut_polygon(const std::vector<Point3>& corners);

/// Of four corners, along the diagonal that begins at corner 0 or 1; nothing if that does not lie inside.
std::optional<std::vector<std::array<std::uint32_t, 3>>> cut_along_diagonal(const std::vector<Point3>& corners,
                                                                            std::uint32_t from);

}  // namespace odontoscope
