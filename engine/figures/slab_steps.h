#pragma once
// One slab of the DT method, stopped after each of its steps, so that figures can show them.

#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::figures {

/// A tetrahedron that has one edge in each slice, neither of them on a contour. `connecting`: both lie inside regions,
/// which is the paper's sign that the two belong together; else an edge runs outside, between two contours.
struct ReverseTetrahedron {
  Tetrahedron corners{};
  bool lower_inside = false, upper_inside = false;
  double volume = 0;
};

struct SlabSteps {
  std::vector<Point3> points;               // of both slices, then those that were lifted
  std::vector<Tetrahedron> delaunay;        // all of them
  std::vector<ReverseTetrahedron> reverse;  // among them, largest first
  std::vector<Tetrahedron> kept;            // after elimination
  std::vector<Point3> singular_edges;       // of `kept`, two points an edge
  std::vector<Tetrahedron> restored;        // what repair puts back, before it is split
  std::vector<Tetrahedron> split;           // the same, after splitting and lifting
  std::vector<Point3> lifted;               // where the new points went
  std::vector<Tetrahedron> solid;           // the result
};

/// Precondition: a valid stack of two slices and one structure, whose regions form one component.
SlabSteps slab_steps(const ContourStack& stack);

/// Edges in more than two outer faces of these tetrahedra, two points an edge.
std::vector<Point3> singular_edges(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra);

/// The outer faces.
SurfaceMesh boundary_of(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra);

}  // namespace odontoscope::figures
