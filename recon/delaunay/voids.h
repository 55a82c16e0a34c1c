#pragma once
// The void regions of a slice, and which of two neighbouring slices belong together: correspondence (correspond.h)
// seen from the other side. With both, the topology that a slab must have can be counted before any tetrahedron is
// kept.
//
// Void 0 is the outside. Each hole of a region is one more: what its contour encloses, less the islands in it. A
// contour point has void on one side only, and a Voronoi cell meets no contour but its site's own two edges
// (conform.h); so every external edge or triangle at a point, and every dual point outside the regions whose nearest
// point it is, lies in the void beside it. Nothing is computed.

#include <cstdint>
#include <vector>

#include "recon/delaunay/conform.h"
#include "recon/delaunay/correspond.h"

namespace odontoscope::delaunay {

inline constexpr std::uint32_t outside = 0;

/// The voids of one slice. Contours are counted as in ConformedSlice.
struct SliceVoids {
  std::vector<std::uint32_t>
      hole_contour;  // of each void but the outside: void v is bounded by contour hole_contour[v - 1]
  std::vector<std::uint32_t>
      of_contour;  // of each contour: the void on its outer side; of a hole's contour the hole itself

  std::uint32_t count() const { return static_cast<std::uint32_t>(hole_contour.size()) + 1; }
};

/// Voids are numbered in the order of their contours. An empty slice has the outside only.
SliceVoids voids_of(const ConformedSlice& slice);

/// The voids of a triangulation of all or some regions of a slice. Where regions are left out (part_of), what they
/// filled is void: an island whose ring is left out stands in the outside.
struct PlanarVoids {
  Table<SlicePoint, std::uint32_t> beside_point;    // of each point: the void on the outer side of its contour
  Table<TriangleIndex, std::uint32_t> of_triangle;  // of each triangle: its void; none for those of regions
};

/// `planar` is slice.planar or part_of it; voids keep the numbers that they have in `voids`, the slice's own.
PlanarVoids voids_in(const Planar& planar, const ConformedSlice& slice, const SliceVoids& voids);

/// Pairs of voids with a witness, each with the strictest criterion that has one, in the order reverse, medial,
/// overlap, then by void:
///   reverse: a 2-2 whose in-plane edges are both external;
///   medial:  or the circumcentre of an external triangle of one lies in the other;
///   overlap: or the dual point of a 2-2 lies in both.
/// Criteria wider than `widest` are not looked at. The outside is always linked with the outside, as `reverse`. A
/// slice with no points is outside everywhere: each void of the other is linked with it, as `medial`. `tetrahedra`
/// are triangulate_slab(lower, upper); empty where one of these is.
std::vector<RegionLink> witnessed_void_links(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper,
                                             const PlanarVoids& lower_voids, const PlanarVoids& upper_voids,
                                             Correspondence widest);

}  // namespace odontoscope::delaunay
