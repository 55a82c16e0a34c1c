#include "recon/partition/slab_labels.h"

#include <algorithm>

namespace odontoscope::partition {

using delaunay::none;
using delaunay::SlabTetrahedron;

SlabLabels::SlabLabels(const std::vector<SlabTetrahedron>& tetrahedra, const PartitionSlice& lower, const PartitionSlice& upper,
                       const Materials& materials)
    : tets_(tetrahedra),
      lower_(lower),
      upper_(upper),
      materials_(materials),
      offset_(static_cast<std::uint32_t>(lower.planar.points.size())),
      duals_(dual_labels(tetrahedra, lower, upper)) {}

/// Has any face at the point this label? The outside of the hull is void.
bool SlabLabels::knows(const PartitionSlice& slice, std::uint32_t point, Label label) const {
  for (std::uint32_t s = slice.planar.first_spoke[point]; s < slice.planar.first_spoke[point + 1]; ++s)
    if (slice.label(slice.planar.spokes[s].triangle) == label) return true;
  return false;
}

std::vector<std::uint32_t> SlabLabels::ending() const {
  std::vector<std::uint32_t> points;
  for (std::uint32_t t = 0; t < tets_.size(); ++t) {
    const SlabTetrahedron& tet = tets_[t];
    if (tet.lower_count == 3 && !knows(upper_, tet.v[3] - offset_, duals_[t].lower)) {
      points.insert(points.end(), {tet.v[0], tet.v[1], tet.v[2]});
    } else if (tet.lower_count == 1 && !knows(lower_, tet.v[0], duals_[t].upper)) {
      points.insert(points.end(), {tet.v[1], tet.v[2], tet.v[3]});
    }
  }
  return points;
}

Label SlabLabels::label(std::uint32_t t, const std::vector<bool>& raised, std::vector<std::uint32_t>& losers) const {
  return tets_[t].lower_count == 2 ? of_edges(t, raised, losers) : of_triangle(t, raised);
}

/// Its triangle's, unless that is closed over.
Label SlabLabels::of_triangle(std::uint32_t t, const std::vector<bool>& raised) const {
  const SlabTetrahedron& tet = tets_[t];
  const bool below = tet.lower_count == 3;
  const int first = below ? 0 : 1;
  const bool closed = raised[tet.v[first]] && raised[tet.v[first + 1]] && raised[tet.v[first + 2]];
  return closed == below ? duals_[t].upper : duals_[t].lower;
}

/// What both edges admit; of two such labels the winner.
Label SlabLabels::of_edges(std::uint32_t t, const std::vector<bool>& raised, std::vector<std::uint32_t>& losers) const {
  const SlabTetrahedron& tet = tets_[t];
  const auto [low, high] = duals_[t];
  if (low == high) return low;
  const EdgeSides lower = sides_of(lower_, tet.v[0], tet.v[1]);
  const EdgeSides upper = sides_of(upper_, tet.v[2] - offset_, tet.v[3] - offset_);
  const bool lower_claims = !(raised[tet.v[0]] && raised[tet.v[1]]), upper_claims = !(raised[tet.v[2]] && raised[tet.v[3]]);
  const bool low_admitted = !upper_claims || upper.has(low), high_admitted = !lower_claims || lower.has(high);
  if (low_admitted && high_admitted) return materials_.wins(low, high) ? low : high;
  if (low_admitted) return low;
  if (high_admitted) return high;
  for (const Label common : {lower.left, lower.right})
    if (upper.has(common)) return common;
  const bool low_wins = materials_.wins(low, high);
  if (low_wins) losers.insert(losers.end(), {tet.v[2], tet.v[3]});
  else losers.insert(losers.end(), {tet.v[0], tet.v[1]});
  return low_wins ? low : high;
}

}  // namespace odontoscope::partition
