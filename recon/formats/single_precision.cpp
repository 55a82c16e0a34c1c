#include "recon/formats/single_precision.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

FloatPoint rounded(const Point3& p, double scale) {
  // -0 + 0 is +0: readers may compare bits.
  return {static_cast<float>(p.x * scale) + 0.0f, static_cast<float>(p.y * scale) + 0.0f,
          static_cast<float>(p.z * scale) + 0.0f};
}

/// Which point took a place: open addressing, at most half full.
class Places {
 public:
  explicit Places(std::size_t points) : slots_(std::bit_ceil(2 * points + 2), free), mask_(slots_.size() - 1) {}

  /// The point at `place`, after `point` took it if nobody had.
  std::uint32_t taken_by(const FloatPoint& place, std::uint32_t point, const std::vector<FloatPoint>& places) {
    for (std::size_t slot = hash(place) & mask_;; slot = (slot + 1) & mask_) {
      if (slots_[slot] == free) return slots_[slot] = point;
      if (places[slots_[slot]] == place) return slots_[slot];
    }
  }

 private:
  static constexpr std::uint32_t free = std::numeric_limits<std::uint32_t>::max();
  static std::size_t hash(const FloatPoint& p) {
    std::uint64_t h = 0;
    for (const float coordinate : p) {
      h = (h ^ std::bit_cast<std::uint32_t>(coordinate)) * 0xff51afd7ed558ccdull;  // murmur3's finalising constant
      h ^= h >> 29;
    }
    return h;
  }
  std::vector<std::uint32_t> slots_;
  std::size_t mask_;
};

float steps_from(float value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, std::numeric_limits<float>::infinity());
  for (; steps < 0; ++steps) value = std::nextafter(value, -std::numeric_limits<float>::infinity());
  return value + 0.0f;
}

/// Lattice neighbours of `place` at exactly `ring` steps in the farthest direction, nearest to the true point first.
std::vector<FloatPoint> ring_around(const FloatPoint& place, int ring, const Point3& point, double scale) {
  std::vector<FloatPoint> neighbours;
  for (int i = -ring; i <= ring; ++i) {
    for (int j = -ring; j <= ring; ++j) {
      for (int k = -ring; k <= ring; ++k) {
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != ring) continue;
        neighbours.push_back({steps_from(place[0], i), steps_from(place[1], j), steps_from(place[2], k)});
      }
    }
  }
  const auto off = [&](const FloatPoint& p) {
    return portable::hypot(p[0] - point.x * scale, p[1] - point.y * scale, p[2] - point.z * scale);
  };
  std::stable_sort(neighbours.begin(), neighbours.end(),
                   [&](const FloatPoint& a, const FloatPoint& b) { return off(a) < off(b); });
  return neighbours;
}

}  // namespace

std::vector<FloatPoint> distinct_floats(const std::vector<Point3>& points, double scale) {
  std::vector<FloatPoint> floats(points.size());
  Places places(points.size());
  std::vector<std::uint32_t> displaced;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    floats[i] = rounded(points[i], scale);
    const std::uint32_t other = places.taken_by(floats[i], i, floats);
    if (other != i && points[other] != points[i]) displaced.push_back(i);
  }
  // Only now, so that whoever rounds to a place of its own keeps it.
  for (const std::uint32_t i : displaced) {
    const FloatPoint home = floats[i];
    bool settled = false;
    for (int ring = 1; !settled; ++ring) {
      for (const FloatPoint& place : ring_around(home, ring, points[i], scale)) {
        floats[i] = place;
        const std::uint32_t other = places.taken_by(place, i, floats);
        settled = other == i || points[other] == points[i];
        if (settled) break;
      }
    }
  }
  return floats;
}

std::vector<std::vector<FloatPoint>> distinct_floats(const WrittenModel& model, double scale) {
  std::vector<Point3> all;
  for (const WrittenSurface& solid : model.solids)
    all.insert(all.end(), solid.surface.points.begin(), solid.surface.points.end());
  const std::vector<FloatPoint> floats = distinct_floats(all, scale);
  std::vector<std::vector<FloatPoint>> parts;
  auto from = floats.begin();
  for (const WrittenSurface& solid : model.solids) {
    const auto end = from + static_cast<std::ptrdiff_t>(solid.surface.points.size());
    parts.emplace_back(from, end);
    from = end;
  }
  return parts;
}

}  // namespace odontoscope
