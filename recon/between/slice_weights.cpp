#include "recon/between/slice_weights.h"

#include <algorithm>
#include <cstddef>

#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

SliceWeights scaled(const SliceWeights& weights, double factor) {
  SliceWeights result;
  for (std::size_t n = 0; n < 4; ++n) result[n] = weights[n] * factor;
  return result;
}

SliceWeights sum(const SliceWeights& a, const SliceWeights& b) {
  SliceWeights result;
  for (std::size_t n = 0; n < 4; ++n) result[n] = a[n] + b[n];
  return result;
}

/// Slope over the slab at a slice between two chords: of the parabola through all three, were they `beyond` and
/// `height` long. A much thinner neighbour may not carry its slope, with its noise, far into a thick slab.
SliceWeights mixed_slope(const SliceWeights& chord_beyond, double beyond, const SliceWeights& chord, double height) {
  const double counted = std::max(beyond, limits::blend_least_neighbour * height);
  return sum(scaled(chord_beyond, height * height / beyond / (height + counted)),
             scaled(chord, counted / (height + counted)));
}

}  // namespace

SliceWeights slice_weights(const Heights& heights, double share) {
  const double height = heights.upper - heights.lower;
  const SliceWeights chord{0, -1, 1, 0};
  SliceWeights below = chord, above = chord;
  if (heights.before) below = mixed_slope({-1, 1, 0, 0}, heights.lower - *heights.before, chord, height);
  if (heights.after) above = mixed_slope({0, 0, -1, 1}, *heights.after - heights.upper, chord, height);
  if (heights.before && !heights.after) above = sum(scaled(chord, 2), scaled(below, -1));
  if (heights.after && !heights.before) below = sum(scaled(chord, 2), scaled(above, -1));
  const double t = share, rest = 1 - t;
  SliceWeights result{0, rest * rest * (1 + 2 * t), t * t * (3 - 2 * t), 0};
  result = sum(result, scaled(below, t * rest * rest));
  return sum(result, scaled(above, -t * t * rest));
}

}  // namespace odontoscope::between
