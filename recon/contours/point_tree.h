#pragma once
// Points of a plane in a tree, to be asked whether a triangle holds one, and taken out one by one. Inner part of
// simplify_contours.h.
//
// A k-d tree (Bentley 1975) with the number of points left in every node; how the points are strewn does not matter.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

class PointTree {
 public:
  /// `points` must outlive the tree; they are known by their numbers.
  explicit PointTree(const std::vector<Point2>& points);

  /// Precondition: it is still there.
  void remove(std::uint32_t point);

  /// Is a point that is left, other than its corners, in the closed triangle? Exact. The corners may lie on a line:
  /// then it is the segment that they span.
  bool any_in_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

 private:
  struct Node {
    Point2 low, high;      // of all points that were in it at first
    std::size_t left = 0;  // how many are still there
  };
  struct Triangle;

  void build(std::size_t node, std::size_t begin, std::size_t end);
  bool any_in(std::size_t node, std::size_t begin, std::size_t end, const Triangle& triangle) const;

  const std::vector<Point2>& points_;
  std::vector<std::uint32_t> order_;   // the points, every node a range of it
  std::vector<std::size_t> position_;  // of each point in order_
  std::vector<bool> removed_;
  std::vector<Node> nodes_;  // children of n at 2 n + 1 and 2 n + 2
};

}  // namespace odontoscope
