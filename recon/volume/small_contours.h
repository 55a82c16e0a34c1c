#pragma once
// What became of contours too small to be kept, and of those that hang together by corners only. Inner part of
// contour_levels.h.
//
// A canal's section is small, too: one that goes on in the next slice is no noise.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

/// A contour that was left out.
struct DroppedContour {
  std::size_t level = 0;
  double area = 0;  // mm^2, without sign
  bool is_hole = false;
  std::vector<Point2> points;
};

struct DroppedCounts {
  std::size_t holes = 0, islands = 0;
  double largest_area = 0;  // mm^2
  /// How many overlap one of their own kind (hole or island) in a neighbouring slice, kept or dropped.
  std::size_t going_on = 0;
  /// The longest run of dropped ones through slices, each over the last.
  std::size_t longest_run = 0;
  /// Where that run begins, and the middle of its first contour's box.
  std::size_t run_slice = 0;
  Point2 run_at;
  /// False if there are too many to tell what goes on (limits::small_contour_pairs).
  bool looked_at = true;
};

/// A slice's contours of all levels, kept and dropped.
struct TracedLevels {
  const std::vector<Contour>* kept = nullptr;
  const std::vector<DroppedContour>* dropped = nullptr;
};

/// Fills in what goes on, and the longest run; `counts` holds the rest already, and stays as it is if not all was kept
/// to be looked at.
void find_runs(const std::vector<TracedLevels>& slices, std::size_t level, const std::string& structure,
               DroppedCounts& counts);

/// Contours that overlap none of their kind in either neighbouring slice, but come within `reach` (a voxel, x and y) of
/// one that is as lonely: a canal one voxel wide that runs aslant falls into such pieces.
std::size_t count_pieces(const std::vector<TracedLevels>& slices, const std::string& structure, Point2 reach);

}  // namespace odontoscope
