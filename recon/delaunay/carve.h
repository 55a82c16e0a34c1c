#pragma once
// From a slab's Delaunay tetrahedra to a solid piece: which stay, and which must be put back to make it a manifold.

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/delaunay/slab.h"

namespace odontoscope::delaunay {

enum class Fate : std::uint8_t { removed, kept, restored };
using Fates = Table<TetIndex, Fate>;
/// Which component each tetrahedron belongs to; none: to nobody.
using Owners = Table<TetIndex, std::uint32_t>;

/// Step 4, elimination, by plane geometry alone: a 3-1 (1-3) stays with its triangle, if that is inside; a 2-2 goes
/// with an external edge; with two contour edges it goes when its dual point lies outside both regions (a rule that the
/// paper lacks, without which a canal of nearly round contours is plugged); else it stays.
Fates eliminate(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper);

/// Step 5, repair: puts removed tetrahedra back until the kept ones form a PL 3-manifold: around each edge one fan, and
/// in the link of each vertex both the kept and the removed part connected (what lies beyond the hull and the slices
/// counts as removed). Then, where nothing was restored before the call, takes out again those that turned out not to
/// be needed. Always ends where everything may be restored, since the hull is a ball. `owner[t]` none forbids a
/// tetrahedron; returns false if a singularity can then not be repaired. Precondition: every internal triangle of both
/// slices carries a kept tetrahedron.
bool repair(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper, const Owners& owner,
            Fates& fate);

/// Puts back the shortest ways through faces that make the kept tetrahedra of each owner one piece: regions that are
/// linked but whose tetrahedra never meet (the user can link what lies far apart). `owner[t]` none: t belongs to nobody
/// and stays out. Returns how many were put back; the result has to be repaired again. Empty if there is no way.
std::optional<std::size_t> connect(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper,
                                   const Owners& owner, Fates& fate);

}  // namespace odontoscope::delaunay
