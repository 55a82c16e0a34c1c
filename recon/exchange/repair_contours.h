#pragma once
// Contours that break the rules of contour_stack.h, turned into ones that keep them; every change is told.
//
// What real files have: repeated points, contours without area, contours that run into themselves (keyholes, figures of
// eight), that cross or touch one another. A structure's slice that keeps the rules stays as it is, to the bit. In the
// others
//   - points that repeat their neighbour, contours of fewer than three points, and contours that the slice has already
//   (with Inside::odd), go;
//   - channels of a contour that are at most limits::widest_channel wide are closed (with Inside::odd;
//   close_channels.h);
//   - contours that still break a rule are replaced by the border of the region that they enclose. Edges are cut where
//   they cross, in a
//     constrained Delaunay triangulation (exact predicates; a place of crossing is rounded), whose triangles are then
//     told inside from outside: by an odd number of contours around them, or by winding;
//   - where that region touches itself in a point, all corners but the widest are cut off there, by a 64th of their
//   edges.
// Should rounding have made contours meet, the last two steps are repeated on their own result a few times, its
// coordinates rounded to a grain first (at most 6e-8 of the largest coordinate).

#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

enum class Inside {
  odd,       // within an odd number of contours: what contour files mean
  positive,  // wound around counter-clockwise more often than clockwise: for sections of oriented surfaces
};

struct RepairOptions {
  Inside inside = Inside::odd;
  /// Regions and holes of less area, as a share of the square around the contours repaired, are rounding and go.
  double smallest_share = 1e-10;
};

struct ContourChange {
  Place place;  // file, slice, z; contour where one alone was changed
  std::string structure;
  std::string what;  // "crossed itself at (1, 2): 1 contour became 2"
};

struct RepairedContours {
  ContourStack stack;  // `validate` may still refuse heights, names and counts
  std::vector<ContourChange> changes;
};

/// Preconditions: coordinates finite and within limits::largest_coordinate. Throws InputError beyond-repair, or
/// Cancelled. Stage "repair". Slices are numbered as in `stack`; the result does not depend on the number of threads.
RepairedContours repair_contours(const ContourStack& stack, const RepairOptions& options = {},
                                 const Progress& progress = {});

/// "tooth.csl: slice 3 (z = 1.5), contour 2, pulp: 1 point repeated its neighbour and went".
std::string in_words(const ContourChange& change);

}  // namespace odontoscope
