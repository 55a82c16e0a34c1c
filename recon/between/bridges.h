#pragma once
// Shapes that are linked but do not overlap, where the larger one has other links too: the bead of a slanted canal
// beside the chamber. Inner part of blend.h.
//
// Such contours are blended as a union, in which the bead shrinks where it stands and joins nothing. So it is carried as
// well, as a unit of its own: as it is in its slice, and moved into the other shape, by the shortest way, in the other.
// (Two shapes that have each other alone move onto each other by themselves, see motion.h.)

#include "recon/between/blend_units.h"

namespace odontoscope::between {

struct Bridge {
  BlendUnit unit;
  bool hollow = false;
  std::size_t slice = at_lower, contour = 0;  // what is carried
};

/// For each link of material or of voids that has no overlap, but for one whose two contours have no other link. What
/// has holes or islands is not carried, nor what finds no room in the other shape.
std::vector<Bridge> bridges(const SliceSet& slices, const Surroundings& surroundings);

}  // namespace odontoscope::between
