#pragma once
// Interpolated slices in which what is linked is joined, once, and nothing else is. Inner part of blend.h.
//
// Blended distances know nothing of links: where the two ends of an open ring all but meet, or a wall is thinner than a
// step of the grid, they close and open passages at will, and each is a handle that nobody asked for. All slices of a
// slab are looked at together, and changed at single grid points:
// - a region of material or of void that is joined with no given one is taken away;
// - a region that would join given ones which links keep apart is parted, along a wall (or a gap) one step wide,
// half-way between them in steps;
// - two regions of one slice that are joined below it and above it, where links make no loop, are joined in it, too, by
// the shortest passage, if that is short.

#include <vector>

#include "recon/between/blend_units.h"
#include "recon/between/composed.h"

namespace odontoscope::between {

/// `slices` in the order of their heights. Best effort: passages that would be long are left out, and what is mended
/// for the void may part the material. All come back as windows of one size, whose borders are outside.
void keep_links(std::vector<Window>& slices, const Grid& grid, const SliceSet& given, const Surroundings& links);

}  // namespace odontoscope::between
