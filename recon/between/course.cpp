#include "recon/between/course.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

#include "recon/between/limits.h"

namespace odontoscope::between {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// What both slices agree on, or which of them has material.
enum class Place : std::uint8_t { void_in_both, only_lower, only_upper, material_in_both };

struct Neighbour {
  std::size_t at;
  double length;  // in steps
};

/// Ways through the places where the slices differ, from what stays.
class Ways {
 public:
  Ways(const Lattice& lattice, const std::vector<double>& lower, const std::vector<double>& upper,
       const std::vector<Place>& places, Place stays)
      : lattice_(lattice),
        lower_(lower),
        upper_(upper),
        places_(places),
        stays_(stays),
        way_(lattice.size(), unreached) {
    march();
    measure_ends();
  }

  double way(std::size_t p) const { return way_[p]; }
  /// How far the way through the point goes on to its end.
  double length(std::size_t p) const { return length_[p]; }
  /// Of the widest place along it.
  double width(std::size_t p) const { return 2 * widest_[p]; }

 private:
  bool differs(std::size_t p) const { return places_[p] == Place::only_lower || places_[p] == Place::only_upper; }

  template <class Visit>
  void for_neighbours(std::size_t p, bool diagonal, const Visit& visit) const {
    const auto at = static_cast<std::ptrdiff_t>(p), i = at % lattice_.columns, j = at / lattice_.columns;
    for (std::ptrdiff_t dj = -1; dj <= 1; ++dj) {
      for (std::ptrdiff_t di = -1; di <= 1; ++di) {
        const std::ptrdiff_t steps = std::abs(di) + std::abs(dj);
        if (steps == 0 || (steps == 2 && !diagonal)) continue;
        if (i + di < 0 || j + dj < 0 || i + di >= lattice_.columns || j + dj >= lattice_.rows) continue;
        visit(Neighbour{static_cast<std::size_t>(at + dj * lattice_.columns + di), steps == 2 ? std::sqrt(2.0) : 1.0});
      }
    }
  }

  /// The slice whose contour is where the way begins.
  double from_border(std::size_t p) const {
    const bool of_lower = (places_[p] == Place::only_upper) == (stays_ == Place::material_in_both);
    return std::abs(of_lower ? lower_[p] : upper_[p]);
  }

  void march() {
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    std::vector<bool> done(lattice_.size(), false);
    for (std::size_t p = 0; p < lattice_.size(); ++p) {
      if (!differs(p)) continue;
      for_neighbours(p, true, [&](Neighbour q) {
        if (places_[q.at] == stays_) way_[p] = std::min(from_border(p), q.length * lattice_.step);
      });
      if (way_[p] < unreached) front.push({way_[p], p});
    }
    while (!front.empty()) {
      const std::size_t p = front.top().second;
      front.pop();
      if (done[p]) continue;
      done[p] = true;
      order_.push_back(p);
      for_neighbours(p, false, [&](Neighbour q) {
        if (done[q.at] || places_[q.at] != places_[p]) return;
        const double reached = eikonal(q.at);
        if (reached >= way_[q.at]) return;
        way_[q.at] = reached;
        front.push({reached, q.at});
      });
    }
  }

  double eikonal(std::size_t p) const {
    const auto at = static_cast<std::ptrdiff_t>(p), i = at % lattice_.columns, j = at / lattice_.columns;
    const auto least = [&](bool low, std::ptrdiff_t below, bool high, std::ptrdiff_t above) {
      double value = unreached;
      const auto take = [&](std::ptrdiff_t q) {
        const auto n = static_cast<std::size_t>(q);
        if (places_[n] == places_[p]) value = std::min(value, way_[n]);
      };
      if (low) take(below);
      if (high) take(above);
      return value;
    };
    const double x = least(i > 0, at - 1, i + 1 < lattice_.columns, at + 1);
    const double y = least(j > 0, at - lattice_.columns, j + 1 < lattice_.rows, at + lattice_.columns);
    const double step = lattice_.step;
    if (!(std::abs(x - y) < step)) return std::min(x, y) + step;
    return (x + y + std::sqrt(2 * step * step - (x - y) * (x - y))) / 2;
  }

  /// The mean of what lies straight ahead (or, with -1, straight behind), or nothing.
  double ahead(std::size_t p, double direction, const std::vector<double>& values) const {
    double sum = 0, weights = 0;
    for_neighbours(p, true, [&](Neighbour q) {
      if (places_[q.at] != places_[p] || way_[q.at] == unreached) return;
      const double slope = direction * (way_[q.at] - way_[p]) / (q.length * lattice_.step);
      const double weight = slope - limits::strip_ahead;
      if (weight <= 0) return;
      sum += weight * values[q.at];
      weights += weight;
    });
    return weights > 0 ? sum / weights : -1;
  }

  /// Ends are carried back along the ways, the farthest point first; widths forth and back.
  void measure_ends() {
    end_.assign(lattice_.size(), 0);
    std::vector<double> before(lattice_.size(), 0), after(lattice_.size(), 0);
    widest_.assign(lattice_.size(), 0);
    for (const std::size_t p : order_) before[p] = std::max(depth(p), ahead(p, -1, before));
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
      const std::size_t p = *it;
      end_[p] = std::max(way_[p] + lattice_.step / 2, ahead(p, 1, end_));
      after[p] = std::max(depth(p), ahead(p, 1, after));
      widest_[p] = std::max(before[p], after[p]);
    }
    length_.resize(lattice_.size());
    for (const std::size_t p : order_) {
      const double across = half_width(p);
      length_[p] = std::max(end_[p], followed(p, across - depth(p)));
      widest_[p] = std::max(widest_[p], across);
    }
  }

  double depth(std::size_t p) const { return std::min(std::abs(lower_[p]), std::abs(upper_[p])); }

  /// Half the width of the strip across the point: the deepest place at about the same way.
  double half_width(std::size_t p) const {
    std::size_t at = p;
    for (bool climbs = true; climbs;) {
      std::size_t next = at;
      for_neighbours(at, true, [&](Neighbour q) {
        const bool level =
            places_[q.at] == places_[p] && std::abs(way_[q.at] - way_[p]) < limits::strip_level * lattice_.step;
        if (level && depth(q.at) > depth(next)) next = q.at;
      });
      climbs = next != at;
      at = next;
    }
    return depth(at);
  }

  /// Along the middle of the strip as far as it is wide enough for the point: ways that run along the inside of a bend
  /// would end at the outside of it.
  double followed(std::size_t p, double aside) const {
    double reached = way_[p];
    std::size_t at = p;
    for (bool goes_on = true; goes_on;) {
      std::size_t next = at;
      for_neighbours(at, true, [&](Neighbour q) {
        if (places_[q.at] != places_[p] || way_[q.at] == unreached) return;
        if (way_[q.at] - way_[at] < limits::strip_onwards * q.length * lattice_.step) return;
        if (next == at || depth(q.at) > depth(next)) next = q.at;
      });
      goes_on = next != at;
      at = next;
      if (depth(at) >= aside) reached = way_[at] + lattice_.step / 2;
    }
    return reached;
  }

  const Lattice& lattice_;
  const std::vector<double>&lower_, &upper_;
  const std::vector<Place>& places_;
  Place stays_;
  std::vector<double> way_, end_, length_, widest_;
  std::vector<std::size_t> order_;  // by way
};

std::vector<Place> places_of(const std::vector<double>& lower, const std::vector<double>& upper) {
  std::vector<Place> places(lower.size());
  for (std::size_t p = 0; p < places.size(); ++p)
    places[p] = static_cast<Place>((lower[p] < 0 ? 1 : 0) + (upper[p] < 0 ? 2 : 0));
  return places;
}

/// Points of one place that hang together.
std::vector<std::size_t> component_at(const Lattice& lattice, const std::vector<Place>& places, std::size_t seed,
                                      std::vector<bool>& seen) {
  std::vector<std::size_t> found{seed};
  seen[seed] = true;
  for (std::size_t n = 0; n < found.size(); ++n) {
    const auto at = static_cast<std::ptrdiff_t>(found[n]), i = at % lattice.columns, j = at / lattice.columns;
    const auto take = [&](bool there, std::ptrdiff_t q) {
      if (!there) return;
      const auto next = static_cast<std::size_t>(q);
      if (seen[next] || places[next] != places[seed]) return;
      seen[next] = true;
      found.push_back(next);
    };
    take(i > 0, at - 1);
    take(i + 1 < lattice.columns, at + 1);
    take(j > 0, at - lattice.columns);
    take(j + 1 < lattice.rows, at + lattice.columns);
  }
  return found;
}

double smooth_between(double value, double low, double high) {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

}  // namespace

std::vector<StripPoint> strip_points(const Lattice& lattice, const std::vector<double>& lower,
                                     const std::vector<double>& upper, double height) {
  const std::vector<Place> places = places_of(lower, upper);
  const Ways in_material(lattice, lower, upper, places, Place::material_in_both);
  const Ways in_void(lattice, lower, upper, places, Place::void_in_both);
  std::vector<StripPoint> result;
  std::vector<bool> seen(lattice.size(), false);
  for (std::size_t seed = 0; seed < lattice.size(); ++seed) {
    if (seen[seed] || places[seed] == Place::void_in_both || places[seed] == Place::material_in_both) continue;
    const std::vector<std::size_t> component = component_at(lattice, places, seed, seen);
    double farthest[2] = {0, 0};
    for (const std::size_t p : component) {
      if (in_material.way(p) < unreached) farthest[0] = std::max(farthest[0], in_material.way(p));
      if (in_void.way(p) < unreached) farthest[1] = std::max(farthest[1], in_void.way(p));
    }
    const bool of_material = farthest[0] >= farthest[1];
    const Ways& ways = of_material ? in_material : in_void;
    const bool onwards = of_material == (places[seed] == Place::only_upper);
    for (const std::size_t p : component) {
      if (ways.way(p) == unreached) continue;
      const double length = ways.length(p), share = std::min(ways.way(p) / length, 1.0);
      const double slender = length / std::max(ways.width(p), lattice.step);
      const double certainty = smooth_between(slender, limits::strip_least, limits::strip_certain) *
                               smooth_between(length / lattice.step, limits::strip_steps, 2 * limits::strip_steps) *
                               (1 - smooth_between(ways.width(p) / height, limits::strip_thin, limits::strip_wide));
      if (certainty > 0) result.push_back({p, onwards ? share : 1 - share, length, certainty});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const StripPoint& a, const StripPoint& b) { return a.at < b.at; });
  return result;
}

}  // namespace odontoscope::between
