#include "recon/output/write_vtu.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "recon/formats/little_endian.h"
#include "recon/formats/shell_groups.h"
#include "recon/output/vtk_xml.h"

namespace odontoscope {
namespace {

struct SolidNumbers {
  std::string points, connectivity, offsets, types, structures, labels;
};

SolidNumbers numbers_of(const Reconstruction& reconstruction) {
  constexpr std::uint8_t vtk_tetra = 10;  // a positive one, as ours
  SolidNumbers numbers;
  std::int64_t first = 0, end = 0;
  std::uint16_t structure = 0;
  for (const Solid& solid : reconstruction.solids) {
    const TetraMesh& mesh = solid.tetrahedra;
    ++structure;
    for (const Point3& p : mesh.points) {
      for (const double coordinate : {p.x, p.y, p.z}) append(numbers.points, coordinate);
    }
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      for (const PointIndex v : mesh.tetrahedra[t]) append(numbers.connectivity, first + std::int64_t{v});
      append(numbers.offsets, end += 4);
      append(numbers.types, vtk_tetra);
      append(numbers.structures, structure);
      append(numbers.labels, mesh.labels[t]);
    }
    first += static_cast<std::int64_t>(mesh.points.size());
  }
  return numbers;
}

/// Tetrahedra, then the faces between two labels, each once.
std::string complex_bytes(const LabelledComplex& complex, const WrittenModel& model) {
  constexpr std::uint8_t vtk_tetra = 10, vtk_triangle = 5;
  const TetraMesh& mesh = complex.mesh;
  std::string points, connectivity, offsets, types, labels, inner, outer;
  std::int64_t end = 0;
  for (const Point3& p : mesh.points)
    for (const double coordinate : {p.x, p.y, p.z}) append(points, coordinate);
  const auto add = [&](const auto& corners, std::uint8_t type, Label label, Label in, Label out) {
    for (const PointIndex v : corners) append(connectivity, std::int64_t{v});
    append(offsets, end += static_cast<std::int64_t>(corners.size()));
    append(types, type);
    append(labels, label);
    append(inner, in);
    append(outer, out);
  };
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    add(mesh.tetrahedra[t], vtk_tetra, mesh.labels[t], mesh.labels[t], mesh.labels[t]);
  for (const InterfaceTriangle& face : complex.interfaces)
    add(face.triangle, vtk_triangle, void_label, face.inner, face.outer);
  std::vector<std::string_view> structures(complex.structures.begin(), complex.structures.end());
  std::string xml = vtk_opening("UnstructuredGrid", certificate_in_words(model));
  xml += vtk_field_data(structures, is_certified(model));
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", mesh.points.size(),
                     mesh.tetrahedra.size() + complex.interfaces.size());
  add_vtk_array(xml, {"Float64", "Points", 3}, points);
  xml += "</Points>\n<Cells>\n";
  add_vtk_array(xml, {"Int64", "connectivity"}, connectivity);
  add_vtk_array(xml, {"Int64", "offsets"}, offsets);
  add_vtk_array(xml, {"UInt8", "types"}, types);
  xml += "</Cells>\n<CellData Scalars=\"label\">\n";
  add_vtk_array(xml, {"UInt16", "label"}, labels);
  add_vtk_array(xml, {"UInt16", "inner"}, inner);
  add_vtk_array(xml, {"UInt16", "outer"}, outer);
  xml += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return xml;
}

}  // namespace

std::string vtu_bytes(const Reconstruction& reconstruction) {
  if (reconstruction.complex) return complex_bytes(*reconstruction.complex, WrittenModel(reconstruction));
  std::size_t points = 0, cells = 0;
  for (const Solid& solid : reconstruction.solids) {
    points += solid.tetrahedra.points.size();
    cells += solid.tetrahedra.tetrahedra.size();
  }
  const SolidNumbers numbers = numbers_of(reconstruction);
  const WrittenModel model(reconstruction);
  std::vector<std::string_view> structures;
  for (const Solid& solid : reconstruction.solids) structures.push_back(solid.structure);
  std::string xml = vtk_opening("UnstructuredGrid", certificate_in_words(model));
  xml += vtk_field_data(structures, is_certified(model));
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", points, cells);
  add_vtk_array(xml, {"Float64", "Points", 3}, numbers.points);
  xml += "</Points>\n<Cells>\n";
  add_vtk_array(xml, {"Int64", "connectivity"}, numbers.connectivity);
  add_vtk_array(xml, {"Int64", "offsets"}, numbers.offsets);
  add_vtk_array(xml, {"UInt8", "types"}, numbers.types);
  xml += "</Cells>\n<CellData Scalars=\"structure\">\n";
  add_vtk_array(xml, {"UInt16", "structure"}, numbers.structures);
  add_vtk_array(xml, {"UInt16", "label"}, numbers.labels);
  xml += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return xml;
}

}  // namespace odontoscope
