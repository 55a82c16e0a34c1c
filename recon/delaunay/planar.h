#pragma once
// The plane Delaunay triangulation of (a part of) a slice, as compact arrays, with what the slab walk needs: for each
// vertex its spokes in counter-clockwise order, for each triangle its circumcentre, for each edge its kind.
//
// Both slices of a slab are facets of the slab's convex hull, so the 3D Delaunay triangulation restricted to a slice is
// this one; everything that a slab needs to know about a slice is decided here, once and exactly.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/core/index.h"

namespace odontoscope::delaunay {

inline constexpr NoIndex none;

/// A point of a triangulation, a triangle of it, and an edge of it as seen from one end.
using SlicePoint = Index<struct SlicePointKind>;
using TriangleIndex = Index<struct TriangleKind>;
using SpokeIndex = Index<struct SpokeKind>;

/// What an in-plane edge is to the regions: outside all of them, on a contour, or inside one.
enum class EdgeKind : std::uint8_t { external, contour, internal };

struct PlanarTriangle {
  std::array<SlicePoint, 3> v;      // counter-clockwise
  std::array<TriangleIndex, 3> nb;  // across the edge opposite v[k]; none beyond the hull
  std::uint32_t region = none;      // none: external
};

/// Circumcentre in rounded arithmetic; the true one lies within `error` of it in each coordinate (infinity: unknown).
struct Circumcentre {
  Point2 at;
  double error = 0;
};

/// An edge as seen from one end.
struct Spoke {
  SlicePoint vertex;
  TriangleIndex triangle;  // between this spoke and the next counter-clockwise; none: the hull's gap
  EdgeKind kind = EdgeKind::external;
};

struct Planar {
  Table<SlicePoint, Point2> points;
  Table<SlicePoint, std::uint32_t> slice_point;  // number of each point in its slice (a component has only some)
  Table<SlicePoint, SlicePoint> next, previous;  // along the contour, the region on the left
  Table<SlicePoint, std::uint32_t> region_of;    // of each point: the region that its contour bounds
  Table<TriangleIndex, PlanarTriangle> triangles;
  Table<TriangleIndex, Circumcentre> centres;  // of each triangle
  Table<SlicePoint, SpokeIndex> first_spoke;   // spokes of v: spokes_of(v); one more than points
  Table<SpokeIndex, Spoke> spokes;             // of a hull vertex: the first has the hull on its right
  std::vector<SlicePoint> insertion_order;     // a spatial order of the points

  bool contour_edge(SlicePoint a, SlicePoint b) const { return next[a] == b || next[b] == a; }
  bool inside(TriangleIndex triangle) const { return triangle != none && triangles[triangle].region != none; }
  /// Counter-clockwise.
  Indices<SpokeIndex> spokes_of(SlicePoint v) const { return {first_spoke[v], first_spoke[SlicePoint(v + 1)]}; }
  /// Of v's spokes the one clockwise of s.
  SpokeIndex before(SlicePoint v, SpokeIndex s) const {
    const Indices<SpokeIndex> all = spokes_of(v);
    return s == all.front() ? all.back() : SpokeIndex(s - 1);
  }
  /// Of one of v's spokes; that on its left is the spoke's own.
  TriangleIndex right_of(SlicePoint v, SpokeIndex s) const { return spokes[before(v, s)].triangle; }
};

/// The triangle on the left of each point's contour edge; none where the triangulation lacks the edge.
Table<SlicePoint, TriangleIndex> left_triangles(const Planar& planar);

/// Fills first_spoke and spokes from triangles, regions and contours.
void collect_spokes(Planar& planar);

}  // namespace odontoscope::delaunay
