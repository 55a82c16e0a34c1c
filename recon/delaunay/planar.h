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

namespace odontoscope::delaunay {

inline constexpr std::uint32_t none = 0xffffffffu;

/// What an in-plane edge is to the regions: outside all of them, on a contour, or inside one.
enum class EdgeKind : std::uint8_t { external, contour, internal };

struct PlanarTriangle {
  std::array<std::uint32_t, 3> v{none, none, none};   // counter-clockwise
  std::array<std::uint32_t, 3> nb{none, none, none};  // across the edge opposite v[k]; none beyond the hull
  std::uint32_t region = none;                        // none: external
};

/// Circumcentre in rounded arithmetic; the true one lies within `error` of it in each coordinate (infinity: unknown).
struct Circumcentre {
  Point2 at;
  double error = 0;
};

/// An edge as seen from one end.
struct Spoke {
  std::uint32_t vertex = none;
  std::uint32_t triangle = none;  // between this spoke and the next counter-clockwise; none: the hull's gap
  EdgeKind kind = EdgeKind::external;
};

struct Planar {
  std::vector<Point2> points;
  std::vector<std::uint32_t> slice_point;     // number of each point in its slice (a component has only some of them)
  std::vector<std::uint32_t> next, previous;  // along the contour, the region on the left
  std::vector<std::uint32_t> region_of;       // of each point: the region that its contour bounds
  std::vector<PlanarTriangle> triangles;
  std::vector<Circumcentre> centres;           // of each triangle
  std::vector<std::uint32_t> first_spoke;      // spokes of v: [first_spoke[v], first_spoke[v+1])
  std::vector<Spoke> spokes;                   // of a hull vertex: the first has the hull on its right
  std::vector<std::uint32_t> insertion_order;  // a spatial order of the points

  bool contour_edge(std::uint32_t a, std::uint32_t b) const { return next[a] == b || next[b] == a; }
  bool inside(std::uint32_t triangle) const { return triangle != none && triangles[triangle].region != none; }
};

/// The triangle on the left of each point's contour edge; none where the triangulation lacks the edge.
std::vector<std::uint32_t> left_triangles(const Planar& planar);

/// Fills first_spoke and spokes from triangles, regions and contours.
void collect_spokes(Planar& planar);

}  // namespace odontoscope::delaunay
