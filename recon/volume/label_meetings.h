#pragma once
// Where three or four labels meet in a cell of the pixel grid, and how their contours go there, so that nothing is left
// between them.
//
// Labels that were not asked for, and what lies outside the image, count as one: the void. Three of which one has two
// neighbouring pixels meet in the middle of the cell. Where a pair across the diagonal keeps apart (two pixels of one
// label, or, of four labels, the pair with the lowest), its two corners are cut off as ever, and the other two labels
// meet along a straight line from the middle of one cut to that of the other. So no more than three ever meet in a
// point, and no label touches itself. Only the diagonal of two void pixels stays open between the two labels beside it,
// and that of two labels that take turns.

#include <array>
#include <cstddef>
#include <vector>

#include "recon/contours/trace.h"
#include "recon/volume/lattice.h"
#include "recon/volume/volume.h"

namespace odontoscope {

class LabelMeetings {
 public:
  /// Labels that are contoured together, as values of pixels.
  explicit LabelMeetings(std::vector<float> labels);

  /// Points of the contour that enters the cell ahead of `stand`, between where it enters and where it leaves, in that
  /// order, are appended to `points`. `value(vertex)` is a pixel's, or any that is no label outside the image.
  template <class ValueAt>
  void append(const Lattice& lattice, const trace::Stand& stand, const ValueAt& value,
              std::vector<Point2>& points) const {
    Cell cell;
    cell.corners = {stand.inside, stand.outside(), stand.outside() + stand.ahead, stand.inside + stand.ahead};
    for (std::size_t i = 0; i < 4; ++i) cell.labels[i] = index(value(cell.corners[i]));
    append(lattice, cell, points);
  }

 private:
  struct Cell {
    std::array<trace::Vertex, 4> corners;  // one after the other, the first inside
    std::array<std::size_t, 4> labels{};   // 0: void
  };
  /// Counted from 1; 0 for the void.
  std::size_t index(float value) const;
  static void append(const Lattice& lattice, const Cell& cell, std::vector<Point2>& points);

  std::vector<float> labels_;  // ascending
};

}  // namespace odontoscope
