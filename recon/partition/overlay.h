#pragma once
// The overlay of all structures' contours in a slice: the borders between faces of different labels. Inner part of planar_partition.h.

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
  std::vector<Point2> points;      // by x, then y; each is the end of a border
  std::vector<Border> pieces;      // by a, then b, with a < b; they meet in their ends only
  std::size_t crossings = 0;       // points where contours of two structures cross
  double closed_gap = 0;           // area of void given to structures, mm^2
  std::size_t corners_cut = 0;     // by part_corners (corners.h)
};

/// Crossings are computed in doubles and inserted where they fall, by exact predicates, so that the result is planar whatever was rounded.
/// Precondition: every contour's structure is one of `materials`.
Borders overlay(const Slice& slice, const Materials& materials);

}  // namespace odontoscope::partition
