#pragma once
// Straight pieces made planar: cut where they cross or touch, so that they meet in their ends only. Inner part of
// contour_overlay.h.

#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope::partition {

/// From point a to point b. Beyond it the structures whose bits are set in `toggles` begin or end.
struct ContourPiece {
  std::uint32_t a = 0, b = 0;
  std::uint64_t toggles = 0;
};

/// Points keep their numbers, new ones follow. Crossings are computed exactly and rounded, to the end of a piece if
/// that is limits::snap_ulps or less away; since rounding bends pieces, that is repeated until, by exact predicates,
/// nothing crosses or touches any more. Pieces that coincide become one, in which what both toggle cancels out. Returns
/// how many crossings were made points. Throws InternalError if it does not settle.
std::size_t make_planar(std::vector<Point2>& points, std::vector<ContourPiece>& pieces);

}  // namespace odontoscope::partition
