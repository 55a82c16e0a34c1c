#include "tests/support/plane_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace odontoscope::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ring = std::vector<Point2>;

Kernel::Point_2 cgal(Point2 p) { return {p.x, p.y}; }

bool boxes_apart(Point2 a, Point2 b, Point2 c, Point2 d) {
  return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
         std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
}

bool meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (boxes_apart(a, b, c, d)) return false;
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc == 0 && abd == 0) return true;  // on one line, and the boxes overlap
  return abc * abd <= 0 && cda * cdb <= 0;
}

bool all_different(const Ring& ring) {
  std::set<std::pair<double, double>> seen;
  return std::all_of(ring.begin(), ring.end(), [&](Point2 p) { return seen.insert({p.x, p.y}).second; });
}

std::string breach_in(const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) {
    for (Point2 p : ring)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return "a coordinate that is not finite";
    if (!is_simple(ring)) return "a contour that is not simple";
  }
  for (std::size_t i = 0; i < rings.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!are_disjoint(rings[i], rings[j])) return "two contours that meet";
  return {};
}

}  // namespace

int turn(Point2 a, Point2 b, Point2 c) { return int(CGAL::orientation(cgal(a), cgal(b), cgal(c))); }

int area_sign(const Ring& ring) {
  CGAL::Exact_rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += CGAL::Exact_rational(a.x) * b.y - CGAL::Exact_rational(b.x) * a.y;
  }
  return int(CGAL::sign(twice));
}

bool is_simple(const Ring& ring) {
  const std::size_t n = ring.size();
  if (n < 3 || !all_different(ring)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
    // Neighbours may not fold back onto each other.
    if (turn(a, b, c) == 0 && (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && meet(a, b, ring[j], ring[(j + 1) % n])) return false;
  }
  return true;
}

bool are_disjoint(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (meet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return false;
  return true;
}

bool is_inside(const Ring& ring, Point2 at) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point2 low = ring[i], high = ring[(i + 1) % ring.size()];
    if (low.y > high.y) std::swap(low, high);
    if (low.y <= at.y && at.y < high.y && turn(low, high, at) > 0) inside = !inside;
  }
  return inside;
}

int depth_of(const std::vector<Ring>& rings, std::size_t index) {
  int depth = 0;
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (i != index && is_inside(rings[i], rings[index].front())) ++depth;
  return depth;
}

std::string breach(const ContourStack& stack) {
  if (stack.slices.size() < 2) return "fewer than two slices";
  std::set<double> heights;
  std::size_t contours = 0;
  for (const Slice& slice : stack.slices) {
    if (!std::isfinite(slice.z) || !heights.insert(slice.z).second) return "two slices at one height";
    std::set<std::string> structures;
    for (const Contour& contour : slice.contours) structures.insert(contour.structure);
    for (const std::string& structure : structures) {
      std::vector<Ring> rings;
      for (const Contour& contour : slice.contours)
        if (contour.structure == structure) rings.push_back(contour.points);
      if (std::string what = breach_in(rings); !what.empty()) return what;
    }
    contours += slice.contours.size();
  }
  return contours == 0 ? "no contour" : "";
}

}  // namespace odontoscope::test
