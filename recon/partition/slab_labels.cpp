#include "recon/partition/slab_labels.h"

#include <algorithm>

namespace odontoscope::partition {
namespace {

using delaunay::none;
using delaunay::Side;
using delaunay::SlabPoint;
using delaunay::SlabTetrahedra;
using delaunay::SlabTetrahedron;
using delaunay::SlicePoint;
using delaunay::TetIndex;
using delaunay::TriangleIndex;

/// Numbers of the faces that the triangles make up; void that reaches the hull is face 0, with what lies beyond.
Table<TriangleIndex, std::uint32_t> faces_of(const PartitionSlice& slice) {
  const auto& triangles = slice.planar.triangles;
  Table<TriangleIndex, std::uint32_t> face(triangles.size(), none);
  std::vector<TriangleIndex> stack;
  std::uint32_t count = 0;
  const auto spread = [&] {
    while (!stack.empty()) {
      const TriangleIndex t = stack.back();
      stack.pop_back();
      for (const TriangleIndex other : triangles[t].nb) {
        if (other == none || face[other] != none || slice.label(other) != slice.label(t)) continue;
        face[other] = count;
        stack.push_back(other);
      }
    }
    ++count;
  };
  for (const TriangleIndex t : triangles.indices()) {
    if (slice.label(t) != void_label || face[t] != none) continue;
    if (std::find(triangles[t].nb.begin(), triangles[t].nb.end(), none) == triangles[t].nb.end()) continue;
    face[t] = 0;
    stack.push_back(t);
  }
  spread();
  for (const TriangleIndex t : triangles.indices()) {
    if (face[t] != none) continue;
    face[t] = count;
    stack.push_back(t);
    spread();
  }
  return face;
}

/// Is there such a triangle (none: beyond the hull) among those at the point?
template <class Condition>
bool any_beside(const PartitionSlice& slice, SlicePoint p, Condition condition) {
  for (const delaunay::SpokeIndex s : slice.planar.spokes_of(p))
    if (condition(slice.planar.spokes[s].triangle)) return true;
  return false;
}

}  // namespace

SlabLabels::SlabLabels(const SlabTetrahedra& tetrahedra, const PartitionSlice& lower, const PartitionSlice& upper,
                       const Materials& materials)
    : tets_(tetrahedra),
      lower_(lower),
      upper_(upper),
      materials_(materials),
      numbers_(lower.planar),
      duals_(dual_triangles(tetrahedra, lower, upper)),
      lower_faces_(faces_of(lower)),
      upper_faces_(faces_of(upper)) {
  for (const TetIndex t : tets_.indices()) {
    if (tets_[t].lower_count == 2) continue;
    const auto [low, high] = duals_[t];
    if (lower_.label(low) == upper_.label(high))
      links_.emplace_back(low == none ? 0 : lower_faces_[low], high == none ? 0 : upper_faces_[high]);
  }
  std::sort(links_.begin(), links_.end());
  links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
  beside_.assign(lower.planar.points.size() + upper.planar.points.size(), void_label);
  ending_ = ending_triangles();
  ramp_ = margin_ramp(lower, upper, materials, ending_);
  if (ramp_.empty()) return;
  for (const RaisedShare& one : ramp_) beside_[one.point] = one.beside;
  ending_ = ending_triangles();
}

bool SlabLabels::linked(TriangleIndex lower_triangle, TriangleIndex upper_triangle) const {
  const std::pair faces{lower_triangle == none ? 0 : lower_faces_[lower_triangle],
                        upper_triangle == none ? 0 : upper_faces_[upper_triangle]};
  return faces == std::pair<std::uint32_t, std::uint32_t>{0, 0} ||
         std::binary_search(links_.begin(), links_.end(), faces);
}

/// Does a face at the point continue that of the triangle?
bool SlabLabels::knows_above(SlabPoint v, TriangleIndex lower_triangle) const {
  return any_beside(upper_, numbers_.own(v), [&](TriangleIndex t) {
    return upper_.label(t) == lower_.label(lower_triangle) && linked(lower_triangle, t);
  });
}

bool SlabLabels::knows_below(SlabPoint v, TriangleIndex upper_triangle) const {
  return any_beside(lower_, numbers_.own(v), [&](TriangleIndex t) {
    return lower_.label(t) == upper_.label(upper_triangle) && linked(t, upper_triangle);
  });
}

/// A face need not end at a point of a margin that runs out beside it: that rises away from its slice.
bool SlabLabels::gives_way(SlabPoint margin, Label label) const {
  return label != void_label && beside_[margin] == label;
}

std::vector<EndingTriangle> SlabLabels::ending_triangles() const {
  std::vector<EndingTriangle> triangles;
  for (const SlabTetrahedron& tet : tets_) {
    if (tet.lower_count == 3 && !gives_way(tet.v[3], lower_.label(tet.triangle)) &&
        !knows_above(tet.v[3], tet.triangle))
      triangles.push_back({Side::lower, tet.triangle});
    else if (tet.lower_count == 1 && !gives_way(tet.v[0], upper_.label(tet.triangle)) &&
             !knows_below(tet.v[0], tet.triangle))
      triangles.push_back({Side::upper, tet.triangle});
  }
  return triangles;
}

bool SlabLabels::knows(SlabPoint v, Label label) const {
  const PartitionSlice& slice = numbers_.is_lower(v) ? lower_ : upper_;
  return any_beside(slice, numbers_.own(v), [&](TriangleIndex t) { return slice.label(t) == label; });
}

/// Where all corners in one slice are of a margin, what lies beside it if all in the other slice know that; else void.
Label SlabLabels::beside_margin(TetIndex t) const {
  const SlabTetrahedron& tet = tets_[t];
  for (const bool lower : {true, false}) {
    const int first = lower ? 0 : tet.lower_count, end = lower ? tet.lower_count : 4;
    if (end - first < 2) continue;
    const Label label = beside_[tet.v[first]];
    bool all = label != void_label;
    for (int k = 0; k < 4; ++k)
      all = all && (first <= k && k < end ? beside_[tet.v[k]] == label : knows(tet.v[k], label));
    if (all) return label;
  }
  return void_label;
}

/// Beside a margin lies what the margin runs out beside, and no void between the two: its triangles are so narrow that
/// their dual points often lie beyond the border.
Label SlabLabels::label(TetIndex t, const Raised& raised, std::vector<SlabPoint>& losers) const {
  const Label label = by_rule(t, raised, losers);
  return label == void_label && !ramp_.empty() ? beside_margin(t) : label;
}

Label SlabLabels::by_rule(TetIndex t, const Raised& raised, std::vector<SlabPoint>& losers) const {
  return tets_[t].lower_count == 2 ? of_edges(t, raised, losers) : of_triangle(t, raised);
}

/// Its triangle's, unless that is closed over.
Label SlabLabels::of_triangle(TetIndex t, const Raised& raised) const {
  const SlabTetrahedron& tet = tets_[t];
  const bool below = tet.lower_count == 3;
  const int first = below ? 0 : 1;
  const bool closed = raised[tet.v[first]] && raised[tet.v[first + 1]] && raised[tet.v[first + 2]];
  return closed == below ? upper_.label(duals_[t].upper) : lower_.label(duals_[t].lower);
}

/// What both edges admit; of two such labels the winner, unless that would join faces that do not continue each other.
Label SlabLabels::of_edges(TetIndex t, const Raised& raised, std::vector<SlabPoint>& losers) const {
  const SlabTetrahedron& tet = tets_[t];
  const Label low = lower_.label(duals_[t].lower), high = upper_.label(duals_[t].upper);
  if (low == high) return low;
  const EdgeSides lower = sides_of(lower_, numbers_.own(tet.v[0]), numbers_.own(tet.v[1]));
  const EdgeSides upper = sides_of(upper_, numbers_.own(tet.v[2]), numbers_.own(tet.v[3]));
  const bool lower_claims = !(raised[tet.v[0]] && raised[tet.v[1]]),
             upper_claims = !(raised[tet.v[2]] && raised[tet.v[3]]);
  const bool low_admitted = !upper_claims || upper.has(low), high_admitted = !lower_claims || lower.has(high);
  const auto joins = [&](Label label) {
    return !lower.has(label) || !upper.has(label) || linked(lower.triangle(label), upper.triangle(label));
  };
  if (low_admitted && high_admitted) {
    if (joins(low) != joins(high)) return joins(low) ? low : high;
    return materials_.wins(low, high) ? low : high;
  }
  if (low_admitted) return low;
  if (high_admitted) return high;
  for (const Label common : {lower.left, lower.right})
    if (upper.has(common)) return common;
  const bool low_wins = materials_.wins(low, high);
  if (low_wins)
    losers.insert(losers.end(), {tet.v[2], tet.v[3]});
  else
    losers.insert(losers.end(), {tet.v[0], tet.v[1]});
  return low_wins ? low : high;
}

}  // namespace odontoscope::partition
