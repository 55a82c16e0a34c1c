#pragma once
// A triangle surface cut by a plane of constant z: as closed loops, as traces along its edges, as loose segments.
//
// One rule for vertices in the plane, everywhere: the plane is cut as if it lay lower than its height, or higher, by
// less than any number, so that no vertex lies in it (symbolic perturbation, after H. Edelsbrunner and E. P. Muecke,
// "Simulation of simplicity", ACM Transactions on Graphics 9(1), 1990). Signs alone decide what is crossed. Points are
// rounded once; where a vertex lies in the plane they are that vertex.

#include <cstdint>
#include <vector>

#include "recon/mesh/half_edges.h"

namespace odontoscope {

/// Where the plane really lies. Below: a vertex at its height counts as above it.
enum class Side { below, above };
inline bool lies_above(const Point3& point, double height, Side side = Side::below) {
  return side == Side::below ? point.z >= height : point.z > height;
}

/// Where the plane crosses the edge of two places on different sides of it; the same from either end.
Point2 crossing_point(const Point3& a, const Point3& b, double height);
inline Point2 crossing_point(const SurfaceMesh& mesh, HalfEdge edge, double height) {
  return crossing_point(mesh.points[start(mesh, edge)], mesh.points[end(mesh, edge)], height);
}

/// Material is on the right of each loop seen from +z: a loop round material is clockwise. In the order of the edges
/// that each is first met in. Precondition: a closed oriented manifold; from what is not, parts of loops.
std::vector<std::vector<Point2>> section_loops(const SurfaceMesh& surface, double height, Side side = Side::below);

/// Crossed edges, each as one of its half-edges, one after the other. A closed trace does not repeat its first; an open
/// one ends at borders of the surface or at edges with more than two triangles. Material is on the left seen from +z,
/// if the surface is oriented.
struct SectionTrace {
  std::vector<HalfEdge> edges;
  bool closed = false;
};
/// For any surface. `crossing` holds the triangles with vertices on both sides.
std::vector<SectionTrace> section_traces(const SurfaceMesh& mesh, const EdgeMates& mates,
                                         const std::vector<std::uint32_t>& crossing, double height, Side side);

struct SectionSegment {
  Point2 from, to;
};
/// The cut by one plane, as the surface is just below it and just above it; one segment a triangle, in order of the
/// triangles. They differ where the model begins, ends or has a flat piece in the plane. A side of a triangle that lies
/// in the plane is given as it is, without rounding. For any surface, closed or not: what is missing in the surface is
/// missing in the section.
struct PlaneSection {
  std::vector<SectionSegment> below, above;
};
std::vector<PlaneSection> sections(const SurfaceMesh& surface, const std::vector<double>& heights);

}  // namespace odontoscope
