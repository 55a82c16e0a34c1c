#pragma once
// What one outline's contours are like and how they lie in each other. Inner part of blend.h.

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "recon/between/blend.h"

namespace odontoscope::between {

struct Box {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(low.x <= high.x); }
  bool holds(const Box& other) const;
  void take(Point2 p);
  void take(const Box& other);
};

struct ContourFacts {
  double area = 0;  // positive for outer contours, which its sign bit says even where it is too small for a number
  double perimeter = 0;
  Point2 centroid;  // of the area within
  Box box;
  /// The contour directly around it, or none.
  std::size_t parent = none;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  bool outer() const { return !std::signbit(area); }
};

std::vector<ContourFacts> facts_of(const Outline& outline);

/// Numbers of contours by descending area, so that each comes after those around it.
std::vector<std::size_t> outside_in(const std::vector<ContourFacts>& facts);

/// For each contour of a the one of b that it continues in, or none: of the same kind, at most four times as large or
/// small, near for their size, and each the other's best.
std::vector<std::size_t> partners(const std::vector<ContourFacts>& a, const std::vector<ContourFacts>& b);

}  // namespace odontoscope::between
