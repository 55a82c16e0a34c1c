#pragma once
// Walls that two closed surfaces share, in files that join vertices by place: there each triangle lies on another, face
// to face, and edges have four triangles. For the .cpp files of this room only.

#include <cstddef>

#include "recon/mesh/named_mesh.h"

namespace odontoscope {

/// Gives each side of a shared wall vertices of its own, so that each surface is one of its own again. Only where two
/// surfaces share walls that are told apart by them (a fin whose two sides are one surface stays what it is), and only
/// in points of such walls: surfaces that touch in an edge or a vertex alone stay joined. Returns how many triangles
/// lie on another; 0 leaves the mesh as it is. Precondition: indices in range.
std::size_t part_walls(SurfaceMesh& mesh);

/// The same, with a line in the mesh's remarks if it did something.
void part_walls_told(NamedMesh& mesh);

}  // namespace odontoscope
