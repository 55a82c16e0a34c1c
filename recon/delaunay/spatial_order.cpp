#include "recon/delaunay/spatial_order.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <tuple>

namespace odontoscope::delaunay {
namespace {

constexpr int bits = 24;   // of a place on the curve's grid, along either axis
constexpr std::size_t least_round = 16;

/// Where along Hilbert's curve a square of the grid lies.
std::uint64_t along_curve(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t half = 1U << (bits - 1); half > 0; half /= 2) {
    const bool right = (x & half) != 0, upper = (y & half) != 0;
    place = 4 * place + (right ? (upper ? 2 : 3) : (upper ? 1 : 0));
    if (upper) continue;
    // The curve through a lower quarter is that through the whole, mirrored: on the right in the other diagonal.
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return place;
}

/// Bits that look as if drawn by lot (S. Vigna's splitmix64).
std::uint64_t mixed(std::uint64_t n) {
  n += 0x9e3779b97f4a7c15;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9;
  n = (n ^ (n >> 27)) * 0x94d049bb133111eb;
  return n ^ (n >> 31);
}

struct Turn {
  int rounds_left;   // after the one that it is inserted in
  std::uint64_t along;
  std::uint32_t rank;   // by coordinates
};

}  // namespace

std::vector<std::uint32_t> spatial_order(const std::vector<Point2>& points) {
  std::vector<std::uint32_t> by_place(points.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  std::sort(by_place.begin(), by_place.end(), [&points](std::uint32_t a, std::uint32_t b) {
    return std::tie(points[a].x, points[a].y, a) < std::tie(points[b].x, points[b].y, b);
  });

  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high{-low.x, -low.y};
  for (const Point2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  // Halves, since the whole extent may be larger than any double.
  const double half_extent = std::max(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);
  const auto on_grid = [half_extent](double value, double from) {
    constexpr double last = (1U << bits) - 1;
    return half_extent > 0 ? static_cast<std::uint32_t>(std::min((value / 2 - from / 2) / half_extent, 1.0) * last) : 0U;
  };

  const int most_rounds = static_cast<int>(std::bit_width(points.size() / least_round)) / 2;
  std::vector<Turn> turns;
  turns.reserve(points.size());
  for (std::uint32_t rank = 0; rank < by_place.size(); ++rank) {
    const Point2 p = points[by_place[rank]];
    turns.push_back({std::min(std::countr_zero(mixed(rank)) / 2, most_rounds), along_curve(on_grid(p.x, low.x), on_grid(p.y, low.y)), rank});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(b.rounds_left, a.along, a.rank) < std::tie(a.rounds_left, b.along, b.rank);
  });
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const Turn& turn : turns) order.push_back(by_place[turn.rank]);
  return order;
}

}  // namespace odontoscope::delaunay
