#include "recon/output/anatomy_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recon/formats/json_values.h"

namespace odontoscope {
namespace {

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

constexpr const char* third_names[3] = {"coronal", "middle", "apical"};

Json json_of(const CanalShape& shape, const CanalUncertainty& off) {
  Json apical = Json::array(), thirds = Json::array();
  for (std::size_t i = 0; i < shape.apical.size(); ++i) {
    const ApicalSection& section = shape.apical[i];
    apical.push_back({{"from_apex", section.from_apex},
                      {"width", section.width},
                      {"area", section.area},
                      {"uncertainty", {{"width", off.apical_width[i]}, {"area", off.apical_area[i]}}}});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const CanalThird& third = shape.thirds[i];
    thirds.push_back({{"third", third_names[i]},
                      {"volume", third.volume},
                      {"area", third.area},
                      {"uncertainty", {{"volume", off.volume[i]}, {"area", off.area[i]}}}});
  }
  return {{"apical_sections", apical},
          {"thirds", thirds},
          {"structure_model_index", shape.structure_model_index ? Json(*shape.structure_model_index) : Json()}};
}

Json json_of(const MeasuredCanal& canal, const CanalUncertainty& off) {
  return {{"length", off.length},
          {"schneider_deg", off.schneider_deg},
          {"smallest_bend_radius", std::isfinite(canal.smallest_bend) ? Json(off.smallest_bend) : Json()},
          {"mean_width", off.mean_width},
          {"narrowest", canal.narrowest ? Json(off.narrowest) : Json()},
          {"thinnest_wall", canal.thinnest_wall ? Json(off.thinnest_wall) : Json()}};
}

Json json_of(const AccessoryCanal& one, const std::string& canal) {
  return {
      {"name", one.name},        {"canal", canal},       {"third", third_names[one.third]}, {"from", json_of(one.from)},
      {"end", json_of(one.end)}, {"length", one.length}, {"mean_width", one.mean_width}};
}

Json json_of(const Anatomy& anatomy, std::size_t number) {
  const CanalPart& part = anatomy.graph.parts[number];
  Json names = Json::array();
  for (const std::size_t c : part.canals) names.push_back(anatomy.canals[c].name);
  return {{"from", part.from},
          {"to", part.to},
          {"canals", names},
          {"length", anatomy.parts[number].length},
          {"mean_width", anatomy.parts[number].mean_width}};
}

/// What other canals lead through, too.
double shared_length(const Anatomy& anatomy, std::size_t canal) {
  double sum = 0;
  for (std::size_t p = 0; p < anatomy.parts.size(); ++p) {
    const std::vector<std::size_t>& canals = anatomy.graph.parts[p].canals;
    if (canals.size() > 1 && std::find(canals.begin(), canals.end(), canal) != canals.end())
      sum += anatomy.parts[p].length;
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
  return place ? fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},", place->width, place->at.x, place->at.y, place->at.z)
               : ",,,,";
}

std::string shape_columns(const Anatomy& anatomy, std::size_t canal) {
  const CanalShape& shape = anatomy.shapes[canal];
  std::string text;
  for (const CanalThird& third : shape.thirds) text += fmt::format("{:.4f},", third.volume);
  for (const CanalThird& third : shape.thirds) text += fmt::format("{:.4f},", third.area);
  text += shape.structure_model_index ? fmt::format("{:.4f},", *shape.structure_model_index) : ",";
  constexpr std::size_t sections = 4;
  for (std::size_t i = 0; i < sections; ++i)
    text += i < shape.apical.size() ? fmt::format("{:.4f},", shape.apical[i].width) : ",";
  for (std::size_t i = 0; i < sections; ++i)
    text += i < shape.apical.size() ? fmt::format("{:.4f},", shape.apical[i].area) : ",";
  const auto accessory = std::count_if(anatomy.accessory_canals.begin(), anatomy.accessory_canals.end(),
                                       [&](const AccessoryCanal& one) { return one.canal == canal; });
  return text + quoted(ahmed_code(anatomy.roots)) + fmt::format(",{},", accessory);
}

std::string uncertainty_columns(const Anatomy& anatomy, std::size_t number) {
  const MeasuredCanal& canal = anatomy.canals[number];
  const CanalUncertainty& off = anatomy.uncertainties[number];
  return fmt::format("{:.4f},{:.2f},{},{:.4f},{},{}", off.length, off.schneider_deg,
                     std::isfinite(canal.smallest_bend) ? fmt::format("{:.4f}", off.smallest_bend) : "", off.mean_width,
                     canal.narrowest ? fmt::format("{:.4f}", off.narrowest) : "",
                     canal.thinnest_wall ? fmt::format("{:.4f}", off.thinnest_wall) : "");
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
    json["structures"].push_back(
        {{"name", structure.name}, {"volume", structure.volume}, {"outer_area", structure.area}});
  if (anatomy.cavity_of.empty()) {
    json["cavity"] = nullptr;
  } else {
    json["cavity"] = {
        {"structure", anatomy.cavity_of},
        {"volume", anatomy.cavity_volume},
        {"area", anatomy.cavity_area},
        {"chamber_width", anatomy.chamber_width},
        {"horns", anatomy.horns},
        {"other_branches", anatomy.other_branches},
        {"handles", anatomy.handles},
        {"narrow_handles", anatomy.narrow_handles},
        {"loose_pieces",
         {{"count", anatomy.loose.count}, {"volume", anatomy.loose.volume}, {"largest", anatomy.loose.largest}}}};
    json["cavity"]["mouths"] = Json::array();
    for (const Cavity::Mouth& mouth : anatomy.mouths)
      json["cavity"]["mouths"].push_back({{"at", json_of(mouth.at)}, {"area", mouth.area}});
  }
  json["axis"] = {{"along", {anatomy.axis.along.x, anatomy.axis.along.y, anatomy.axis.along.z}},
                  {"tilt_deg", anatomy.axis.tilt_deg},
                  {"own", anatomy.axis.own}};
  json["openings"] = Json::array();
  for (const Opening& opening : anatomy.openings)
    json["openings"].push_back(
        {{"canal", anatomy.canals[opening.canal].name}, {"at", json_of(opening.at)}, {"reach", opening.reach}});
  json["canals"] = Json::array();
  for (std::size_t c = 0; c < anatomy.canals.size(); ++c) {
    Json canal = json_of(anatomy.canals[c]);
    canal.update(json_of(anatomy.shapes[c], anatomy.uncertainties[c]));
    canal["uncertainty"] = json_of(anatomy.canals[c], anatomy.uncertainties[c]);
    json["canals"].push_back(std::move(canal));
  }
  json["slice_spacing"] = anatomy.slice_spacing;
  json["accessory_canals"] = Json::array();
  for (const AccessoryCanal& one : anatomy.accessory_canals)
    json["accessory_canals"].push_back(json_of(one, anatomy.canals[one.canal].name));
  json["ahmed"] = ahmed_code(anatomy.roots);
  json["roots"] = Json::array();
  for (const MeasuredRoot& root : anatomy.roots) {
    Json names = Json::array();
    for (const std::size_t c : root.canals) names.push_back(anatomy.canals[c].name);
    Json isthmuses = Json::array();
    for (const Isthmus& one : root.isthmuses)
      isthmuses.push_back({{"type", one.type},
                           {"canals", {anatomy.canals[one.one].name, anatomy.canals[one.other].name}},
                           {"from_apex", {one.from_apex, one.to_apex}},
                           {"narrowest", one.narrowest}});
    json["roots"].push_back({{"canals", names},
                             {"isthmuses", isthmuses},
                             {"sections", root.sections},
                             {"vertucci", root.vertucci},
                             {"uncounted_branches", root.uncounted}});
  }
  json["nodes"] = Json::array();
  for (std::size_t n = 0; n < anatomy.graph.nodes.size(); ++n)
    json["nodes"].push_back({{"kind", anatomy.graph.kind(n)}, {"at", json_of(anatomy.graph.nodes[n])}});
  json["parts"] = Json::array();
  for (std::size_t p = 0; p < anatomy.parts.size(); ++p) json["parts"].push_back(json_of(anatomy, p));
  return text_of(json);
}

std::string anatomy_csv(const Anatomy& anatomy) {
  std::string text =
      "canal,length_mm,schneider_deg,smallest_bend_radius_mm,mean_width_mm,narrowest_width_mm,narrowest_x,narrowest_y,"
      "narrowest_z,"
      "thinnest_wall_mm,thinnest_x,thinnest_y,thinnest_z,root,vertucci,shared_length_mm,"
      "coronal_volume_mm3,middle_volume_mm3,apical_volume_mm3,coronal_area_mm2,middle_area_mm2,apical_area_mm2,"
      "structure_model_index,"
      "width_at_1_mm,width_at_2_mm,width_at_3_mm,width_at_4_mm,area_at_1_mm2,area_at_2_mm2,area_at_3_mm2,area_at_4_mm2,"
      "ahmed,accessory_canals,"
      "length_pm_mm,schneider_pm_deg,smallest_bend_radius_pm_mm,mean_width_pm_mm,narrowest_pm_mm,thinnest_wall_pm_"
      "mm\r\n";
  for (std::size_t i = 0; i < anatomy.canals.size(); ++i) {
    const MeasuredCanal& canal = anatomy.canals[i];
    text += fmt::format("{},{:.4f},{:.2f},{},{:.4f},", quoted(canal.name), canal.length, canal.schneider_deg,
                        std::isfinite(canal.smallest_bend) ? fmt::format("{:.4f}", canal.smallest_bend) : "",
                        canal.mean_width);
    text += csv_of(canal.narrowest) + csv_of(canal.thinnest_wall);
    text += fmt::format("{},{:.4f},", root_of(anatomy, i), shared_length(anatomy, i)) + shape_columns(anatomy, i) +
            uncertainty_columns(anatomy, i) + "\r\n";
  }
  return text;
}

}  // namespace odontoscope
