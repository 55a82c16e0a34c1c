#pragma once
// Surfaces and solids whose topology is known by construction. All are outward oriented unless their name says
// otherwise.

#include <cstddef>

#include "recon/mesh/meshes.h"

namespace odontoscope::shapes {

SurfaceMesh tetrahedron();
/// Axis-parallel cube from (x, y, z), twelve triangles.
SurfaceMesh cube(double x = 0, double y = 0, double z = 0, double side = 1);
/// Octahedron subdivided `levels` times and pushed to radius: 8 * 4^levels triangles.
SurfaceMesh sphere(double radius, int levels);
/// Round torus about the z axis: 2 * around * across triangles, genus 1.
SurfaceMesh torus(double radius, double tube, std::size_t around, std::size_t across);
/// Stacked contours as a slicer sees them: `layers` rings of `around` points on a bulging column, joined by bands and
/// closed by two fans at the axis. With `terraced` every second layer repeats the ring below, so that walls and flat
/// steps alternate.
struct ColumnOptions {
  std::size_t around = 60, layers = 40;
  bool terraced = false;
};
SurfaceMesh column(const ColumnOptions& options);

SurfaceMesh inside_out(SurfaceMesh mesh);
SurfaceMesh together(const SurfaceMesh& a, const SurfaceMesh& b);
SurfaceMesh moved(SurfaceMesh mesh, double x, double y, double z);
/// Without its triangle number `which`.
SurfaceMesh holed(SurfaceMesh mesh, std::size_t which = 0);
/// With its triangle number `which` turned over.
SurfaceMesh flipped(SurfaceMesh mesh, std::size_t which = 0);

/// Two cubes that share the four corners' worth of one edge, or one vertex, by index.
SurfaceMesh cubes_on_one_edge();
SurfaceMesh cubes_on_one_vertex();
/// A strip of `n` quads with a half twist: no orientation exists.
SurfaceMesh moebius_strip(std::size_t n);

/// Five positive tetrahedra that fill the unit cube.
TetraMesh cube_of_five();
/// All edges 1.
TetraMesh regular_tetrahedron();

}  // namespace odontoscope::shapes
