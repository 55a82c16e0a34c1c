#pragma once
// Cubic interpolation along z through up to four slices. Inner part of blend.h.
//
// Hermite's cubic between the two slices of the slab, with the slopes of the parabola through each and its neighbours
// (Catmull and Rom 1974, for uneven heights). Without a neighbour on one side the cubic is the parabola through the
// three slices, without any it is a straight line.

#include <array>
#include <optional>

namespace odontoscope::between {

struct Heights {
  std::optional<double> before;  // empty: not used
  double lower = 0, upper = 1;
  std::optional<double> after;
};

/// For before, lower, upper, after; they sum to 1.
using SliceWeights = std::array<double, 4>;

SliceWeights slice_weights(const Heights& heights, double share);

}  // namespace odontoscope::between
