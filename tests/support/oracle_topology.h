#pragma once
// The oracle's topological certificate: has each slab of a solid the pieces, handles and bubbles that its contours and
// their links imply, and no other? Counted from the tetrahedra alone.
//
// Found, for the tetrahedra between two neighbouring slices: pieces by shared faces; bubbles as boundary surfaces
// beyond one a piece; handles as pieces + bubbles - Euler characteristic (V - E + F - T, each piece counted for
// itself). Which regions a piece joins, and which void regions the space beside it joins (over the walls between the
// slices, each of which has one void on its side), is read off the contours' own points.
//
// Implied, with the material regions of both slices as nodes and material links as edges:
//   pieces  = components of that graph. A region that is linked to nothing may have a plate in this slab or none: as
//   found. With one its
//             holes are joined to the void round it; without one neither it nor its holes count, and what its holes
//             hold lies in that void;
//   bubbles = 0;
//   handles = holes of all regions + (links - regions + components) - components of the graph of void regions that do
//   not reach the outside.
// Void regions are the outside, one for both slices, and every hole; void links are its edges.
//
// A handle and a sheet in one slab would cancel in the numbers: therefore the partition of regions into pieces, and of
// void regions into hollows, must be those of the links, too.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"
#include "recon/input/links.h"

namespace odontoscope::test {

/// Two void regions that the space between slice `slice` and the next joins; each the hole within a contour (its number
/// in its slice's list), or, without a number, the outside. Slices by ascending z, as in Link.
struct VoidLink {
  std::string structure = "tooth";
  std::size_t slice = 0;
  std::optional<std::size_t> lower, upper;
};

struct SlabCount {
  long pieces = 0, handles = 0, bubbles = 0;
  long euler() const { return pieces - handles + bubbles; }
  friend bool operator==(const SlabCount&, const SlabCount&) = default;
};

struct JudgedSlab {
  std::size_t slab = 0;  // number of its lower slice
  SlabCount expected, found;
  bool manifold =
      true;  // by itself; a slab that overhangs were trimmed from may be pinched although the whole solid is not
  bool unlinked_hole = false;       // a region that is linked to nothing, and has a hole, carries something
  std::vector<std::string> faults;  // empty: as implied
};

/// One entry for each slab, also those without a tetrahedron. Links and void links of other structures are passed over;
/// `connect` must be true in all. Without `void_links` those count that the solid itself shows: then handles are
/// judged, but not which hollows connect. Precondition: the oracle certified the solid (oracle.h); `stack` in any
/// order.
std::vector<JudgedSlab> slab_topology(const Solid& solid, const ContourStack& stack, const std::vector<Link>& links,
                                      const std::optional<std::vector<VoidLink>>& void_links);

struct TopologyVerdict {
  /// Slabs that are not as their links imply, "tooth, slab 3: has a handle too many".
  std::vector<std::string> not_as_implied;
  /// Where what the result says of itself (Reconstruction::topology) is not so: a slab is missing, or another count was
  /// found, or fewer or more is implied. Through interpolated slices a region that is linked to nothing may end in a
  /// roof over its holes, or open: then what is implied is not compared.
  std::vector<std::string> untrue;
};

/// Judges all solids of a result by its own links and void links.
TopologyVerdict judge_topology(const Reconstruction& result, const ContourStack& stack);

}  // namespace odontoscope::test
