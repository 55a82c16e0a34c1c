#pragma once
// Triangle surfaces and tetrahedral solids as plain arrays.
//
// Triangles are counter-clockwise seen from outside the material. A tetrahedron (a,b,c,d) is positive: d lies on the
// side of triangle abc from which abc is counter-clockwise, so det(b-a, c-a, d-a) > 0; its outward faces are then
// (a,c,b), (a,b,d), (b,c,d), (a,d,c). Indices count from 0 into `points`. Units: millimetres.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

using PointIndex = std::uint32_t;
/// Material: 0 is void; the names of the others are listed beside the mesh.
using Label = std::uint16_t;
inline constexpr Label void_label = 0;

using Triangle = std::array<PointIndex, 3>;
using Tetrahedron = std::array<PointIndex, 4>;

struct SurfaceMesh {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

struct TetraMesh {
  std::vector<Point3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Label> labels;  // one for each tetrahedron
};

/// The outward faces of a tetrahedron, face i opposite vertex i.
inline constexpr int outward_face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

}  // namespace odontoscope
