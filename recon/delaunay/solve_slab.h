#pragma once
// One slab from its two slices to disjoint, embedded solid pieces. A value that depends on nothing but its arguments,
// so that slabs can be solved in any order, on any thread, and again alone when a link changes.

#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/delaunay/correspond.h"
#include "recon/delaunay/crossing.h"
#include "recon/delaunay/lift.h"

namespace odontoscope::delaunay {

struct SolvedSlab {
  /// Pieces that have no point in common, one for each component, in the order of their lowest region.
  std::vector<SlabSolid> pieces;
  std::vector<RegionLink> links;                 // those that hold in the result
  std::size_t cut_links = 0;                     // witnessed, but given up by case 3 below
  bool raised = false;                           // some piece is (raise.h)
  std::vector<bool> lower_linked, upper_linked;  // of each region: does it carry a piece in this slab?
};

/// How what repair put back leaves the slices: lifted where that works, else raised; or raised in any case, which
/// leaves room for plates.
enum class Walls { lifted, raised };

struct SlabTask {
  const ConformedSlice& lower;
  const ConformedSlice& upper;
  Correspondences correspondences;  // by correspond, from ...
  Choices choices;                  // ... these
  Walls walls = Walls::lifted;
  Place place;  // for messages
};

/// Steps 2 to 6. Components are triangulated apart from each other. Where two would then cross or touch, they are
///   1. carved from their one common Delaunay triangulation, which keeps them disjoint, if that covers all their
///   regions; else
///   2. made one component (links with criterion `crossing`), unless the user keeps a pair of their regions apart; else
///   3. cut: their regions end flat on their slices. A link that the user asked for is never cut: where it cannot be
///   built, witnessed links of its component,
///      then all of the slab, are cut instead; InputError link-impossible if that does not help either.
/// Where a slice is not conforming (conform.h), every component is a block (block.h), case 1 is left out, and a
/// component without room for a block is cut. Throws InputError slices-too-close if a piece must leave a slice and no
/// double lies between the two.
SolvedSlab solve_slab(const SlabTask& task, const Progress& progress);

/// Throws InputError slices-too-close.
[[noreturn]] void refuse_too_close(const SlabTask& task);

/// The boundary of a slab's solid, by place.
Boundary boundary_of(const ConformedSlice& lower, const ConformedSlice& upper, const SlabSolid& solid);

}  // namespace odontoscope::delaunay
