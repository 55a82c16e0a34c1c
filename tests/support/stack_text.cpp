#include "tests/support/stack_text.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace odontoscope::test {

using nlohmann::json;

std::string to_text(const ContourStack& stack) {
  json slices = json::array();
  for (const Slice& slice : stack.slices) {
    json contours = json::array();
    for (const Contour& contour : slice.contours) {
      json points = json::array();
      for (Point2 p : contour.points) points.push_back({p.x, p.y});
      contours.push_back({{"structure", contour.structure}, {"points", points}});
    }
    slices.push_back({{"z", slice.z}, {"contours", contours}});
  }
  return json{{"format", "odontoscope.contours"}, {"version", 1}, {"unit", "mm"}, {"slices", slices}}.dump();
}

std::string to_text(const std::vector<Link>& links) {
  json list = json::array();
  for (const Link& link : links)
    list.push_back({{"structure", link.structure},
                    {"slice", link.slice},
                    {"lower", link.lower},
                    {"upper", link.upper},
                    {"connect", link.connect}});
  return json{{"format", "odontoscope.links"}, {"version", 1}, {"links", list}}.dump();
}

ContourStack from_text(const std::string& text) {
  ContourStack stack;
  const json document = json::parse(text);
  for (const json& from : document.at("slices")) {
    Slice slice{from.at("z").get<double>(), {}};
    for (const json& ring : from.at("contours")) {
      Contour contour{ring.value("structure", "tooth"), {}};
      for (const json& p : ring.at("points")) contour.points.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
      slice.contours.push_back(contour);
    }
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack read_stack_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path);
  std::ostringstream text;
  text << file.rdbuf();
  ContourStack stack = from_text(text.str());
  stack.source = path;
  return stack;
}

}  // namespace odontoscope::test
