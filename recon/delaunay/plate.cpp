#include "recon/delaunay/plate.h"

#include <algorithm>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/delaunay/predicates.h"
#include "recon/delaunay/solve_slab.h"

namespace odontoscope::delaunay {

SlabSolid plate(const ConformedSlice& lower, const ConformedSlice& upper, bool home_is_lower, std::uint32_t region,
                double height) {
  const Planar& home = home_is_lower ? lower.planar : upper.planar;
  const double z = home_is_lower ? lower.z : upper.z;
  const auto first_home = static_cast<std::uint32_t>(home_is_lower ? 0 : lower.planar.points.size());
  const auto first_added = static_cast<std::uint32_t>(lower.planar.points.size() + upper.planar.points.size());
  SlabSolid solid;
  std::vector<std::uint32_t> copy(home.points.size(), none);
  for (std::uint32_t p = 0; p < home.points.size(); ++p)
    if (home.region_of[p] == region) {
      copy[p] = first_added + static_cast<std::uint32_t>(solid.added.size());
      solid.added.push_back({home.points[p].x, home.points[p].y, z + height});
    }
  for (const PlanarTriangle& triangle : home.triangles) {
    if (triangle.region != region) continue;
    // Sorted corners cut the sides that two prisms share along the same diagonal.
    std::array<std::uint32_t, 3> v = triangle.v;
    std::sort(v.begin(), v.end());
    const int fixed = (v[0] == triangle.v[0]) + (v[1] == triangle.v[1]) + (v[2] == triangle.v[2]);
    const bool even = fixed != 1;   // one corner in place: the other two were swapped
    const std::array<std::uint32_t, 3> base{first_home + v[0], first_home + v[1], first_home + v[2]};
    const std::array<std::uint32_t, 3> top{copy[v[0]], copy[v[1]], copy[v[2]]};
    for (std::array<std::uint32_t, 4> tet : {std::array{base[0], base[1], base[2], top[2]}, std::array{base[0], base[1], top[2], top[1]},
                                             std::array{base[0], top[1], top[2], top[0]}}) {
      if (even != (height > 0)) std::swap(tet[0], tet[1]);
      solid.tetrahedra.push_back(tet);
    }
  }
  return solid;
}

void add_plates(const ConformedSlice& lower, const ConformedSlice& upper, const std::vector<bool>& lower_isolated,
                const std::vector<bool>& upper_isolated, std::vector<SlabSolid>& pieces) {
  std::vector<Boundary> others;
  for (const SlabSolid& piece : pieces) others.push_back(boundary_of(lower, upper, piece));
  const auto add = [&](bool home_is_lower, std::uint32_t region) {
    double height = (upper.z - lower.z) * limits::plate_height;
    for (int halving = 0; halving < limits::plate_halvings; ++halving, height /= 2) {
      SlabSolid solid = plate(lower, upper, home_is_lower, region, home_is_lower ? height : -height);
      Boundary boundary = boundary_of(lower, upper, solid);
      if (crosses_any(others, boundary)) continue;
      others.push_back(std::move(boundary));
      pieces.push_back(std::move(solid));
      return;
    }
    throw InternalError("an isolated region found no room for a plate");
  };
  for (std::uint32_t r = 0; r < lower_isolated.size(); ++r)
    if (lower_isolated[r]) add(true, r);
  for (std::uint32_t r = 0; r < upper_isolated.size(); ++r)
    if (upper_isolated[r]) add(false, r);
}

}  // namespace odontoscope::delaunay
