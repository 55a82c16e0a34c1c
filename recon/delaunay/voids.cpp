#include "recon/delaunay/voids.h"

#include <algorithm>

#include "recon/delaunay/witnesses.h"

namespace odontoscope::delaunay {
namespace {

/// For each point of the slice its contour.
Table<SlicePoint, std::uint32_t> contours_of_points(const ConformedSlice& slice) {
  Table<SlicePoint, std::uint32_t> contour(slice.first_point.back());
  for (std::uint32_t c = 0; c + 1 < slice.first_point.size(); ++c)
    std::fill(contour.begin() + slice.first_point[c], contour.begin() + slice.first_point[c + 1], c);
  return contour;
}

/// The void of each hole's contour; none for outer contours.
std::vector<std::uint32_t> holes_by_contour(const SliceVoids& voids, std::size_t contours) {
  std::vector<std::uint32_t> hole(contours, none);
  for (std::uint32_t v = 1; v < voids.count(); ++v) hole[voids.hole_contour[v - 1]] = v;
  return hole;
}

/// Spreads void `number` from the external triangle `seed`, never across a contour.
void spread(const Planar& planar, TriangleIndex seed, std::uint32_t number,
            Table<TriangleIndex, std::uint32_t>& of_triangle) {
  std::vector<TriangleIndex> stack{seed};
  of_triangle[seed] = number;
  while (!stack.empty()) {
    const PlanarTriangle& triangle = planar.triangles[stack.back()];
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const TriangleIndex other = triangle.nb[k];
      if (other == none || of_triangle[other] != none) continue;
      if (planar.contour_edge(triangle.v[(k + 1) % 3], triangle.v[(k + 2) % 3])) continue;
      of_triangle[other] = number;
      stack.push_back(other);
    }
  }
}

}  // namespace

PlanarVoids voids_in(const Planar& planar, const ConformedSlice& slice, const SliceVoids& voids) {
  const Table<SlicePoint, std::uint32_t> contour = contours_of_points(slice);
  const std::vector<std::uint32_t> hole = holes_by_contour(voids, slice.contour_number.size());
  PlanarVoids found;
  found.beside_point.assign(planar.points.size(), outside);
  found.of_triangle.assign(planar.triangles.size(), none);
  // A hole is all that can be reached from the right of its contour; what no hole reaches is outside.
  for (const TriangleIndex t : planar.triangles.indices()) {
    if (planar.inside(t) || found.of_triangle[t] != none) continue;
    for (int k = 0; k < 3; ++k) {
      const SlicePoint a = planar.triangles[t].v[(k + 1) % 3], b = planar.triangles[t].v[(k + 2) % 3];
      const std::uint32_t number = hole[contour[SlicePoint(planar.slice_point[a])]];
      if (planar.contour_edge(a, b) && number != none) {
        spread(planar, t, number, found.of_triangle);
        break;
      }
    }
  }
  for (const TriangleIndex t : planar.triangles.indices()) {
    if (planar.inside(t)) continue;
    if (found.of_triangle[t] == none) found.of_triangle[t] = outside;
    for (const SlicePoint v : planar.triangles[t].v) found.beside_point[v] = found.of_triangle[t];
  }
  return found;
}

SliceVoids voids_of(const ConformedSlice& slice) {
  SliceVoids voids;
  std::vector<bool> outer(slice.contour_number.size(), false);
  for (const std::uint32_t c : slice.outer_contour) outer[c] = true;
  for (std::uint32_t c = 0; c < outer.size(); ++c)
    if (!outer[c]) voids.hole_contour.push_back(c);
  const PlanarVoids planar = voids_in(slice.planar, slice, voids);
  // All points of a contour have the same void beside them; those on the hull with no triangle there say "outside",
  // which then is so.
  for (std::uint32_t c = 0; c < outer.size(); ++c)
    voids.of_contour.push_back(planar.beside_point[slice.first_point[c]]);
  return voids;
}

std::vector<RegionLink> witnessed_void_links(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper,
                                             const PlanarVoids& lower_voids, const PlanarVoids& upper_voids,
                                             Correspondence widest) {
  Witnesses witnesses;
  witnesses.add(outside, outside, LinkCriterion::reverse);
  if (lower.points.empty() || upper.points.empty()) {
    if (widest < Correspondence::medial) return witnesses.links();
    for (const std::uint32_t v : lower_voids.beside_point) witnesses.add(v, outside, LinkCriterion::medial);
    for (const std::uint32_t v : upper_voids.beside_point) witnesses.add(outside, v, LinkCriterion::medial);
    return witnesses.links();
  }
  const SlabNumbers numbers(lower);
  for (const SlabTetrahedron& tet : tetrahedra) {
    if (tet.dual_in_lower || tet.dual_in_upper) continue;
    const std::uint32_t below = lower_voids.beside_point[numbers.own(tet.v[0])],
                        above = upper_voids.beside_point[numbers.own(tet.v[3])];
    if (tet.lower_count != 2) {
      if (widest >= Correspondence::medial) witnesses.add(below, above, LinkCriterion::medial);
    } else if (tet.lower_edge == EdgeKind::external && tet.upper_edge == EdgeKind::external) {
      witnesses.add(below, above, LinkCriterion::reverse);
    } else if (widest >= Correspondence::overlap) {
      witnesses.add(below, above, LinkCriterion::overlap);
    }
  }
  return witnesses.links();
}

}  // namespace odontoscope::delaunay
