#include "recon/contours/point_tree.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace odontoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t leaf_size = 8;

CGAL::Orientation orientation(Point2 a, Point2 b, Point2 c) {
  return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y));
}

std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

}  // namespace

/// Counter-clockwise unless flat.
struct PointTree::Triangle {
  std::array<std::uint32_t, 3> numbers;
  std::array<Point2, 3> corners;
  Point2 low, high;

  Triangle(const std::vector<Point2>& points, std::uint32_t a, std::uint32_t b, std::uint32_t c)
      : numbers{a, b, c}, corners{points[a], points[b], points[c]} {
    if (orientation(corners[0], corners[1], corners[2]) == CGAL::RIGHT_TURN) std::swap(corners[1], corners[2]);
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [bottom, top] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    low = {left, bottom};
    high = {right, top};
  }

  bool is_corner(std::uint32_t point) const {
    return std::find(numbers.begin(), numbers.end(), point) != numbers.end();
  }

  /// A flat triangle has all its own points, and no others, on neither side of its edges and within its box.
  bool holds(Point2 p) const {
    if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
    for (std::size_t n = 0; n < 3; ++n) {
      if (orientation(corners[n], corners[(n + 1) % 3], p) == CGAL::RIGHT_TURN) return false;
    }
    return true;
  }

  /// False only if no point of the box is in the triangle.
  bool may_meet(Point2 box_low, Point2 box_high) const {
    if (box_high.x < low.x || box_low.x > high.x || box_high.y < low.y || box_low.y > high.y) return false;
    const std::array<Point2, 4> box{box_low, {box_high.x, box_low.y}, box_high, {box_low.x, box_high.y}};
    for (std::size_t n = 0; n < 3; ++n) {
      const Point2 a = corners[n], b = corners[(n + 1) % 3];
      const bool beyond =
          std::all_of(box.begin(), box.end(), [&](Point2 p) { return orientation(a, b, p) == CGAL::RIGHT_TURN; });
      if (beyond) return false;
    }
    return true;
  }
};

PointTree::PointTree(const std::vector<Point2>& points)
    : points_(points), order_(points.size()), position_(points.size()), removed_(points.size(), false) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!points.empty()) build(0, 0, points.size());
  for (std::size_t n = 0; n < order_.size(); ++n) position_[order_[n]] = n;
}

void PointTree::build(std::size_t node, std::size_t begin, std::size_t end) {
  if (nodes_.size() <= node) nodes_.resize(node + 1);
  Point2 low = points_[order_[begin]], high = low;
  for (std::size_t n = begin; n < end; ++n) {
    const Point2 p = points_[order_[n]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  nodes_[node] = {low, high, end - begin};
  if (end - begin <= leaf_size) return;
  const bool wide = high.x - low.x > high.y - low.y;
  const auto at = [&](std::size_t n) { return order_.begin() + static_cast<std::ptrdiff_t>(n); };
  std::nth_element(at(begin), at(middle(begin, end)), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return wide ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
  });
  build(2 * node + 1, begin, middle(begin, end));
  build(2 * node + 2, middle(begin, end), end);
}

void PointTree::remove(std::uint32_t point) {
  removed_[point] = true;
  std::size_t node = 0, begin = 0, end = order_.size();
  for (;;) {
    --nodes_[node].left;
    if (end - begin <= leaf_size) return;
    const bool lower = position_[point] < middle(begin, end);
    node = 2 * node + (lower ? 1 : 2);
    (lower ? end : begin) = middle(begin, end);
  }
}

bool PointTree::any_in_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return any_in(0, 0, order_.size(), Triangle(points_, a, b, c));
}

bool PointTree::any_in(std::size_t node, std::size_t begin, std::size_t end, const Triangle& triangle) const {
  if (nodes_[node].left == 0 || !triangle.may_meet(nodes_[node].low, nodes_[node].high)) return false;
  if (end - begin <= leaf_size) {
    return std::any_of(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                       order_.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t point) {
                         return !removed_[point] && !triangle.is_corner(point) && triangle.holds(points_[point]);
                       });
  }
  return any_in(2 * node + 1, begin, middle(begin, end), triangle) ||
         any_in(2 * node + 2, middle(begin, end), end, triangle);
}

}  // namespace odontoscope
