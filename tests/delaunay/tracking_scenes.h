#pragma once
// Circles in slices that stand for canals, roots and cusps, and what correspondence over several slices makes of them.

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "recon/delaunay/track.h"
#include "tests/delaunay/conformed.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {

struct Disc {
  Point2 at;
  double radius;
};
using Scene = std::vector<std::vector<Disc>>;  // of each slice, upwards

inline constexpr double cut = 0.5;    // mm between slices
inline constexpr double thin = 0.15;  // radius of a canal, mm

Ring disc_ring(const Disc& disc);
ContourStack stack_of_discs(const Scene& scene, double height);
/// The same discs as holes in one large outline.
ContourStack stack_of_holes(const Scene& scene, double height);
Scene straight(int slices, double step, double radius);
/// Two canals at 45 degrees side by side, `gap` apart along their drift.
Scene parallel_canals(double gap);
/// Two canals at 45 degrees that pass each other.
Scene passing_canals();
/// A canal that ends, and another one that begins in the next slice somewhere else.
Scene canal_that_ends();
/// An upright canal that forks into two at 45 degrees.
Scene fork();
/// A chamber through all slices, and a canal at 45 degrees that runs into it.
Scene accessory_canal();
/// Two domes on one base that lean towards each other, one higher than the other.
Scene leaning_cusps();
/// A root that tapers to its apex, upside down, beside another one that goes on.
Scene apex_beside_root();
/// A cone that leans so far over that, moved on, its tip would lie in the column beside it.
Scene tip_that_leans_on_a_column();
/// Islands strewn at random, none touching another.
Scene strewn(std::uint64_t seed, int slices = 8, int islands = 15);

struct Tracked {
  std::vector<delaunay::ShapeSlice> slices;
  std::vector<delaunay::KnownLinks> slabs;
  delaunay::Tracking tracking;

  std::size_t count(delaunay::TrackedBy by) const;
  std::size_t count() const;

  /// All links, made and tracked: slab, lower, upper.
  std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> links() const;

  /// Connected things, the outside left out.
  std::size_t pieces() const;
};

Tracked tracked(const ContourStack& stack, Correspondence criterion = Correspondence::medial,
                const std::map<std::size_t, delaunay::ShapePairs>& apart = {});
Tracked tracked_voids(const ContourStack& stack);
/// One piece, each slice linked with the next once.
void expect_one_chain(const Tracked& made, std::size_t slices);

}  // namespace odontoscope::test
