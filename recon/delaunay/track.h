#pragma once
// Correspondence over several slices: what hangs free in a slab is linked by what the slices before and behind say.
// The same for regions and for voids, so that a thin slanted canal is one tube, whether it is drawn as pulp or as a
// hole in dentine.
//
// A criterion for one slab sees two slices; a canal that drifts by more than its own width falls to beads there. Its
// drift over several slices tells where it goes on. Only free ends get links: shapes that nothing in a neighbouring
// slice is linked with. Nothing that was made is taken back but some openings (below). In this order:
//   drift:   two free ends that continue each other's steady drift (drift.h), each the other's best;
//   entry:   a free end that its drift takes into a shape, be that linked or not: a canal that joins the chamber, a
//     fork; a quarter of it is enough, half of it where that is the outside. Not where the end is running out: a cusp's
//     tip that leans towards another cusp is not joined with it;
//   overlap: a free end and what it overlaps most (candidates are the witnesses that were too weak to be made, and for
//   what is linked with
//     nothing at all whatever it lies over);
//   beside:  loose bits beside a body (bits.h), always doubtful.
// A void that only lies over the outside of the next slice, as a canal does beside a root's tip, opens there; not if it
// is running out and its drift takes it under the tip: then it closes before. Either is doubtful, and so is one that is
// running out beside the surface it drifts through. Tracked links alone close no loop. Not supported: a line whose
// sections are linked wrongly already (two parallel canals, so near that each lies over the other one slice on).

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/delaunay/correspond.h"
#include "recon/delaunay/drift.h"

namespace odontoscope::delaunay {

/// What is known of one slab before tracking, in shape numbers.
struct KnownLinks {
  std::vector<RegionLink> made;         // links that hold
  std::vector<RegionLink> overlapping;  // further pairs with a witness
  ShapePairs apart;                     // never to be linked: the user's word
};

enum class TrackedBy { drift, entry, overlap, beside };

struct TrackedLink {
  std::uint32_t lower = 0, upper = 0;
  TrackedBy by = TrackedBy::drift;
};

/// A choice that the slices do not settle: a link that would change the topology if it were decided the other way.
enum class Choice {
  may_connect,  // not linked, but it may be meant
  may_part,     // linked, but it may not be meant
};

struct DoubtfulLink {
  Choice choice = Choice::may_connect;
  TrackedBy by = TrackedBy::drift;                                     // what speaks for the link
  std::size_t slab = 0;                                                // between slices slab and slab + 1
  std::uint32_t lower = 0, upper = 0;                                  // shapes
  std::size_t lower_contour = no_contour, upper_contour = no_contour;  // their outlines' numbers in their slices' lists
  Point3 at;                                                           // halfway between them, mm
};

struct Tracking {
  std::vector<std::vector<TrackedLink>> links;  // of each slab: those to add, by lower, upper
  std::vector<ShapePairs> closed;               // of each slab: made links that do not hold after all
  std::vector<DoubtfulLink> doubtful;           // by slab, lower, upper; each pair once
};

/// Preconditions: slices by ascending z, one KnownLinks for each pair of neighbours, shape numbers within range.
/// Depends on nothing but its arguments. Time: near-linear in shapes and links but for overlaps, which take the
/// product of the points of two shapes at worst.
Tracking track(const std::vector<ShapeSlice>& slices, const std::vector<KnownLinks>& slabs);

/// Parts `witnessed` (of the widest criterion, as witnessed_links gives them) into the links of `slab` that hold by
/// `criterion` and those that only overlap. For regions use correspond()'s links as `made` where the user chose links
/// of his own.
KnownLinks links_by(const std::vector<RegionLink>& witnessed, Correspondence criterion);

}  // namespace odontoscope::delaunay
