#include "recon/between/bridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"

namespace odontoscope::between {
namespace {

/// How deep a carried shape comes to lie in the other, over the radius of the circle of its area: all of it, or as much
/// as there is room for.
constexpr std::array depths{1.0, 0.5, 0.25};

Point2 nearest_on(const std::vector<Point2>& ring, Point2 p) {
  Point2 best = ring.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double t = nearest_share(p, a, b);
    const Point2 at{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const double distance = portable::hypot(at.x - p.x, at.y - p.y);
    if (distance < least) {
      least = distance;
      best = at;
    }
  }
  return best;
}

class Carrier {
 public:
  Carrier(const SliceSet& slices, const Surroundings& surroundings) : slices_(slices), given_(surroundings) {}

  std::vector<Bridge> run() {
    add(given_.material, false);
    add(given_.voids, true);
    return std::move(made_);
  }

 private:
  void add(const std::vector<ContourLink>& links, bool hollow) {
    for (const ContourLink& link : links) {
      if ((link.lower == outside && link.upper == outside) || by_themselves(links, link)) continue;
      const bool carry_lower =
          link.upper == outside || (link.lower != outside && area(at_lower, link.lower) <= area(at_upper, link.upper));
      if (carry_lower)
        carry(at_lower, link.lower, at_upper, link.upper, hollow);
      else
        carry(at_upper, link.upper, at_lower, link.lower, hollow);
    }
  }

  static bool by_themselves(const std::vector<ContourLink>& links, const ContourLink& link) {
    return link.lower != outside && link.upper != outside &&
           std::count_if(links.begin(), links.end(), [&](const ContourLink& other) {
             return other.lower == link.lower || other.upper == link.upper;
           }) == 1;
  }

  const std::vector<Point2>& ring(std::size_t slice, std::size_t contour) const {
    return (*slices_.outlines[slice])[contour];
  }
  double area(std::size_t slice, std::size_t contour) const { return std::abs(slices_.facts[slice][contour].area); }

  bool has_contours_in(std::size_t slice, std::size_t contour) const {
    return std::any_of(slices_.facts[slice].begin(), slices_.facts[slice].end(),
                       [&](const ContourFacts& f) { return f.parent == contour; });
  }

  /// Is the point in what the contour bounds, of material or void? `outside` is whatever lies in no outer contour.
  bool holds(std::size_t slice, std::size_t contour, Point2 p) const {
    for (std::size_t c = 0; c < slices_.facts[slice].size(); ++c) {
      const ContourFacts& facts = slices_.facts[slice][c];
      const bool bounds = contour == outside ? facts.parent == ContourFacts::none : facts.parent == contour;
      if (bounds && encloses(ring(slice, c), p)) return false;
    }
    return contour == outside || encloses(ring(slice, contour), p);
  }

  bool overlaps(std::size_t slice, std::size_t contour, std::size_t other_slice, std::size_t other) const {
    const auto& points = ring(slice, contour);
    const auto in_other = [&](Point2 p) { return holds(other_slice, other, p); };
    if (in_other(slices_.facts[slice][contour].centroid) || std::any_of(points.begin(), points.end(), in_other))
      return true;
    if (other == outside) return false;
    const auto& others = ring(other_slice, other);
    return std::any_of(others.begin(), others.end(), [&](Point2 p) { return encloses(points, p); });
  }

  /// The point of the other shape's border that is nearest.
  Point2 nearest(std::size_t slice, std::size_t contour, Point2 p) const {
    if (contour != outside) return nearest_on(ring(slice, contour), p);
    Point2 best = p;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < slices_.facts[slice].size(); ++c) {
      if (slices_.facts[slice][c].parent != ContourFacts::none) continue;
      const Point2 at = nearest_on(ring(slice, c), p);
      const double distance = portable::hypot(at.x - p.x, at.y - p.y);
      if (distance >= least) continue;
      least = distance;
      best = at;
    }
    return best;
  }

  void carry(std::size_t slice, std::size_t contour, std::size_t other_slice, std::size_t other, bool hollow) {
    if (has_contours_in(slice, contour) || overlaps(slice, contour, other_slice, other)) return;
    const std::optional<Point2> by = way(slice, contour, other_slice, other);
    if (!by) return;
    Bridge bridge{{}, hollow, slice, contour};
    std::vector<Point2> moved = ring(slice, contour);
    for (Point2& p : moved) p = {p.x + by->x, p.y + by->y};
    bridge.unit.shapes[slice] = {ring(slice, contour)};
    bridge.unit.shapes[other_slice] = {std::move(moved)};
    bridge.unit.presence.fill(Presence::unused);
    bridge.unit.presence[at_lower] = bridge.unit.presence[at_upper] = Presence::shape;
    made_.push_back(std::move(bridge));
  }

  std::optional<Point2> way(std::size_t slice, std::size_t contour, std::size_t other_slice, std::size_t other) const {
    const Point2 from = slices_.facts[slice][contour].centroid, border = nearest(other_slice, other, from);
    const double dx = border.x - from.x, dy = border.y - from.y, distance = portable::hypot(dx, dy);
    const double radius = std::sqrt(area(slice, contour) / std::numbers::pi);
    if (!(distance > 0)) return std::nullopt;
    for (const double depth : depths) {
      const double share = 1 + depth * radius / distance;
      if (holds(other_slice, other, {from.x + share * dx, from.y + share * dy})) return Point2{share * dx, share * dy};
    }
    return std::nullopt;
  }

  const SliceSet& slices_;
  const Surroundings& given_;
  std::vector<Bridge> made_;
};

}  // namespace

std::vector<Bridge> bridges(const SliceSet& slices, const Surroundings& surroundings) {
  return Carrier(slices, surroundings).run();
}

}  // namespace odontoscope::between
