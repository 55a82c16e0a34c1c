#include "recon/partition/complex_parts.h"

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"

namespace odontoscope::partition {
namespace {

using delaunay::FaceTable;

Triangle face_of(const Tetrahedron& tet, int i) { return {tet[outward_face[i][0]], tet[outward_face[i][1]], tet[outward_face[i][2]]}; }

bool even_permutation(const Triangle& face) {
  return (face[0] < face[1]) != ((face[1] < face[2]) != (face[0] < face[2]));
}

/// Numbers for the points that are used, in their order.
template <class Cells>
std::vector<Point3> compacted(const std::vector<Point3>& points, Cells& cells) {
  constexpr std::uint32_t unused = FaceTable::vacant;
  std::vector<std::uint32_t> number(points.size(), unused);
  for (const auto& cell : cells)
    for (const std::uint32_t v : cell) number[v] = 0;
  std::vector<Point3> kept;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (number[v] != unused) {
      number[v] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(points[v]);
    }
  for (auto& cell : cells)
    for (std::uint32_t& v : cell) v = number[v];
  return kept;
}

}  // namespace

std::vector<InterfaceTriangle> interfaces_of(const TetraMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.tetrahedra.size());
  constexpr std::uint32_t taken = FaceTable::vacant - 1;
  FaceTable table(std::size_t{4} * count);
  std::vector<std::uint32_t> beyond(std::size_t{4} * count, FaceTable::vacant);   // the tetrahedron across each face
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

void drop_unused(TetraMesh& mesh, std::vector<InterfaceTriangle>& interfaces) {
  std::vector<std::uint32_t> number(mesh.points.size(), FaceTable::vacant);
  for (const Tetrahedron& tet : mesh.tetrahedra)
    for (const std::uint32_t v : tet) number[v] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t& n : number)
    if (n != FaceTable::vacant) n = count++;
  for (InterfaceTriangle& face : interfaces)
    for (std::uint32_t& v : face.triangle) v = number[v];
  mesh.points = compacted(mesh.points, mesh.tetrahedra);
}

SurfaceMesh surface_of(const LabelledComplex& complex, Label label) {
  SurfaceMesh surface;
  for (const InterfaceTriangle& face : complex.interfaces) {
    if (label == void_label ? face.outer == void_label : face.inner == label) {
      surface.triangles.push_back(face.triangle);
    } else if (label != void_label && face.outer == label) {
      surface.triangles.push_back({face.triangle[0], face.triangle[2], face.triangle[1]});
    }
  }
  surface.points = compacted(complex.mesh.points, surface.triangles);
  return surface;
}

TetraMesh tetrahedra_of(const LabelledComplex& complex, Label label) {
  TetraMesh mesh;
  for (std::size_t t = 0; t < complex.mesh.tetrahedra.size(); ++t)
    if (complex.mesh.labels[t] == label) mesh.tetrahedra.push_back(complex.mesh.tetrahedra[t]);
  mesh.labels.assign(mesh.tetrahedra.size(), label);
  mesh.points = compacted(complex.mesh.points, mesh.tetrahedra);
  return mesh;
}

}  // namespace odontoscope::partition
