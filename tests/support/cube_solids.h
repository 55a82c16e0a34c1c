#pragma once
// Solids of unit cubes with their contours, made by hand or at random: for tests of the oracle, whose truth is counted
// on pictures.

#include <optional>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// Rows of a picture, '#' for material; the first row has y = 0. Cells of one kind that meet only across a corner are
/// not allowed.
using Picture = std::vector<std::string>;

/// Each cell one cube of six tetrahedra, layer by layer from z = 0; surface and report are left empty.
Solid cubes(const std::vector<Picture>& layers);

/// Outlines of a picture, every lattice point on them a point: outer contours counter-clockwise, holes clockwise.
class Outlines {
 public:
  explicit Outlines(const Picture& picture);
  const std::vector<std::vector<Point2>>& rings() const { return rings_; }
  /// Number of the outer contour of the region that has cell (x, y); of the hole that has it; none for the outside.
  std::optional<std::size_t> contour_round(std::size_t x, std::size_t y) const { return round_[y][x]; }

 private:
  std::vector<std::vector<Point2>> rings_;
  std::vector<std::vector<std::optional<std::size_t>>> round_;
};

/// The slices of a solid of cubes: the picture of the layer above each height (below the last).
ContourStack stack_of_cubes(const std::vector<Picture>& layers, const std::vector<std::size_t>& heights);

/// Cells of one kind that are joined across edges: for each cell the number of its piece, material and void counted
/// alike; `count` of them.
std::vector<std::vector<std::size_t>> pieces_of(const Picture& picture, std::size_t& count);

/// No 2 x 2 cells with material, or void, across a corner alone.
bool has_plain_corners(const Picture& picture);

}  // namespace odontoscope::test
