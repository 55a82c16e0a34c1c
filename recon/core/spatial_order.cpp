#include "recon/core/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace odontoscope {
namespace {

constexpr int bits = 21;  // of a place on the curve's grid, along each axis: those of three axes fit into one number
constexpr std::size_t least_round = 16;

/// Where along Hilbert's curve a square of the grid lies.
std::uint64_t along_curve(std::array<std::uint32_t, 2> square) {
  auto [x, y] = square;
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

/// And a cube along Morton's: the bits of its three places in turn.
std::uint64_t along_curve(const std::array<std::uint32_t, 3>& cube) {
  std::uint64_t place = 0;
  for (int bit = bits - 1; bit >= 0; --bit)
    for (const std::uint32_t axis : cube) place = 2 * place + ((axis >> bit) & 1);
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
  int rounds_left;  // after the one that it is inserted in
  std::uint64_t along;
  std::uint32_t rank;  // by coordinates
};

std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Point>
std::vector<std::uint32_t> ordered(const std::vector<Point>& points) {
  constexpr std::size_t axes = std::tuple_size_v<decltype(coordinates(Point{}))>;
  std::vector<std::uint32_t> by_place(points.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  std::sort(by_place.begin(), by_place.end(), [&points](std::uint32_t a, std::uint32_t b) {
    return std::pair(coordinates(points[a]), a) < std::pair(coordinates(points[b]), b);
  });

  std::array<double, axes> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const Point& p : points) {
    for (std::size_t k = 0; k < axes; ++k) {
      low[k] = std::min(low[k], coordinates(p)[k]);
      high[k] = std::max(high[k], coordinates(p)[k]);
    }
  }
  double half_extent = 0;  // halves, since the whole may be larger than any double
  for (std::size_t k = 0; k < axes; ++k) half_extent = std::max(half_extent, high[k] / 2 - low[k] / 2);
  const auto on_grid = [&](const Point& p) {
    constexpr double last = (1U << bits) - 1;
    std::array<std::uint32_t, axes> place{};
    for (std::size_t k = 0; k < axes; ++k)
      if (half_extent > 0)
        place[k] = static_cast<std::uint32_t>(std::min((coordinates(p)[k] / 2 - low[k] / 2) / half_extent, 1.0) * last);
    return place;
  };

  const int most_rounds = static_cast<int>(std::bit_width(points.size() / least_round)) / 2;
  std::vector<Turn> turns;
  turns.reserve(points.size());
  for (std::uint32_t rank = 0; rank < by_place.size(); ++rank)
    turns.push_back(
        {std::min(std::countr_zero(mixed(rank)) / 2, most_rounds), along_curve(on_grid(points[by_place[rank]])), rank});
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(b.rounds_left, a.along, a.rank) < std::tie(a.rounds_left, b.along, b.rank);
  });
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const Turn& turn : turns) order.push_back(by_place[turn.rank]);
  return order;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const std::vector<Point2>& points) { return ordered(points); }
std::vector<std::uint32_t> spatial_order(const std::vector<Point3>& points) { return ordered(points); }

}  // namespace odontoscope
