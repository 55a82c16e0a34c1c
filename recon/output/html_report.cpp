#include "recon/output/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "assets/theme.h"
#include "recon/core/embedded_file.h"
#include "recon/core/error.h"

namespace odontoscope {

std::span<const EmbeddedFile> report_files();  // assets/reports, made part of the program

namespace {

std::string filled(std::string_view text, std::string_view name, const PagePlaces& places) {
  std::string result;
  std::size_t filled_places = 0;
  while (true) {
    const std::size_t begin = text.find("{{"), end = begin == text.npos ? text.npos : text.find("}}", begin);
    result += text.substr(0, begin);
    if (end == text.npos) break;
    const std::string_view place = text.substr(begin + 2, end - begin - 2);
    const auto said = std::find_if(places.begin(), places.end(), [&](const auto& one) { return one.first == place; });
    if (said == places.end()) throw InternalError(fmt::format("nothing is said of {} in {}", place, name));
    result += said->second;
    ++filled_places;
    text.remove_prefix(end + 2);
  }
  if (filled_places < places.size()) throw InternalError(fmt::format("{} has no place for all that is said", name));
  return result;
}

std::string shared_style() {
  namespace colours = assets::theme::report;
  return filled(report_file("report.css"), "report.css",
                {{"ink", hex_colour(colours::ink)},
                 {"paper", hex_colour(colours::paper)},
                 {"quiet", hex_colour(colours::quiet)},
                 {"line", hex_colour(colours::line)},
                 {"number", hex_colour(colours::number)},
                 {"hovered", hex_colour(colours::hovered)}});
}

}  // namespace

std::string_view report_file(std::string_view name) {
  for (const EmbeddedFile& file : report_files())
    if (file.name == name) return file.bytes;
  throw InternalError(fmt::format("there is no report {}", name));
}

std::string html_report(std::string_view name, const PagePlaces& places) {
  PagePlaces all = places;
  all.emplace_back("style", shared_style());
  return filled(report_file(name), name, all);
}

std::string hex_colour(unsigned rgb) { return fmt::format("#{:06x}", rgb); }

std::string escaped_html(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace odontoscope
