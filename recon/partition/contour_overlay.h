#pragma once
// The overlay of all structures' contours in a slice: the borders between faces of different labels. Inner part of
// planar_partition.h.
//
// Where four faces or more meet in a point, corners are cut off until no more than three do: a tiny triangle of one
// face goes to its neighbour. First where one material meets itself across the point (it is parted), then where void
// does (it is closed), then the faces of least priority. Whether two corners of one material that touch are joined
// cannot be told from a slice; a cut decides it, and is counted.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/contour_stack.h"
#include "recon/partition/materials.h"

namespace odontoscope::partition {

/// A straight piece of a border, from point a to point b, between two different labels.
struct Border {
  std::uint32_t a = 0, b = 0;
  Label left = void_label, right = void_label;
};

struct Borders {
  std::vector<Point2> points;  // by x, then y; each is the end of two borders, or of three
  std::vector<Border> pieces;  // by a, then b, with a < b; they meet in their ends only
  std::size_t crossings = 0;   // points where contours of two structures cross
  std::size_t corners_cut = 0;
  double closed_gap = 0;  // area of void given to structures, mm^2
};

/// Crossings are rounded to doubles (planar_pieces.h). Precondition: every contour's structure is one of `materials`.
/// Throws InternalError if rounding does not settle.
Borders overlay(const Slice& slice, const Materials& materials);

}  // namespace odontoscope::partition
