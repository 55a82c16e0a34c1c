#include "recon/between/plane_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odontoscope::between {
namespace {

using EdgeId = std::uint32_t;
constexpr EdgeId none = std::numeric_limits<EdgeId>::max();

struct Edge {
  Point2 from, along;
  double per_squared_length = 0;

  Edge(Point2 a, Point2 b) : from(a), along{b.x - a.x, b.y - a.y} {
    const double squared = along.x * along.x + along.y * along.y;
    per_squared_length = squared > 0 ? 1 / squared : 0;
  }

  double squared_distance(double x, double y) const {
    const double dx = x - from.x, dy = y - from.y;
    const double share = std::clamp((dx * along.x + dy * along.y) * per_squared_length, 0.0, 1.0);
    const double ex = dx - share * along.x, ey = dy - share * along.y;
    return ex * ex + ey * ey;
  }
};

class NearestEdges {
 public:
  NearestEdges(const Lattice& lattice, const Outline& contours)
      : lattice_(lattice),
        nearest_(lattice.size(), none),
        squared_(lattice.size(), std::numeric_limits<double>::infinity()) {
    for (const std::vector<Point2>& ring : contours) {
      for (std::size_t n = 0; n < ring.size(); ++n) edges_.emplace_back(ring[n], ring[(n + 1) % ring.size()]);
    }
    for (EdgeId e = 0; e < edges_.size(); ++e) seed(e);
    sweep();
  }

  std::vector<double> distances() && {
    for (double& value : squared_) value = std::sqrt(value);
    return std::move(squared_);
  }

 private:
  std::ptrdiff_t column(double x, double margin) const {
    return bounded((x - lattice_.origin.x) / lattice_.step + margin, lattice_.columns);
  }
  std::ptrdiff_t row(double y, double margin) const {
    return bounded((y - lattice_.origin.y) / lattice_.step + margin, lattice_.rows);
  }
  static std::ptrdiff_t bounded(double place, std::ptrdiff_t count) {
    return static_cast<std::ptrdiff_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(count - 1)));
  }

  /// Offers the edge to all grid points within a step of it, row by row; at least to the nearest border of the lattice.
  void seed(EdgeId id) {
    const Edge& edge = edges_[id];
    const Point2 to{edge.from.x + edge.along.x, edge.from.y + edge.along.y};
    const double low = std::min(edge.from.y, to.y), high = std::max(edge.from.y, to.y);
    for (std::ptrdiff_t j = row(low, -1); j <= row(high, 2); ++j) {
      const double y = lattice_.y(j);
      double left = std::min(edge.from.x, to.x), right = std::max(edge.from.x, to.x);
      if (high > low && y + lattice_.step >= low && y - lattice_.step <= high) {
        const double share_a = std::clamp((y - lattice_.step - edge.from.y) / edge.along.y, 0.0, 1.0);
        const double share_b = std::clamp((y + lattice_.step - edge.from.y) / edge.along.y, 0.0, 1.0);
        const double xa = edge.from.x + share_a * edge.along.x, xb = edge.from.x + share_b * edge.along.x;
        left = std::min(xa, xb);
        right = std::max(xa, xb);
      }
      for (std::ptrdiff_t i = column(left, -1); i <= column(right, 2); ++i) offer(i, j, id);
    }
  }

  void offer(std::ptrdiff_t i, std::ptrdiff_t j, EdgeId id) {
    const auto at = static_cast<std::size_t>(j * lattice_.columns + i);
    const double squared = edges_[id].squared_distance(lattice_.x(i), lattice_.y(j));
    if (squared >= squared_[at]) return;
    squared_[at] = squared;
    nearest_[at] = id;
  }

  void take_from(std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t di, std::ptrdiff_t dj) {
    const std::ptrdiff_t ni = i + di, nj = j + dj;
    if (ni < 0 || nj < 0 || ni >= lattice_.columns || nj >= lattice_.rows) return;
    const EdgeId id = nearest_[static_cast<std::size_t>(nj * lattice_.columns + ni)];
    if (id != none && id != nearest_[static_cast<std::size_t>(j * lattice_.columns + i)]) offer(i, j, id);
  }

  void sweep_row(std::ptrdiff_t j, std::ptrdiff_t from_row) {
    for (std::ptrdiff_t i = 0; i < lattice_.columns; ++i) {
      for (std::ptrdiff_t di = -1; di <= 1; ++di) take_from(i, j, di, from_row);
      take_from(i, j, -1, 0);
    }
    for (std::ptrdiff_t i = lattice_.columns - 1; i >= 0; --i) take_from(i, j, 1, 0);
  }

  void sweep() {
    for (std::ptrdiff_t j = 0; j < lattice_.rows; ++j) sweep_row(j, -1);
    for (std::ptrdiff_t j = lattice_.rows - 1; j >= 0; --j) sweep_row(j, 1);
  }

  const Lattice& lattice_;
  std::vector<Edge> edges_;
  std::vector<EdgeId> nearest_;
  std::vector<double> squared_;
};

}  // namespace

std::vector<double> distances(const Lattice& lattice, const Outline& contours) {
  return NearestEdges(lattice, contours).distances();
}

std::vector<std::uint8_t> inside_mask(const Lattice& lattice, const Outline& contours) {
  std::vector<std::uint8_t> mask(lattice.size(), 0);
  // Each edge flips, in the rows that it crosses, all points to the right of it: marked first, summed up afterwards.
  for (const std::vector<Point2>& ring : contours) {
    for (std::size_t n = 0; n < ring.size(); ++n) {
      Point2 a = ring[n], b = ring[(n + 1) % ring.size()];
      if (a.y > b.y) std::swap(a, b);
      const double first = std::ceil((a.y - lattice.origin.y) / lattice.step) - 1;
      for (auto j = static_cast<std::ptrdiff_t>(std::max(first, 0.0)); j < lattice.rows; ++j) {
        const double y = lattice.y(j);
        if (y < a.y) continue;
        if (y >= b.y) break;
        const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        const double place = std::ceil((x - lattice.origin.x) / lattice.step);
        if (place >= static_cast<double>(lattice.columns)) continue;
        const auto i = static_cast<std::ptrdiff_t>(std::max(place, 0.0));
        mask[static_cast<std::size_t>(j * lattice.columns + i)] ^= 1;
      }
    }
  }
  for (std::ptrdiff_t j = 0; j < lattice.rows; ++j) {
    std::uint8_t parity = 0;
    for (std::ptrdiff_t i = 0; i < lattice.columns; ++i) {
      std::uint8_t& at = mask[static_cast<std::size_t>(j * lattice.columns + i)];
      at = parity = static_cast<std::uint8_t>(parity ^ at);
    }
  }
  return mask;
}

std::vector<double> signed_distances(const Lattice& lattice, const Outline& contours) {
  std::vector<double> result = distances(lattice, contours);
  const std::vector<std::uint8_t> mask = inside_mask(lattice, contours);
  for (std::size_t n = 0; n < result.size(); ++n) {
    if (mask[n]) result[n] = -result[n];
  }
  return result;
}

}  // namespace odontoscope::between
