#pragma once
// How likely two free ends are sections of one thing that drifts steadily: the evidence for a link without overlap.
//
// Three sections a, b, c of neighbouring slices lie on a line as far as b's velocity does not change; the radius
// counts as a third coordinate. A section strewn by chance within the reach D would come as near as the miss e with
// probability (e/D)^2, one of m with at most m times that. Multiplied along a line, and by the number of lines that
// could begin by chance, that is the expected number of lines as steady as this one among shapes strewn at random: a
// line is believed if that is small. So two beads in a row say nothing, a long row is certain even if it bends, and
// in a thicket more is asked. (A contrario detection: Desolneux, Moisan, Morel, "From Gestalt Theory to Image
// Analysis", 2008.) A line that hangs on a link that is made already did not begin by chance.

#include <cstdint>
#include <vector>

#include "recon/delaunay/shape_graph.h"

namespace odontoscope::delaunay {

struct DriftCandidate {
  std::size_t slab = 0;
  std::uint32_t lower = 0, upper = 0;
  double line =
      0;  // logarithm of the expected number of lines by chance that are as good as the best one through this link
  double own =
      0;  // the part of it that the link's own triples have: the line's strength is not lent to what hardly fits it
};

using ShapePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// All pairs of free ends of like size within reach of each other, by slab, lower, upper. `apart[slab]` are never
/// paired. An end with more than limits::track_candidates others in reach stands in a clutter and is in no pair. The
/// same line seen upside down has the same evidence.
std::vector<DriftCandidate> drift_candidates(const ShapeGraph& graph, const std::vector<ShapePairs>& apart);

}  // namespace odontoscope::delaunay
