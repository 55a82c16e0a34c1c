#include "tests/support/refusal_check.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

using Exact = CGAL::Exact_rational;
using Ring = std::vector<Point2>;

double unit_of(double value) { return std::nextafter(std::abs(value), 1e300) - std::abs(value); }

Exact squared_distance(Point2 p, Point2 a, Point2 b) {
  const Exact dx = Exact(b.x) - a.x, dy = Exact(b.y) - a.y, px = Exact(p.x) - a.x, py = Exact(p.y) - a.y;
  const Exact along = px * dx + py * dy, length = dx * dx + dy * dy;
  if (along <= 0) return px * px + py * py;
  if (along >= length) return (px - dx) * (px - dx) + (py - dy) * (py - dy);
  const Exact cross = px * dy - py * dx;
  return cross * cross / length;
}

bool nearer_than(double limit, Point2 p, Point2 a, Point2 b) {
  if (p.x < std::min(a.x, b.x) - 2 * limit || p.x > std::max(a.x, b.x) + 2 * limit) return false;
  if (p.y < std::min(a.y, b.y) - 2 * limit || p.y > std::max(a.y, b.y) + 2 * limit) return false;
  return squared_distance(p, a, b) < Exact(limit) * limit;
}

bool too_close_within(const Slice& slice) {
  double largest = 0;
  for (const Contour& contour : slice.contours)
    for (Point2 p : contour.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double limit = parted_ulps * unit_of(largest);
  for (const Contour& of : slice.contours)
    for (Point2 p : of.points)
      for (const Contour& to : slice.contours) {
        if (to.structure != of.structure) continue;
        const std::size_t n = to.points.size();
        for (std::size_t i = 0; i < n; ++i) {
          const Point2 a = to.points[i], b = to.points[(i + 1) % n];
          if (!(a == p) && !(b == p) && nearer_than(limit, p, a, b)) return true;
        }
      }
  return false;
}

bool too_close_in_height(const ContourStack& stack, std::size_t k) {
  if (k + 1 >= stack.slices.size()) return false;
  double z = stack.slices[k].z;
  for (int i = 0; i < parted_heights; ++i) z = std::nextafter(z, 1e300);
  return z >= stack.slices[k + 1].z;
}

/// Contours of slab k joined by forced links: for (upper slice?, contour) the number of its part.
using Parts = std::map<std::pair<bool, std::size_t>, std::size_t>;

Parts parts_of(const std::vector<Link>& links, const std::string& structure, std::size_t slab) {
  Parts parts;
  for (const Link& link : links)
    if (link.structure == structure && link.slice == slab) {
      parts.emplace(std::pair{false, link.lower}, parts.size());
      parts.emplace(std::pair{true, link.upper}, parts.size());
    }
  for (const Link& link : links)
    if (link.structure == structure && link.slice == slab && link.connect) {
      const std::size_t from = parts.at({true, link.upper}), to = parts.at({false, link.lower});
      for (auto& [contour, part] : parts)
        if (part == from) part = to;
    }
  return parts;
}

Ring hull_of(Ring points) {
  std::sort(points.begin(), points.end(), [](Point2 a, Point2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Ring hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t kept = hull.size();
    for (Point2 p : points) {
      while (hull.size() >= kept + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

bool hulls_meet(const Ring& a, const Ring& b) {
  return !are_disjoint(a, b) || is_inside(a, b[0]) || is_inside(b, a[0]);
}

bool some_parts_cross(const ContourStack& stack, const std::vector<Link>& links) {
  for (const Link& apart : links) {
    if (apart.connect) continue;
    const Parts parts = parts_of(links, apart.structure, apart.slice);
    std::map<std::size_t, Ring> points;
    for (const auto& [contour, part] : parts)
      for (Point2 p : stack.slices[apart.slice + contour.first].contours[contour.second].points)
        points[part].push_back(p);
    const std::size_t a = parts.at({false, apart.lower}), b = parts.at({true, apart.upper});
    if (a == b || hulls_meet(hull_of(points[a]), hull_of(points[b]))) return true;
  }
  return false;
}

bool some_link_contradicts(const std::vector<Link>& links) {
  return std::any_of(links.begin(), links.end(), [&](const Link& apart) {
    if (apart.connect) return false;
    const Parts parts = parts_of(links, apart.structure, apart.slice);
    return parts.at({false, apart.lower}) == parts.at({true, apart.upper});
  });
}

}  // namespace

std::string what_is_false(const InputError& refusal, const ContourStack& stack, const std::vector<Link>& links) {
  if (refusal.cause() == "too-close") {
    for (std::size_t k = 0; k < stack.slices.size(); ++k)
      if (refusal.place().slice.value_or(k) == k && too_close_within(stack.slices[k])) return {};
    return "refused as too close, but doubles can part it";
  }
  if (refusal.cause() == "slices-too-close") {
    if (!refusal.place().slice) return "refused slices as too close, but names none";
    return too_close_in_height(stack, *refusal.place().slice)
               ? ""
               : "refused slices as too close, but doubles can part them";
  }
  if (refusal.cause() == "link-contradiction")
    return some_link_contradicts(links) ? "" : "refused as a contradiction of links, but there is none";
  if (refusal.cause() == "link-impossible")
    return some_parts_cross(stack, links) ? "" : "refused as an impossible link, but the parts have hulls of their own";
  return "refused though valid: " + refusal.cause();
}

}  // namespace odontoscope::test
