#include "recon/mesh/complex_parts.h"

#include <algorithm>
#include <limits>

namespace odontoscope {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

template <class Cell>
void mark(const Cell& cell, std::vector<std::uint32_t>& number) {
  for (const std::uint32_t v : cell) number[v] = 0;
}

/// New numbers for the points that are marked, in their order.
void count_up(std::vector<std::uint32_t>& number) {
  std::uint32_t count = 0;
  for (std::uint32_t& n : number)
    if (n != unused) n = count++;
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
  std::vector<std::uint32_t> number(points.size(), unused);
  for (const auto& cell : cells) mark(cell, number);
  count_up(number);
  for (auto& cell : cells) renumber(cell, number);
  return used_points(points, number);
}

}  // namespace

void drop_unused(LabelledComplex& complex) {
  TetraMesh& mesh = complex.mesh;
  std::vector<std::uint32_t> number(mesh.points.size(), unused);
  for (const Tetrahedron& tet : mesh.tetrahedra) mark(tet, number);
  for (const InterfaceTriangle& face : complex.interfaces) mark(face.triangle, number);
  count_up(number);
  for (InterfaceTriangle& face : complex.interfaces) renumber(face.triangle, number);
  for (Tetrahedron& tet : mesh.tetrahedra) renumber(tet, number);
  mesh.points = used_points(mesh.points, number);
}

Label label_of(const LabelledComplex& complex, const std::string& structure) {
  const auto named = std::find(complex.structures.begin(), complex.structures.end(), structure);
  return static_cast<Label>(named - complex.structures.begin() + 1);
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

}  // namespace odontoscope
