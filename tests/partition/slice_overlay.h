#pragma once
// What a slice's contours say: which structure owns a place, where borders run, which labels meet in a point, what area
// each label has.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"
#include "tests/partition/partition_oracle.h"

namespace odontoscope::test {

/// Labels count from 1 in the order of `structures`.
class SliceOverlay {
 public:
  SliceOverlay(const Slice& slice, const std::vector<std::string>& structures, const PartitionRule& rule);

  /// How near is too near to tell, mm.
  double rounding() const { return rounding_; }
  /// Exact, unless `p` lies on a contour.
  Label label_at(Point2 p) const;
  /// To the nearest contour; of one structure, if a label is given.
  double distance(Point2 p, Label of = void_label) const;
  /// Are p's surroundings told exactly: does no contour pass it nearer than rounding without running through it?
  bool clear(Point2 p) const;
  /// The labels round a point of a contour, counter-clockwise, neighbours different; one entry: no border is visible
  /// there.
  std::vector<Label> round(Point2 p) const;
  /// May corners have been cut here?
  bool may_be_cut(Point2 p) const;
  /// Twice the area that corners cut may move between labels.
  double cut_area() const;
  /// Area of each label, void left out, to about 1e-18 of the slice's.
  std::vector<long double> areas() const;
  double length() const;
  std::vector<Point2> points() const;

 private:
  struct Edge {
    Point2 a, b;  // the structure's region to the left
    Label label;
  };
  struct Cut {
    Point2 at;
    double radius;
  };
  void find_cuts();
  void consider(Point2 p, bool given);
  std::vector<Label> by_rank_;                           // the first wins
  std::vector<std::vector<std::vector<Point2>>> rings_;  // by label - 1
  std::vector<Edge> edges_;
  std::vector<Cut> cuts_;
  double rounding_ = 0;
};

}  // namespace odontoscope::test
