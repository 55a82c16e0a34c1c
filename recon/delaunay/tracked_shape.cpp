#include "recon/delaunay/tracked_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/core/polygon.h"

namespace odontoscope::delaunay {
namespace {

std::vector<Point2> points_of(const ConformedSlice& slice, std::uint32_t contour) {
  const auto first = slice.planar.points.begin();
  return {first + slice.first_point[contour], first + slice.first_point[contour + 1]};
}

std::vector<Point2> backwards(std::vector<Point2> points) {
  std::reverse(points.begin(), points.end());
  return points;
}

struct ShapeBox {
  Point2 low, high;
};

ShapeBox box_of(const std::vector<Point2>& points, Point2 by) {
  ShapeBox box{points.front(), points.front()};
  for (const Point2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return {{box.low.x + by.x, box.low.y + by.y}, {box.high.x + by.x, box.high.y + by.y}};
}

bool meet(const ShapeBox& a, const ShapeBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TrackedShape with_outline(std::vector<Point2> outline, std::size_t number) {
  TrackedShape shape;
  shape.contour = number;
  shape.area = signed_area(outline);
  shape.radius = std::sqrt(std::max(shape.area, 0.0) / std::numbers::pi);
  const ShapeBox box = box_of(outline, {});
  shape.low = box.low;
  shape.high = box.high;
  // A sliver's area may round to nothing; its middle is then that of its box.
  shape.centroid =
      shape.area > 0 ? centroid(outline) : Point2{(shape.low.x + shape.high.x) / 2, (shape.low.y + shape.high.y) / 2};
  shape.contours.push_back(std::move(outline));
  return shape;
}

/// An edge from left to right; what lies below it counts +1 or -1.
struct ShapeEdge {
  Point2 left, right;
  int sign;
  double at(double x) const { return left.y + (right.y - left.y) * ((x - left.x) / (right.x - left.x)); }
};

/// Edges by their left ends, moved by `by`; upright ones have nothing below them, and contours that miss `within`
/// nothing in common with what lies there.
std::vector<ShapeEdge> edges_of(const TrackedShape& shape, Point2 by, const ShapeBox& within) {
  std::vector<ShapeEdge> edges;
  for (const auto& points : shape.contours) {
    if (!meet(box_of(points, by), within)) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2 p = points[i], q = points[i + 1 < points.size() ? i + 1 : 0];
      const Point2 a{p.x + by.x, p.y + by.y}, b{q.x + by.x, q.y + by.y};
      if (a.x < b.x) edges.push_back({a, b, -1});
      if (b.x < a.x) edges.push_back({b, a, 1});
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const ShapeEdge& a, const ShapeEdge& b) { return a.left.x < b.left.x; });
  return edges;
}

/// Area between the height `base` and the lower of two edges.
double area_below(const ShapeEdge& e, const ShapeEdge& f, double base) {
  const double l = std::max(e.left.x, f.left.x), r = std::min(e.right.x, f.right.x);
  if (!(l < r)) return 0;
  const double el = e.at(l) - base, er = e.at(r) - base, fl = f.at(l) - base, fr = f.at(r) - base;
  if ((el - fl) * (er - fr) >= 0) return (r - l) * (el + er < fl + fr ? el + er : fl + fr) / 2;
  const double share = (el - fl) / ((el - fl) - (er - fr)), crossing = el + share * (er - el);
  return (r - l) * (share * (std::min(el, fl) + crossing) + (1 - share) * (crossing + std::min(er, fr))) / 2;
}

}  // namespace

ShapeSlice region_shapes(const ConformedSlice& slice) {
  ShapeSlice result{slice.z, {}};
  for (const std::uint32_t c : slice.outer_contour)
    result.shapes.push_back(with_outline(points_of(slice, c), slice.contour_number[c]));
  std::vector<bool> outer(slice.contour_number.size(), false);
  for (const std::uint32_t c : slice.outer_contour) outer[c] = true;
  for (std::uint32_t c = 0; c < outer.size(); ++c)
    if (!outer[c]) result.shapes[slice.planar.region_of[slice.first_point[c]]].contours.push_back(points_of(slice, c));
  return result;
}

ShapeSlice void_shapes(const ConformedSlice& slice, const SliceVoids& voids) {
  ShapeSlice result{slice.z, {TrackedShape{}}};
  result.shapes[outside].unbounded = true;
  for (const std::uint32_t c : voids.hole_contour)
    result.shapes.push_back(with_outline(backwards(points_of(slice, c)), slice.contour_number[c]));
  for (const std::uint32_t c : slice.outer_contour)
    result.shapes[voids.of_contour[c]].contours.push_back(backwards(points_of(slice, c)));
  return result;
}

double net_area(const TrackedShape& shape) {
  double area = 0;
  for (const auto& points : shape.contours) area += signed_area(points);
  return area;
}

double overlap_area(const TrackedShape& moved, Point2 by, const TrackedShape& still) {
  const ShapeBox box{{moved.low.x + by.x, moved.low.y + by.y}, {moved.high.x + by.x, moved.high.y + by.y}};
  if (!still.unbounded && !meet(box, {still.low, still.high})) return 0;
  const std::vector<ShapeEdge> first = edges_of(moved, by, box), second = edges_of(still, {}, box);
  double widest = 0;
  for (const ShapeEdge& f : second) widest = std::max(widest, f.right.x - f.left.x);
  double area = still.unbounded ? net_area(moved) : 0;
  for (const ShapeEdge& e : first) {
    auto f = std::lower_bound(second.begin(), second.end(), e.left.x - widest,
                              [](const ShapeEdge& edge, double x) { return edge.left.x < x; });
    for (; f != second.end() && f->left.x < e.right.x; ++f) area += e.sign * f->sign * area_below(e, *f, box.low.y);
  }
  return std::max(area, 0.0);
}

double overlap_share(const TrackedShape& a, const TrackedShape& b) {
  const double area = a.unbounded ? overlap_area(b, {}, a) : overlap_area(a, {}, b);
  const double smaller = a.unbounded ? net_area(b) : b.unbounded ? net_area(a) : std::min(net_area(a), net_area(b));
  return smaller > 0 ? std::min(area / smaller, 1.0) : 0;
}

}  // namespace odontoscope::delaunay
