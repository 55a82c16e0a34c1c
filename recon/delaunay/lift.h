#pragma once
// Step 6: tetrahedra that repair put back still have external edges in a slice. Each such edge is split near its
// midpoint and the new point moved off the plane, so that the solid meets the plane in its regions alone.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/delaunay/carve.h"
#include "recon/delaunay/slab.h"

namespace odontoscope::delaunay {

/// A piece of solid within one slab. Points: the lower slice's points, then the upper slice's (numbers of the two
/// slices' whole triangulations), then `added`.
struct SlabSolid {
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;  // positive
  std::vector<float> reach;  // of each tetrahedron, or of the one that it is a part of (see overhang.h); empty: all 0
  std::vector<Point3> added;
  std::size_t restored = 0;     // tetrahedra put back, before they were split
  double largest_sideways = 0;  // of a lifted point, over the length of its edge
  bool raised = false;          // no room to lift: see raise.h
};

/// Takes out added points that no tetrahedron has. `on_slices`: how many points lie on the two slices.
void drop_unused(SlabSolid& solid, std::uint32_t on_slices);

struct SlabHeights {
  double lower = 0, upper = 0;
};

/// Splits and lifts, and hands out the kept and restored tetrahedra. The whole star of a split edge, removed tetrahedra
/// included, keeps positive orientation by exact test, so the result is embedded. A lifted point goes straight up (from
/// the upper slice: down) as far as its star allows, at most limits::lift_height of the slab; where it allows nothing,
/// sideways into the star, at most limits::lift_sideways of the edge's length. Returns false if rounding leaves no
/// place for a point (tetrahedra thinner than double precision can split). `solid` numbers points as said above:
/// `whole_lower` is the number of points of the whole lower slice, `whole_upper` of the upper.
bool lift(const SlabTetrahedra& tetrahedra, const Fates& fate, const Planar& lower, const Planar& upper,
          SlabHeights heights, std::uint32_t whole_lower, std::uint32_t whole_upper, SlabSolid& solid);

}  // namespace odontoscope::delaunay
