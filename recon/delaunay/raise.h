#pragma once
// The way out where lifting finds no place for a point (tetrahedra thinner than double precision can split). It always
// works.
//
// The slab's triangulation is moved off both slices as a whole: its combinatorics do not depend on the slab's height,
// and every tetrahedron stays positive whatever its shape, since the sign is that of an area in the plane times a
// height. What the regions of a slice bound is filled by upright prisms, from the slice to the raised triangulation. So
// external edges of restored tetrahedra no longer lie in a slice, and the solid meets each slice in its regions alone.
// It takes more points than lifting, and its walls are upright near the slices.

#include "recon/delaunay/lift.h"

namespace odontoscope::delaunay {

/// Arguments and numbering as for lift. Returns false only if there are no two doubles strictly between the heights.
bool raise(const SlabTetrahedra& tetrahedra, const Fates& fate, const Planar& lower, const Planar& upper,
           SlabHeights heights, std::uint32_t whole_lower, std::uint32_t whole_upper, SlabSolid& solid);

}  // namespace odontoscope::delaunay
