#pragma once
// Loose bits beside a body: what else hangs free of a structure that is, but for crumbs, one piece.
//
// A thin canal that runs flat through few slices leaves two or three sections, each a bead that no rule for steady
// lines can believe: two points are a line whatever they are. But most of such a structure is one body, and a bead that
// ends facing it, or another bead, no farther off than some of its own widths is its part sooner than a thing of its
// own. Where there is no body, as among islands, nothing is said, and where there are many bits none is told from
// noise.
//
// Ends that are running out, as tips do, come last, and only over what they lie on. The shortest gaps are bridged first
// (a minimum spanning tree: J. B. Kruskal, Proc. AMS 7(1), 1956), as long as they join pieces; what does not reach the
// body in the end is left alone. Each such link is a guess, and to be told as one.

#include <cstdint>
#include <functional>
#include <vector>

#include "recon/delaunay/drift.h"
#include "recon/delaunay/shape_graph.h"

namespace odontoscope::delaunay {

/// Share of the area of all sections that a body has at least, and slices that it goes through at least.
inline constexpr double body_share = 0.5;
inline constexpr std::size_t body_slices = 5;
/// Area of all sections of a bit, at most, over the body's: more is a part of its own, as a root is.
inline constexpr double bit_share = 0.1;
/// Gap that is bridged at most, over the width (root of the area) of the smaller section: a canal at 20 degrees to the
/// slices leaves one, and as much again is left for bends. Less to a section of another size: a crumb beside the body
/// is no canal.
inline constexpr double bit_gap = 2;
inline constexpr double bit_gap_unlike = 1;
/// Slices in a row through which an open void is a canal sooner than a pit.
inline constexpr std::size_t row_slices = 3;
/// Wall that is left where a canal leaves, over that in its own slice, and over the canal's width: it falls to nothing
/// within one slice, and that of an apex that closes does not.
inline constexpr double outlet_wall = 0.25;
inline constexpr double outlet_gap = 0.5;
/// What the root measures in the next slice at least, over its own: less is an apex, and its canal may close.
inline constexpr double outlet_taper = 0.5;
/// Area of a hole, over that of the root around it, up to which it is a canal, and its wall too thick to be passed over
/// within a slab as enamel's is.
inline constexpr double canal_share = 0.25;
/// Least part of a canal's section that lies over a notch: below that it is what contours are off.
inline constexpr double lobe_share = 1e-3;
/// Gap between a canal and a notch, over the canal's width, that may be the slab's doing.
inline constexpr double lobe_gap = 0.05;
/// Bits beyond which nothing is told from noise.
inline constexpr std::size_t most_bits = 48;

struct BitLink {
  std::size_t slab = 0;
  std::uint32_t lower = 0, upper = 0;
};

/// Is the free end of shape i of slice k, above it or below, one that ends by itself (a tip)?
using EndsByItself = std::function<bool(std::size_t k, std::uint32_t i, bool up)>;

/// Links to add, by slab, lower, upper. Each has a free end; together they close no loop. `apart[slab]` are never
/// paired. Shapes that are unbounded belong to no piece; what is linked with one is joined only if it is a row of
/// `row_slices` sections of like size: a pit is open, and no canal.
std::vector<BitLink> links_of_bits(const ShapeGraph& graph, const std::vector<ShapePairs>& apart,
                                   const EndsByItself& ends_by_itself);

/// Does a canal that ends here leave through the outside in the next slice? Seen from above, next to nothing is left
/// there of the wall that is between the two in its own slice: a notch takes it up. Preconditions: `end` is bounded,
/// the two others are the outside of its own slice and of the next one.
bool leaves_through(const TrackedShape& end, const TrackedShape& outside_here, const TrackedShape& outside_next);

/// Does a part of a canal's section, a lobe, lie over the outside of the next slice? The other arguments are those of
/// leaves_through.
bool lies_over_notch(const TrackedShape& canal, const TrackedShape& outside_here, const TrackedShape& outside_next);

/// The same with a gap between the two that is next to nothing, and of the wall in the canal's own slice.
bool all_but_reaches_notch(const TrackedShape& canal, const TrackedShape& outside_here,
                           const TrackedShape& outside_next);

}  // namespace odontoscope::delaunay
