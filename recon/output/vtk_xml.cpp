#include "recon/output/vtk_xml.h"

#include <fmt/format.h>

#include <cstdint>

#include "recon/core/base64.h"
#include "recon/formats/little_endian.h"
#include "recon/formats/text_values.h"

namespace odontoscope {

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
