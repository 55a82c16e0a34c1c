#pragma once
// Where a region lies partly over nothing (a ring over a crescent, as enamel's margin does where it ends higher on one
// side), Delaunay joins its free part to the nearest points of the other slice all the same, as cones: sheets that lean
// far through the void. The paper keeps them. They are trimmed here, so that the free part ends flat in its own slice,
// as an isolated region does.
//
// Only tetrahedra go that leave the solid as it was but for its shape: each meets the rest in one disc, so what is
// trimmed is homeomorphic to what was there, manifold where that was, and joined where that was; and no triangle of a
// region is laid bare on both sides, so every section stays exact.

#include <cstddef>
#include <vector>

#include "recon/delaunay/assemble.h"
#include "recon/delaunay/attention.h"
#include "recon/delaunay/slab.h"

namespace odontoscope::delaunay {

/// How far a tetrahedron reaches: the distance of its dual point from its points in the slice where they lie farther,
/// over that in the other slice, which is about half as wide as the region is there. 0 where the dual point lies in a
/// region of the farther slice: what lies over material does not hang over.
double reach(const SlabTetrahedron& tetrahedron, const Planar& lower, const Planar& upper);

/// What went from one slab.
struct TrimmedSlab {
  std::size_t slab = 0;
  std::size_t tetrahedra = 0;
  double volume = 0;  // mm^3
  Point3 place;       // middle of the largest one
  Topology before;    // of the slab's solid
};

/// Takes out tetrahedra that reach farther than limits::overhang, from the free ends on. The order depends on the stack
/// alone. Returns the slabs that lost some, ascending. Precondition: pieces and slices as from solve_slab and
/// add_plates.
std::vector<TrimmedSlab> trim_overhangs(SolvedStack& stack);

}  // namespace odontoscope::delaunay
