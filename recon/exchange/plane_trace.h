#pragma once
// How the points in which a plane crosses the edges of a mesh join up. Inner part of cut_surfaces.h.

#include <vector>

#include "recon/mesh/half_edges.h"

namespace odontoscope {

/// Crossed edges, each as one of its half-edges, one after the other. A closed trace does not repeat its first; an open one ends at borders of the
/// surface or at edges with more than two triangles. Material is on the left seen from +z, if the surface is oriented.
struct Trace {
  std::vector<HalfEdge> edges;
  bool closed = false;
};

/// `crossing` holds the triangles with vertices on both sides, a vertex with z >= `height` counting as above.
std::vector<Trace> trace_plane(const SurfaceMesh& mesh, const EdgeMates& mates, const std::vector<std::uint32_t>& crossing, double height);

/// Where the plane crosses the edge: the vertex itself if one lies in the plane, but with `lowered` a 64th of the edge below it.
Point2 crossing_point(const SurfaceMesh& mesh, HalfEdge edge, double height, bool lowered);

}  // namespace odontoscope
