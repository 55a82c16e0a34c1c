#pragma once
// How the points in which a plane crosses the edges of a mesh join up. Inner part of cut_surfaces.h.

#include <vector>

#include "recon/mesh/half_edges.h"

namespace odontoscope {

/// Crossed edges, each as one of its half-edges, one after the other. A closed trace does not repeat its first; an open
/// one ends at borders of the surface or at edges with more than two triangles. Material is on the left seen from +z,
/// if the surface is oriented.
struct Trace {
  std::vector<HalfEdge> edges;
  bool closed = false;
};

/// Where the plane really lies: lower or higher than its height by less than any number, so that no vertex lies in it.
enum class Side { below, above };
/// Does the point lie above that plane?
inline bool lies_above(const Point3& point, double height, Side side) {
  return side == Side::below ? point.z >= height : point.z > height;
}

/// `crossing` holds the triangles with vertices on both sides.
std::vector<Trace> trace_plane(const SurfaceMesh& mesh, const EdgeMates& mates,
                               const std::vector<std::uint32_t>& crossing, double height, Side side);

/// Where the plane crosses the edge: the vertex itself if one lies at that height.
Point2 crossing_point(const SurfaceMesh& mesh, HalfEdge edge, double height);

}  // namespace odontoscope
