#include "engine/web/page.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "engine/web/gzip.h"
#include "recon/core/base64.h"
#include "recon/core/error.h"
#include "recon/output/html_report.h"

namespace odontoscope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view title_place = "<!--odontoscope:title-->", data_place = "<!--odontoscope:data-->";

std::string element_id(std::size_t model) { return fmt::format("model-{}", model); }

Json json_of(const WebCertificate& certificate) {
  Json findings = Json::array();
  for (const WebCertificate::Finding& finding : certificate.findings) {
    findings.push_back({{"mark", finding.mark}, {"words", finding.words}});
    if (finding.at_mm) findings.back()["at_mm"] = {finding.at_mm->x, finding.at_mm->y, finding.at_mm->z};
  }
  return {{"verdict", certificate.verdict}, {"headline", certificate.headline}, {"findings", findings}};
}

/// A flight of a minute has a thousand keys: no more digits than an eye could tell, in whole numbers, each as its
/// difference from where the two before it lead, so that most have a digit or two. way.js adds them up again.
constexpr double finest = 3e-5;  // mm, or of a unit vector

template <class Value>
Json in_steps(const std::vector<CameraKey>& keys, Value value) {
  Json steps = Json::array();
  std::int64_t before = 0, step = 0;
  for (const CameraKey& key : keys) {
    const std::int64_t now = std::llround(value(key) / finest);
    steps.push_back(now - before - step);
    step = now - before;
    before = now;
  }
  return steps;
}

Json json_of(const std::vector<CameraKey>& keys) {
  const auto triple = [&](auto vector) {
    return Json{in_steps(keys, [&](const CameraKey& key) { return vector(key).x; }),
                in_steps(keys, [&](const CameraKey& key) { return vector(key).y; }),
                in_steps(keys, [&](const CameraKey& key) { return vector(key).z; })};
  };
  return {{"seconds", keys.back().seconds},
          {"finest", finest},
          {"along_mm", in_steps(keys, [](const CameraKey& key) { return key.along; })},
          {"at_mm", triple([](const CameraKey& key) { return key.at; })},
          {"view_direction", triple([](const CameraKey& key) { return key.view_direction; })},
          {"up", triple([](const CameraKey& key) { return key.up; })}};
}

Json json_of(const WebTour& tour) {
  Json points = Json::array();
  for (const Point3& p : tour.points) points.push_back({p.x, p.y, p.z});
  Json json = {{"name", tour.name},
               {"length_mm", tour.length_mm},
               {"orifice_mm", tour.orifice_mm ? Json(*tour.orifice_mm) : Json()},
               {"points_mm", points}};
  if (!tour.keys.empty()) json["keys"] = json_of(tour.keys);
  return json;
}

/// Neighbours are much alike: their differences, modulo 256, take a fifth less room than they themselves.
std::string packed(const WebVolume& volume) {
  std::string differences;
  differences.reserve(volume.bytes.size());
  unsigned char before = 0;
  for (const char byte : volume.bytes) {
    const auto value = static_cast<unsigned char>(byte);
    differences.push_back(static_cast<char>(static_cast<unsigned char>(value - before)));
    before = value;
  }
  return base64(gzip(differences));
}

Json json_of(const WebVolume& volume) {
  const auto triple = [](const Point3& p) { return Json::array({p.x, p.y, p.z}); };
  Json transfers = Json::object(), isos = Json::array();
  for (const WebIso& iso : volume.isos) isos.push_back({{"structure", iso.structure}, {"value", iso.value}});
  for (const auto& [name, points] : volume.transfers) transfers[name] = Json::parse(points);
  return {{"element", "volume"},
          {"size", volume.size},
          {"first_mm", triple(volume.first_mm)},
          {"step_mm", triple(volume.step_mm)},
          {"low", volume.low},
          {"high", volume.high},
          {"air", volume.air},
          {"dentine", volume.dentine},
          {"dentine_attenuation", volume.dentine_attenuation},
          {"isos", isos},
          {"bars", volume.bars},
          {"look", Json::parse(volume.look)},
          {"transfers", transfers},
          {"alone", volume.alone}};
}

Json description_of(const WebPage& page) {
  Json models = Json::array(), looks = Json::array(), tours = Json::array();
  for (std::size_t i = 0; i < page.models.size(); ++i) {
    const WebModel& model = page.models[i];
    models.push_back({{"name", model.name},
                      {"words", model.words},
                      {"element", element_id(i)},
                      {"triangles", model.triangles},
                      {"certificate", json_of(model.certificate)}});
  }
  for (const WebLook& look : page.looks) {
    looks.push_back({{"structure", look.structure},
                     {"colour", look.colour},
                     {"opacity", look.opacity},
                     {"as_body", look.as_body},
                     {"depth", look.depth}});
    if (look.attenuation) looks.back()["attenuation"] = *look.attenuation;
  }
  for (const WebTour& tour : page.tours) tours.push_back(json_of(tour));
  Json horns = Json::array();
  for (const WebTour& horn : page.horns) horns.push_back(json_of(horn));
  Json description{{"title", page.title}, {"models", models}, {"looks", looks}, {"tours", tours}, {"horns", horns}};
  if (!page.tooth.empty()) description["tooth"] = page.tooth;
  if (page.volume) description["volume"] = json_of(*page.volume);
  return description;
}

/// JSON that no parser of HTML takes for anything but text, whatever its strings hold. Text that is no UTF-8 is
/// replaced.
std::string text_in_script(const Json& json) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) {
    if (c == '<' || c == '>' || c == '&')
      safe += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      safe += c;
  }
  return safe;
}

std::string data_elements(const WebPage& page) {
  std::string html = fmt::format("<script type=\"application/json\" id=\"description\">{}</script>\n",
                                 text_in_script(description_of(page)));
  if (!page.lesson.empty())
    html += fmt::format("<script type=\"application/json\" id=\"tour\"{}>{}</script>\n",
                        page.lesson_built_in ? " data-built-in" : "", text_in_script(Json::parse(page.lesson)));
  if (!page.language.empty())
    html += fmt::format("<script type=\"application/json\" id=\"language\">{}</script>\n",
                        text_in_script(Json::parse(page.language)));
  for (std::size_t i = 0; i < page.models.size(); ++i)
    html += fmt::format("<script type=\"application/gzip\" id=\"{}\">{}</script>\n", element_id(i),
                        base64(gzip(page.models[i].glb)));
  if (page.volume)
    html += fmt::format("<script type=\"application/gzip\" id=\"volume\">{}</script>\n", packed(*page.volume));
  return html;
}

}  // namespace

std::size_t packed_size(const WebVolume& volume) { return packed(volume).size(); }

std::string web_page(const WebPage& page, std::string_view shell) {
  const std::size_t title = shell.find(title_place), data = shell.find(data_place);
  if (title == shell.npos || data == shell.npos || data < title)
    throw InternalError("the web page has no place for a title and a model");
  std::string html(shell.substr(0, title));
  html += escaped_html(page.title);
  html += shell.substr(title + title_place.size(), data - title - title_place.size());
  html += data_elements(page);
  html += shell.substr(data + data_place.size());
  return html;
}

}  // namespace odontoscope
