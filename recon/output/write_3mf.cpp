#include "recon/output/write_3mf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "recon/formats/shell_groups.h"
#include "recon/formats/text_values.h"
#include "recon/output/zip_archive.h"

namespace odontoscope {
namespace {

constexpr const char* content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";
constexpr const char* relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

constexpr std::size_t materials_id = 1, first_object_id = 2;

/// "#RRGGBB", as a screen shows it.
std::string hex_colour(const std::string& structure) {
  std::string hex = "#";
  for (const double linear : paint_for(structure, Shell::Kind::external).colour)
    fmt::format_to(std::back_inserter(hex), "{:02X}", static_cast<int>(std::lround(255 * screen_value(linear))));
  return hex;
}

void append_vertices(std::string& xml, const SurfaceMesh& mesh) {
  constexpr const char* before[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
  for (const Point3& p : mesh.points) {
    const std::array<double, 3> coordinates{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      xml += before[k];
      append_number(xml, coordinates[k]);
    }
    xml += "\"/>\n";
  }
}

const char* object_type(bool closed) { return closed ? "model" : "surface"; }

void append_object(std::string& xml, const WrittenSurface& solid, std::size_t number) {
  fmt::format_to(std::back_inserter(xml),
                 "<object id=\"{}\" name=\"{}\" type=\"{}\" pid=\"{}\" pindex=\"{}\">\n<mesh>\n<vertices>\n",
                 first_object_id + number, xml_escaped(solid.structure),
                 object_type(solid.report.closed_oriented_manifold()), materials_id, number);
  append_vertices(xml, solid.surface);
  xml += "</vertices>\n<triangles>\n";
  for (const auto& [a, b, c] : solid.surface.triangles)
    fmt::format_to(std::back_inserter(xml), "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  xml += "</triangles>\n</mesh>\n</object>\n";
}

void append_resources(std::string& xml, const std::vector<const WrittenSurface*>& solids) {
  auto out = std::back_inserter(xml);
  fmt::format_to(out, "<basematerials id=\"{}\">\n", materials_id);
  for (const WrittenSurface* solid : solids)
    fmt::format_to(out, "<base name=\"{}\" displaycolor=\"{}\"/>\n", xml_escaped(solid->structure),
                   hex_colour(solid->structure));
  xml += "</basematerials>\n";
  for (std::size_t i = 0; i < solids.size(); ++i) append_object(xml, *solids[i], i);
  const bool closed = std::all_of(solids.begin(), solids.end(),
                                  [](const WrittenSurface* solid) { return solid->report.closed_oriented_manifold(); });
  fmt::format_to(out, "<object id=\"{}\" name=\"tooth\" type=\"{}\">\n<components>\n", first_object_id + solids.size(),
                 object_type(closed));
  for (std::size_t i = 0; i < solids.size(); ++i)
    fmt::format_to(out, "<component objectid=\"{}\"/>\n", first_object_id + i);
  xml += "</components>\n</object>\n";
}

}  // namespace

std::string threemf_bytes(const WrittenModel& model) {
  std::vector<const WrittenSurface*> solids;  // those that there is something of
  for (const WrittenSurface& solid : model.solids)
    if (!solid.surface.triangles.empty()) solids.push_back(&solid);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Title\">tooth</metadata>\n<metadata name=\"Application\">odontoscope</metadata>\n<metadata "
      "name=\"Description\">{}</metadata>\n<resources>\n",
      xml_escaped(certificate_in_words(model)));
  if (!solids.empty()) append_resources(xml, solids);
  xml += "</resources>\n<build>\n";
  if (!solids.empty())
    fmt::format_to(std::back_inserter(xml), "<item objectid=\"{}\"/>\n", first_object_id + solids.size());
  xml += "</build>\n</model>\n";
  const std::array<ZipEntry, 3> entries{ZipEntry{"[Content_Types].xml", content_types},
                                        ZipEntry{"_rels/.rels", relationships},
                                        ZipEntry{"3D/3dmodel.model", std::move(xml)}};
  return zip_bytes(entries);
}

}  // namespace odontoscope
