#include "recon/output/write_vtp.h"

#include <fmt/format.h>

#include <cstdint>

#include "recon/formats/little_endian.h"
#include "recon/formats/shell_groups.h"
#include "recon/output/vtk_xml.h"

namespace odontoscope {
namespace {

struct SurfaceNumbers {
  std::string points, connectivity, offsets, structures, kinds;
};

SurfaceNumbers numbers_of(const WrittenModel& model) {
  SurfaceNumbers numbers;
  std::int64_t first = 0, end = 0;
  std::uint16_t structure = 0;
  for (const WrittenSurface& solid : model.solids) {
    ++structure;
    for (const Point3& p : solid.surface.points) {
      for (const double coordinate : {p.x, p.y, p.z}) append(numbers.points, coordinate);
    }
    for (const ShellGroup& group : shell_groups(solid)) {
      for (const std::uint32_t t : group.triangles) {
        for (const PointIndex v : solid.surface.triangles[t]) append(numbers.connectivity, first + std::int64_t{v});
        append(numbers.offsets, end += 3);
        append(numbers.structures, structure);
        append(numbers.kinds, static_cast<std::uint8_t>(group.kind));
      }
    }
    first += static_cast<std::int64_t>(solid.surface.points.size());
  }
  return numbers;
}

}  // namespace

std::string vtp_bytes(const WrittenModel& model) {
  static_assert(static_cast<int>(Shell::Kind::external) == 0 && static_cast<int>(Shell::Kind::cavity) == 1);
  std::size_t points = 0, triangles = 0;
  std::vector<std::string_view> structures;
  for (const WrittenSurface& solid : model.solids) {
    points += solid.surface.points.size();
    triangles += solid.surface.triangles.size();
    structures.push_back(solid.structure);
  }
  const SurfaceNumbers numbers = numbers_of(model);
  std::string xml = vtk_opening("PolyData", certificate_in_words(model));
  xml += vtk_field_data(structures, is_certified(model));
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n", points, triangles);
  add_vtk_array(xml, {"Float64", "Points", 3}, numbers.points);
  xml += "</Points>\n<Polys>\n";
  add_vtk_array(xml, {"Int64", "connectivity"}, numbers.connectivity);
  add_vtk_array(xml, {"Int64", "offsets"}, numbers.offsets);
  xml += "</Polys>\n<CellData Scalars=\"structure\">\n";
  add_vtk_array(xml, {"UInt16", "structure"}, numbers.structures);
  add_vtk_array(xml, {"UInt8", "kind"}, numbers.kinds);
  xml += "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return xml;
}

}  // namespace odontoscope
