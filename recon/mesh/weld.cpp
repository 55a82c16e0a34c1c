#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

/// Open addressing: point numbers in slots, at most half of them taken.
class PointTable {
 public:
  explicit PointTable(std::size_t most_points)
      : slots_(std::bit_ceil(2 * most_points + 2), empty), mask_(slots_.size() - 1) {}

  PointIndex number_of(const Point3& point, std::vector<Point3>& points) {
    for (std::size_t slot = hash(point) & mask_;; slot = (slot + 1) & mask_) {
      if (slots_[slot] == empty) {
        slots_[slot] = static_cast<PointIndex>(points.size());
        points.push_back(point);
        return slots_[slot];
      }
      if (points[slots_[slot]] == point) return slots_[slot];
    }
  }

 private:
  static constexpr PointIndex empty = std::numeric_limits<PointIndex>::max();

  static std::uint64_t hash(const Point3& p) {
    // Multiply and fold (splitmix64's finalising constants), coordinate by coordinate.
    std::uint64_t h = 0;
    for (const double coordinate : {p.x, p.y, p.z}) {
      h ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 + 0 is +0
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
      h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
      h ^= h >> 31;
    }
    return h;
  }

  std::vector<PointIndex> slots_;
  std::size_t mask_;
};

}  // namespace

SurfaceMesh weld(const SurfaceMesh& soup) {
  SurfaceMesh welded;
  PointTable table(soup.points.size());
  std::vector<PointIndex> number(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) number[i] = table.number_of(soup.points[i], welded.points);
  welded.triangles.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles) welded.triangles.push_back({number[a], number[b], number[c]});
  return welded;
}

}  // namespace odontoscope
