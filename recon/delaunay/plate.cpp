#include "recon/delaunay/plate.h"

#include <algorithm>

#include "recon/core/limits.h"
#include "recon/delaunay/prism.h"
#include "recon/delaunay/solve_slab.h"

namespace odontoscope::delaunay {

SlabSolid plate(const ConformedSlice& lower, const ConformedSlice& upper, Home home, std::uint32_t region,
                double height) {
  const ConformedSlice& slice = home == Home::lower ? lower : upper;
  const Planar& planar = slice.planar;
  const auto first_home = static_cast<std::uint32_t>(home == Home::lower ? 0 : lower.planar.points.size());
  const auto first_added = static_cast<std::uint32_t>(lower.planar.points.size() + upper.planar.points.size());
  SlabSolid solid;
  Table<SlicePoint, std::uint32_t> copy(planar.points.size(), none);
  for (const SlicePoint p : planar.points.indices())
    if (planar.region_of[p] == region) {
      copy[p] = first_added + static_cast<std::uint32_t>(solid.added.size());
      solid.added.push_back({planar.points[p].x, planar.points[p].y, slice.z + height});
    }
  for (const PlanarTriangle& triangle : planar.triangles) {
    if (triangle.region != region) continue;
    add_prism(
        triangle, [&](SlicePoint p) { return first_home + p; }, [&](SlicePoint p) { return copy[p]; },
        height > 0 ? Thickened::upwards : Thickened::downwards, solid.tetrahedra);
  }
  return solid;
}

std::optional<std::vector<SlabSolid>> plates(const ConformedSlice& lower, const ConformedSlice& upper,
                                             const std::vector<bool>& lower_isolated,
                                             const std::vector<bool>& upper_isolated,
                                             const std::vector<SlabSolid>& pieces) {
  std::vector<std::pair<Home, std::uint32_t>> homes;  // of each region
  for (std::uint32_t r = 0; r < lower_isolated.size(); ++r)
    if (lower_isolated[r]) homes.emplace_back(Home::lower, r);
  for (std::uint32_t r = 0; r < upper_isolated.size(); ++r)
    if (upper_isolated[r]) homes.emplace_back(Home::upper, r);
  std::vector<SlabSolid> added;
  if (homes.empty()) return added;

  std::vector<Boundary> others;
  for (const SlabSolid& piece : pieces) others.push_back(boundary_of(lower, upper, piece));
  const auto add = [&](Home home, std::uint32_t region) {
    double height = (upper.z - lower.z) * limits::plate_height;
    for (int halving = 0; halving < limits::plate_halvings; ++halving, height /= 2) {
      if (home == Home::lower ? !(lower.z + height > lower.z) : !(upper.z - height < upper.z)) return false;
      SlabSolid solid = plate(lower, upper, home, region, home == Home::lower ? height : -height);
      Boundary boundary = boundary_of(lower, upper, solid);
      if (crosses_any(others, boundary)) continue;
      others.push_back(std::move(boundary));
      added.push_back(std::move(solid));
      return true;
    }
    return false;
  };
  for (const auto& [home, region] : homes)
    if (!add(home, region)) return std::nullopt;
  return added;
}

}  // namespace odontoscope::delaunay
