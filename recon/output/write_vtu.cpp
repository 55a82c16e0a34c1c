#include "recon/output/write_vtu.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "recon/output/little_endian.h"

namespace odontoscope {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k])) : 0u;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (unsigned k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

struct Array {
  std::string_view type, name;
  int components = 1;
};

/// `bytes` are the numbers themselves; VTK wants their count in bytes in front, in one base64 run.
void add_array(std::string& xml, const Array& array, const std::string& bytes) {
  std::string counted;
  counted.reserve(bytes.size() + sizeof(std::uint64_t));
  append(counted, static_cast<std::uint64_t>(bytes.size()));
  counted += bytes;
  xml += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n", array.type,
                     array.name, array.components);
  xml += base64(counted);
  xml += "\n</DataArray>\n";
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// One field each, named after the structure and holding its number: not every reader knows VTK's strings.
std::string structure_numbers(const Reconstruction& reconstruction) {
  std::string xml = "<FieldData>\n";
  for (std::size_t i = 0; i < reconstruction.solids.size(); ++i) {
    xml += fmt::format(
        "<DataArray type=\"Int64\" Name=\"structure {}\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
        xml_escaped(reconstruction.solids[i].structure), i + 1);
  }
  return xml + "</FieldData>\n";
}

struct Numbers {
  std::string points, connectivity, offsets, types, structures, labels;
};

Numbers numbers_of(const Reconstruction& reconstruction) {
  constexpr std::uint8_t vtk_tetra = 10;  // a positive one, as ours
  Numbers numbers;
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

}  // namespace

std::string vtu_bytes(const Reconstruction& reconstruction) {
  std::size_t points = 0, cells = 0;
  for (const Solid& solid : reconstruction.solids) {
    points += solid.tetrahedra.points.size();
    cells += solid.tetrahedra.tetrahedra.size();
  }
  const Numbers numbers = numbers_of(reconstruction);
  std::string xml =
      "<?xml version=\"1.0\"?>\n<!-- made by odontoscope; millimetres -->\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n";
  xml += structure_numbers(reconstruction);
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", points, cells);
  add_array(xml, {"Float64", "Points", 3}, numbers.points);
  xml += "</Points>\n<Cells>\n";
  add_array(xml, {"Int64", "connectivity"}, numbers.connectivity);
  add_array(xml, {"Int64", "offsets"}, numbers.offsets);
  add_array(xml, {"UInt8", "types"}, numbers.types);
  xml += "</Cells>\n<CellData Scalars=\"structure\">\n";
  add_array(xml, {"UInt16", "structure"}, numbers.structures);
  add_array(xml, {"UInt16", "label"}, numbers.labels);
  xml += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return xml;
}

}  // namespace odontoscope
