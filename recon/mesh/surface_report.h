#pragma once
// The judge: one report for every triangle mesh, whatever made it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

/// A connected component of a surface, connected through shared edges.
struct Shell {
  enum class Kind { external, cavity, open };  // closed with positive volume; closed with negative volume; neither
  Kind kind = Kind::open;
  std::string structure;  // filled in by whoever knows; may be empty
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  long genus = 0;     // (2 - Euler characteristic) / 2; meaningless for an open shell
  double volume = 0;  // signed, mm^3: positive if oriented outwards
  double area = 0;    // mm^2
};

struct Distribution {  // of one quality measure over all triangles (or tetrahedra)
  double min = 0, median = 0, max = 0, mean = 0;
  std::vector<std::size_t>
      histogram;  // ten equal bins over [histogram_low, histogram_high]; what lies beyond is in the outer bins
  double histogram_low = 0, histogram_high = 0;
};

struct SurfaceReport {
  std::size_t vertices = 0;  // that a triangle uses
  std::size_t triangles = 0;
  std::size_t boundary_edges = 0;        // with one triangle
  std::size_t nonmanifold_edges = 0;     // with more than two
  std::size_t misoriented_edges = 0;     // with two that run through it the same way
  std::size_t nonmanifold_vertices = 0;  // whose triangles do not form one fan of edges with at most two triangles
  std::size_t degenerate_triangles = 0;  // exactly zero area or a repeated vertex, by exact predicate
  std::vector<Shell> shells;             // largest area first; ties by first triangle
  std::vector<std::uint32_t> shell_of;   // for each triangle
  Distribution smallest_angle_deg;       // of each triangle that is not degenerate
  Distribution aspect_ratio;             // circumradius / (2 inradius), likewise: 1 for equilateral

  /// No boundary, non-manifold or misoriented edge, no non-manifold vertex, no degenerate triangle, and not empty.
  bool closed_oriented_manifold() const;
};

/// Precondition: indices in range (readers check that). Vertices are compared by index, not by place; see `weld` for
/// formats without indices. A triangle that names a vertex twice is degenerate, an open shell of its own, and has no
/// part in edges and fans. The sign of a shell's volume is exact. Not checked: whether the surface cuts through itself.
/// Deterministic.
SurfaceReport inspect(const SurfaceMesh& mesh);

/// Triangle soup (STL) to indexed mesh: points with bit-equal coordinates (-0 equals 0) become one.
SurfaceMesh weld(const SurfaceMesh& soup);

}  // namespace odontoscope
