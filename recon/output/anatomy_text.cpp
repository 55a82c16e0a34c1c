#include "recon/output/anatomy_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recon/output/json_values.h"

namespace odontoscope {
namespace {

Json json_of(const Point3& p) { return {p.x, p.y, p.z}; }
Json json_of(const MeasuredPlace& place) { return {{"width", place.width}, {"at", json_of(place.at)}}; }

Json json_of(const MeasuredCanal& canal) {
  return {{"name", canal.name},
          {"length", canal.length},
          {"schneider_deg", canal.schneider_deg},
          {"smallest_bend_radius", std::isfinite(canal.smallest_bend) ? Json(canal.smallest_bend) : Json()},
          {"mean_width", canal.mean_width},
          {"narrowest", canal.narrowest ? json_of(*canal.narrowest) : Json()},
          {"thinnest_wall", canal.thinnest_wall ? json_of(*canal.thinnest_wall) : Json()},
          {"orifice", json_of(canal.orifice)},
          {"end", json_of(canal.end)}};
}

Json json_of(const Anatomy& anatomy, std::size_t number) {
  const CanalPart& part = anatomy.graph.parts[number];
  Json names = Json::array();
  for (const std::size_t c : part.canals) names.push_back(anatomy.canals[c].name);
  return {{"from", part.from}, {"to", part.to}, {"canals", names}, {"length", anatomy.parts[number].length}, {"mean_width", anatomy.parts[number].mean_width}};
}

/// What other canals lead through, too.
double shared_length(const Anatomy& anatomy, std::size_t canal) {
  double sum = 0;
  for (std::size_t p = 0; p < anatomy.parts.size(); ++p) {
    const std::vector<std::size_t>& canals = anatomy.graph.parts[p].canals;
    if (canals.size() > 1 && std::find(canals.begin(), canals.end(), canal) != canals.end()) sum += anatomy.parts[p].length;
  }
  return sum;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string made = "\"";
  for (const char c : text) made += c == '"' ? "\"\"" : std::string(1, c);
  return made + '"';
}

std::string csv_of(const std::optional<MeasuredPlace>& place) {
  return place ? fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},", place->width, place->at.x, place->at.y, place->at.z) : ",,,,";
}

std::string root_of(const Anatomy& anatomy, std::size_t canal) {
  for (std::size_t r = 0; r < anatomy.roots.size(); ++r)
    for (const std::size_t c : anatomy.roots[r].canals)
      if (c == canal) return fmt::format("{},{}", r + 1, anatomy.roots[r].vertucci);
  return ",";
}

}  // namespace

std::string anatomy_json(const Anatomy& anatomy, const std::string& source) {
  Json json{{"format", "odontoscope.anatomy"}, {"version", 1}, {"unit", "mm"}, {"source", source}};
  json["structures"] = Json::array();
  for (const MeasuredStructure& structure : anatomy.structures)
    json["structures"].push_back({{"name", structure.name}, {"volume", structure.volume}, {"outer_area", structure.area}});
  if (anatomy.cavity_of.empty()) {
    json["cavity"] = nullptr;
  } else {
    json["cavity"] = {{"structure", anatomy.cavity_of}, {"volume", anatomy.cavity_volume},   {"area", anatomy.cavity_area},
                      {"chamber_width", anatomy.chamber_width}, {"horns", anatomy.horns}, {"other_branches", anatomy.other_branches},
                      {"handles", anatomy.handles}};
    json["cavity"]["mouths"] = Json::array();
    for (const Cavity::Mouth& mouth : anatomy.mouths) json["cavity"]["mouths"].push_back({{"at", json_of(mouth.at)}, {"area", mouth.area}});
  }
  json["canals"] = Json::array();
  for (const MeasuredCanal& canal : anatomy.canals) json["canals"].push_back(json_of(canal));
  json["roots"] = Json::array();
  for (const MeasuredRoot& root : anatomy.roots) {
    Json names = Json::array();
    for (const std::size_t c : root.canals) names.push_back(anatomy.canals[c].name);
    json["roots"].push_back({{"canals", names}, {"sections", root.sections}, {"vertucci", root.vertucci}, {"uncounted_branches", root.uncounted}});
  }
  json["nodes"] = Json::array();
  for (std::size_t n = 0; n < anatomy.graph.nodes.size(); ++n) json["nodes"].push_back({{"kind", anatomy.graph.kind(n)}, {"at", json_of(anatomy.graph.nodes[n])}});
  json["parts"] = Json::array();
  for (std::size_t p = 0; p < anatomy.parts.size(); ++p) json["parts"].push_back(json_of(anatomy, p));
  return text_of(json);
}

std::string anatomy_csv(const Anatomy& anatomy) {
  std::string text =
      "canal,length_mm,schneider_deg,smallest_bend_radius_mm,mean_width_mm,narrowest_width_mm,narrowest_x,narrowest_y,narrowest_z,"
      "thinnest_wall_mm,thinnest_x,thinnest_y,thinnest_z,root,vertucci,shared_length_mm\r\n";
  for (std::size_t i = 0; i < anatomy.canals.size(); ++i) {
    const MeasuredCanal& canal = anatomy.canals[i];
    text += fmt::format("{},{:.4f},{:.2f},{},{:.4f},", quoted(canal.name), canal.length, canal.schneider_deg,
                        std::isfinite(canal.smallest_bend) ? fmt::format("{:.4f}", canal.smallest_bend) : "", canal.mean_width);
    text += csv_of(canal.narrowest) + csv_of(canal.thinnest_wall);
    text += fmt::format("{},{:.4f}\r\n", root_of(anatomy, i), shared_length(anatomy, i));
  }
  return text;
}

}  // namespace odontoscope
