#pragma once
// The last resort, for slices whose contours cannot be made Delaunay (conform.h): a slab that asks nothing of them but
// to be simple and disjoint.
//
// Upright prisms fill the regions, from either slice to near the middle of the slab. There a thin block joins all of
// them: the convex hull of the two ends, as a fan of tetrahedra from one point within it to its faces. What the prisms
// leave open, canals too, is shut by the block, and what lies over each other is not asked: the sections are exact and
// the solid is a certified manifold, but between the slices it is crude.

#include "recon/delaunay/lift.h"

namespace odontoscope::delaunay {

enum class Blocked {
  yes,
  no_height,  // fewer than three doubles lie between the slices
  no_place,   // the hull is so thin that no double was found within it
};

/// `lower` and `upper` hold a component's points (part_of), contours and regions' triangles; no edge need be Delaunay,
/// but the triangles fill the convex hull of the points. Numbering of `solid` as for lift; nothing is added unless it
/// can be built.
Blocked block(const Planar& lower, const Planar& upper, SlabHeights heights, std::uint32_t whole_lower,
              std::uint32_t whole_upper, SlabSolid& solid);

}  // namespace odontoscope::delaunay
