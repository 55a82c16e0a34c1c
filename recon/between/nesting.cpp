#include "recon/between/nesting.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/core/limits.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"

namespace odontoscope::between {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool left_of(Point2 p, Point2 a, Point2 b) {
  return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(p.x, p.y)) ==
         CGAL::LEFT_TURN;
}

/// Exact. Precondition: p is on no edge.
bool holds(const Polygon& ring, Point2 p) {
  return encloses(ring, p, [p](Point2 a, Point2 b) { return left_of(p, a, b) == (b.y > a.y); });
}

/// By its lowest point, where it cannot be dented.
bool counter_clockwise(const std::vector<Point2>& ring) {
  const auto below = [](Point2 a, Point2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  const auto lowest = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), below) - ring.begin());
  return left_of(ring[(lowest + 1) % ring.size()], ring[(lowest + ring.size() - 1) % ring.size()], ring[lowest]);
}

ContourFacts facts_of(const std::vector<Point2>& ring) {
  ContourFacts facts;
  const Point2 base = ring.front();
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const Point2 &p = ring[n], &q = ring[(n + 1) % ring.size()];
    facts.box.take(p);
    facts.perimeter += portable::hypot((q.x - base.x) - (p.x - base.x), (q.y - base.y) - (p.y - base.y));
  }
  const AreaMoments moments(ring);
  facts.area = moments.signed_area();
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (const double twice = 2 * facts.area; !(std::abs(twice) > rounding * facts.perimeter * facts.perimeter) ||
                                           !std::isnormal(twice))  // a needle's, or a minute one's, may have any sign
    facts.area = std::copysign(facts.area, counter_clockwise(ring) ? 1.0 : -1.0);
  facts.centroid = {std::midpoint(facts.box.low.x, facts.box.high.x), std::midpoint(facts.box.low.y, facts.box.high.y)};
  if (const Point2 mean = moments.centroid(); std::isfinite(mean.x) && std::isfinite(mean.y)) facts.centroid = mean;
  return facts;
}

/// The smallest of the other kind around it; candidates come by ascending area.
std::size_t parent_of(std::size_t contour, const Outline& outline, const std::vector<ContourFacts>& facts,
                      const std::vector<std::size_t>& by_area) {
  for (const std::size_t other : by_area) {
    if (facts[other].outer() == facts[contour].outer() || !facts[other].box.holds(facts[contour].box)) continue;
    if (holds(outline[other], outline[contour].front())) return other;
  }
  return ContourFacts::none;
}

/// 0 for the same place and size; infinite if they cannot be one.
double unlikeness(const ContourFacts& a, const ContourFacts& b) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double ratio = a.area / b.area;
  if (!(ratio > 1 / limits::partner_area_ratio && ratio < limits::partner_area_ratio)) return never;
  const double size = std::sqrt((std::abs(a.area) + std::abs(b.area)) / 2);
  const double apart = portable::hypot(a.centroid.x - b.centroid.x, a.centroid.y - b.centroid.y) / size;
  return apart < limits::partner_distance ? apart + std::abs(portable::log(ratio)) / 2 : never;
}

std::vector<std::size_t> best_of(const std::vector<ContourFacts>& a, const std::vector<ContourFacts>& b) {
  std::vector<std::size_t> by_x(b.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  const auto left = [&b](std::size_t m, std::size_t n) { return b[m].centroid.x < b[n].centroid.x; };
  std::stable_sort(by_x.begin(), by_x.end(), left);
  std::vector<std::size_t> best(a.size(), ContourFacts::none);
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double largest = std::sqrt(std::abs(a[n].area) * (1 + limits::partner_area_ratio) / 2);
    const double reach = limits::partner_distance * largest;
    double least = std::numeric_limits<double>::infinity();
    auto at = std::lower_bound(by_x.begin(), by_x.end(), a[n].centroid.x - reach,
                               [&b](std::size_t m, double x) { return b[m].centroid.x < x; });
    for (; at != by_x.end() && b[*at].centroid.x <= a[n].centroid.x + reach; ++at) {
      const double found = unlikeness(a[n], b[*at]);
      if (!(found < least)) continue;
      least = found;
      best[n] = *at;
    }
  }
  return best;
}

}  // namespace

bool Box::holds(const Box& other) const {
  return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x && high.y >= other.high.y;
}

void Box::take(Point2 p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

void Box::take(const Box& other) {
  take(other.low);
  take(other.high);
}

std::vector<ContourFacts> facts_of(const Outline& outline) {
  std::vector<ContourFacts> facts;
  for (const std::vector<Point2>& ring : outline) facts.push_back(facts_of(ring));
  std::vector<std::size_t> by_area(outline.size());
  std::iota(by_area.begin(), by_area.end(), std::size_t{0});
  std::stable_sort(by_area.begin(), by_area.end(), [&facts](std::size_t m, std::size_t n) {
    return std::abs(facts[m].area) < std::abs(facts[n].area);
  });
  for (std::size_t n = 0; n < outline.size(); ++n) facts[n].parent = parent_of(n, outline, facts, by_area);
  return facts;
}

std::vector<std::size_t> outside_in(const std::vector<ContourFacts>& facts) {
  std::vector<std::size_t> order(facts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&facts](std::size_t a, std::size_t b) {
    return std::abs(facts[a].area) > std::abs(facts[b].area);
  });
  return order;
}

std::vector<std::size_t> partners(const std::vector<ContourFacts>& a, const std::vector<ContourFacts>& b) {
  std::vector<std::size_t> forth = best_of(a, b);
  const std::vector<std::size_t> back = best_of(b, a);
  for (std::size_t n = 0; n < a.size(); ++n) {
    if (forth[n] != ContourFacts::none && back[forth[n]] != n) forth[n] = ContourFacts::none;
  }
  return forth;
}

}  // namespace odontoscope::between
