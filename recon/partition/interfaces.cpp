#include "recon/partition/interfaces.h"

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"

namespace odontoscope::partition {
namespace {

using delaunay::even_permutation;
using delaunay::FaceTable;

Triangle face_of(const Tetrahedron& tet, int i) {
  return {tet[outward_face[i][0]], tet[outward_face[i][1]], tet[outward_face[i][2]]};
}

}  // namespace

std::vector<InterfaceTriangle> interfaces_of(const TetraMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.tetrahedra.size());
  constexpr std::uint32_t taken = FaceTable::vacant - 1;
  FaceTable table(std::size_t{4} * count);
  std::vector<std::uint32_t> beyond(std::size_t{4} * count, FaceTable::vacant);  // the tetrahedron across each face
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Triangle face = face_of(mesh.tetrahedra[t], static_cast<int>(i));
      std::uint32_t& seen = table(face[0], face[1], face[2]);
      if (seen == taken) throw InternalError("three tetrahedra of a partition share a face");
      if (seen == FaceTable::vacant) {
        seen = 4 * t + i;
        continue;
      }
      if (even_permutation(face) == even_permutation(face_of(mesh.tetrahedra[seen / 4], static_cast<int>(seen % 4))))
        throw InternalError("two tetrahedra of a partition lie on the same side of a face");
      beyond[4 * t + i] = seen / 4;
      beyond[seen] = t;
      seen = taken;
    }
  std::vector<InterfaceTriangle> found;
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t other = beyond[4 * t + i];
      const Label here = mesh.labels[t], there = other == FaceTable::vacant ? void_label : mesh.labels[other];
      if (here == there || (there != void_label && there < here)) continue;
      found.push_back({face_of(mesh.tetrahedra[t], static_cast<int>(i)), here, there});
    }
  return found;
}

}  // namespace odontoscope::partition
