#pragma once
// How linked shapes move from slice to slice. Inner part of blend.h.

#include <array>

#include "recon/between/blend_units.h"
#include "recon/between/plane_distance.h"

namespace odontoscope::between {

/// A shape's own frame in each slice: a point p of the slice is at (p - origin) / scale in it. All origins 0 and scales
/// 1 for shapes that are not moved.
struct Motion {
  bool moves = false;
  std::array<Point2, slices_used> origin{};
  std::array<double, slices_used> log_scale{};  // natural logarithm

  /// The frame at a height in between, on a cubic path.
  Point2 origin_at(const SliceWeights& weights) const;
  double scale_at(const SliceWeights& weights) const;
};

/// Shapes that overlap well (limits::blend_good_overlap of the smaller one's area) are not moved; those that hardly do
/// (limits::blend_poor_overlap) move by their centroids, if that makes them overlap better, and change their size too
/// if that makes them overlap better still; in between they move by a part of it, so that nothing jumps. A change of
/// size is the ratio of the root mean square distances from the centroid. `step` is that of the grid.
Motion motion_of(const BlendUnit& unit, double step);

/// The shape in its frame.
Outline in_frame(const Outline& shape, const Motion& motion, std::size_t slice);

}  // namespace odontoscope::between
