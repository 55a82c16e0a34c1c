#pragma once
// Seams of surfaces whose vertices are doubled there, as exporters of normals and textures do. For the .cpp files of
// this room only.

#include <cstddef>

#include "recon/mesh/named_mesh.h"

namespace odontoscope {

/// Where exactly two boundary edges lie in one place (ends bit-equal, -0 and 0 being equal), they become one and so do
/// their ends. So surfaces that only touch in a vertex, or of which more meet in an edge, are not glued together.
/// Returns how many vertices went; 0 leaves the mesh as it is. Precondition: indices in range.
std::size_t join_seams(SurfaceMesh& mesh);

/// The same, with a line in the mesh's remarks if it did something.
void join_seams_told(NamedMesh& mesh);

}  // namespace odontoscope
