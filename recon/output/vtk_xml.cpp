#include "recon/output/vtk_xml.h"

#include <fmt/format.h>

#include <cstdint>

#include "recon/output/little_endian.h"
#include "recon/output/text_values.h"

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

}  // namespace

void add_vtk_array(std::string& xml, const VtkArray& array, const std::string& bytes) {
  // VTK wants the count of bytes in front, in one base64 run with them.
  std::string counted;
  counted.reserve(bytes.size() + sizeof(std::uint64_t));
  append(counted, static_cast<std::uint64_t>(bytes.size()));
  counted += bytes;
  xml += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n", array.type,
                     array.name, array.components);
  xml += base64(counted);
  xml += "\n</DataArray>\n";
}

std::string vtk_field_data(const std::vector<std::string_view>& structures, bool certified) {
  constexpr const char* number =
      "<DataArray type=\"Int64\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n";
  std::string xml = "<FieldData>\n";
  for (std::size_t i = 0; i < structures.size(); ++i) {
    xml += fmt::format(fmt::runtime(number), "structure " + xml_escaped(structures[i]), i + 1);
  }
  xml += fmt::format(fmt::runtime(number), "certified", certified ? 1 : 0);
  return xml + "</FieldData>\n";
}

std::string vtk_opening(std::string_view type, std::string_view certificate) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- made by odontoscope; millimetres; {0} -->\n"
      "<VTKFile type=\"{1}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<{1}>\n",
      certificate, type);
}

}  // namespace odontoscope
