#include "recon/partition/complex_parts.h"

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"

namespace odontoscope::partition {
namespace {

using delaunay::even_permutation;
using delaunay::FaceTable;

Triangle face_of(const Tetrahedron& tet, int i) { return {tet[outward_face[i][0]], tet[outward_face[i][1]], tet[outward_face[i][2]]}; }

constexpr std::uint32_t unused = FaceTable::vacant;

/// New numbers for the points that are used, in their order.
template <class Cells>
std::vector<std::uint32_t> numbering(const Cells& cells, std::size_t points) {
  std::vector<std::uint32_t> number(points, unused);
  for (const auto& cell : cells)
    for (const std::uint32_t v : cell) number[v] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t& n : number)
    if (n != unused) n = count++;
  return number;
}

template <class Cell>
void renumber(Cell& cell, const std::vector<std::uint32_t>& number) {
  for (std::uint32_t& v : cell) v = number[v];
}

std::vector<Point3> used_points(const std::vector<Point3>& points, const std::vector<std::uint32_t>& number) {
  std::vector<Point3> kept;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (number[v] != unused) kept.push_back(points[v]);
  return kept;
}

/// The points that the cells use, which are renumbered.
template <class Cells>
std::vector<Point3> compacted(const std::vector<Point3>& points, Cells& cells) {
  const std::vector<std::uint32_t> number = numbering(cells, points.size());
  for (auto& cell : cells) renumber(cell, number);
  return used_points(points, number);
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
  const std::vector<std::uint32_t> number = numbering(mesh.tetrahedra, mesh.points.size());
  for (InterfaceTriangle& face : interfaces) renumber(face.triangle, number);
  for (Tetrahedron& tet : mesh.tetrahedra) renumber(tet, number);
  mesh.points = used_points(mesh.points, number);
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
