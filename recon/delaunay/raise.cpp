#include "recon/delaunay/raise.h"

#include <algorithm>

#include "recon/core/limits.h"
#include "recon/delaunay/prism.h"

namespace odontoscope::delaunay {
namespace {

void add_copies(const Planar& slice, double z, SlabSolid& solid) {
  for (const Point2 p : slice.points) solid.added.push_back({p.x, p.y, z});
}

}  // namespace

bool raise(const SlabTetrahedra& tetrahedra, const Fates& fate, const Planar& lower, const Planar& upper,
           SlabHeights heights, std::uint32_t whole_lower, std::uint32_t whole_upper, SlabSolid& solid) {
  const double step = (heights.upper - heights.lower) * limits::raise_height;
  const double low = heights.lower + step, high = heights.upper - step;
  if (!(heights.lower < low && low < high && high < heights.upper)) return false;

  const auto in_lower = static_cast<std::uint32_t>(lower.points.size());
  const auto first_added = static_cast<std::uint32_t>(whole_lower + whole_upper + solid.added.size());
  add_copies(lower, low, solid);
  add_copies(upper, high, solid);
  for (const TetIndex t : tetrahedra.indices()) {
    if (fate[t] == Fate::removed) continue;
    const auto& v = tetrahedra[t].v;
    solid.tetrahedra.push_back({first_added + v[0], first_added + v[1], first_added + v[2], first_added + v[3]});
  }
  for (const PlanarTriangle& triangle : lower.triangles)
    if (triangle.region != none)
      add_prism(
          triangle, [&](SlicePoint p) { return lower.slice_point[p]; }, [&](SlicePoint p) { return first_added + p; },
          Thickened::upwards, solid.tetrahedra);
  for (const PlanarTriangle& triangle : upper.triangles)
    if (triangle.region != none)
      add_prism(
          triangle, [&](SlicePoint p) { return whole_lower + upper.slice_point[p]; },
          [&](SlicePoint p) { return first_added + in_lower + p; }, Thickened::downwards, solid.tetrahedra);
  solid.restored += static_cast<std::size_t>(std::count(fate.begin(), fate.end(), Fate::restored));
  solid.raised = true;
  return true;
}

}  // namespace odontoscope::delaunay
