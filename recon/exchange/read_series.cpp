#include "recon/exchange/read_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <utility>

#include "recon/core/limits.h"
#include "recon/core/read_file.h"
#include "recon/exchange/limits.h"
#include "recon/formats/parsing.h"
#include "recon/input/counts.h"
#include "recon/input/structure_names.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;
using namespace parsing;

constexpr std::size_t coefficients = 6;  // of 1, x, y, xy, x^2, y^2

/// An XML file; messages name the line of what is wrong.
class Document {
 public:
  Document(std::string_view bytes, const std::string& file, const char* root) : bytes_(bytes), file_(file) {
    if (bytes.size() > limits::xml_bytes) {
      parsing::refuse("file-too-large", whole(), fmt::format("the file has more than {} MiB", limits::xml_bytes >> 20),
                      "Split it");
    }
    const auto opens = [](char c) { return c == '<' || c == '='; };
    if (static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), opens)) > limits::xml_parts) {
      parsing::refuse("file-too-large", whole(),
                      fmt::format("the file has more than {} elements and attributes", limits::xml_parts), "Split it");
    }
    // No document type is looked into, and no entity of its own expanded.
    const pugi::xml_parse_result result = document_.load_buffer(
        bytes.data(), bytes.size(), pugi::parse_minimal | pugi::parse_escapes, pugi::encoding_utf8);
    if (!result) refuse("unparsable", result.offset, fmt::format("this is no XML: {}", result.description()));
    root_ = document_.document_element();
    if (std::string_view(root_.name()) != root) {
      refuse("wrong-type", root_, fmt::format("the root is \"{}\", not \"{}\"", tame(root_.name()), root));
    }
  }

  pugi::xml_node root() const { return root_; }

  std::string_view text(pugi::xml_node node, const char* name) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) refuse("missing-key", node, fmt::format("a {} has no \"{}\"", tame(node.name()), name));
    return attribute.value();
  }
  double number(pugi::xml_node node, const char* name) const {
    const std::vector<double> values = numbers(node, name);
    if (values.size() != 1) refuse("unparsable", node, fmt::format("\"{}\" is not one number", name));
    return values[0];
  }
  /// Separated by blanks or commas.
  std::vector<double> numbers(pugi::xml_node node, const char* name) const {
    std::vector<double> values;
    std::string_view list = text(node, name);
    constexpr std::string_view separators = " \t\r\n,";
    for (;;) {
      list.remove_prefix(std::min(list.find_first_not_of(separators), list.size()));
      if (list.empty()) return values;
      const std::string_view word = list.substr(0, list.find_first_of(separators));
      double value = 0;
      if (!parse_number(word, value)) {
        refuse("unparsable", node,
               fmt::format("\"{}\" in \"{}\" is no number", tame(word.substr(0, limits::quoted_length)), name));
      }
      if (!std::isfinite(value)) refuse("not-finite", node, fmt::format("\"{}\" holds NaN or infinity", name));
      values.push_back(value);
      list.remove_prefix(word.size());
    }
  }

  Place place(pugi::xml_node node) const { return place(node.offset_debug()); }
  [[noreturn]] void refuse(std::string_view cause, pugi::xml_node node, std::string_view wrong) const {
    refuse(cause, node.offset_debug(), wrong);
  }

 private:
  Place whole() const {
    Place place;
    place.file = file_;
    return place;
  }
  Place place(std::ptrdiff_t offset) const {
    const std::size_t end = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), bytes_.size());
    if (end < counted_) counted_ = counted_ends_ = 0;
    const std::string_view more = bytes_.substr(counted_, end - counted_);
    counted_ends_ += static_cast<std::size_t>(std::count(more.begin(), more.end(), '\n'));
    counted_ = end;
    return at_line(file_, 1 + counted_ends_);
  }
  [[noreturn]] void refuse(std::string_view cause, std::ptrdiff_t offset, std::string_view wrong) const {
    parsing::refuse(cause, place(offset), wrong, "Save the series again with Reconstruct");
  }

  std::string_view bytes_;
  const std::string& file_;
  mutable std::size_t counted_ = 0,
                      counted_ends_ = 0;  // bytes in which ends of line were counted: places come mostly in order
  pugi::xml_document document_;
  pugi::xml_node root_;
};

/// (u, v) = polynomials of (x, y); from (u, v) back to (x, y).
class Transform {
 public:
  Transform(const Document& document, pugi::xml_node node) {
    const double dimension = document.number(node, "dim");
    if (dimension != std::floor(dimension) || dimension < 0 || dimension > coefficients) {
      document.refuse("bad-transform", node, fmt::format("a transform of dimension {}", dimension));
    }
    // 1: a shift; 2 and 3: with the linear part; from 4 on one term more each.
    const auto used = dimension == 2 ? std::size_t{3} : static_cast<std::size_t>(dimension);
    read(document, node, "xcoef", used, a_);
    read(document, node, "ycoef", used, b_);
    if (used < 2) a_[1] = b_[2] = 1;
  }

  /// False where there is no inverse.
  bool invert(double u, double v, Point2& place) const {
    double x = u, y = v;
    const double size = 1 + std::abs(u) + std::abs(v);
    for (int step = 0; step < limits::transform_steps; ++step) {
      const double du = u - value(a_, x, y), dv = v - value(b_, x, y);
      if (std::abs(du) + std::abs(dv) <= limits::transform_rest * size) {
        place = {x, y};
        return true;
      }
      const double ux = a_[1] + a_[3] * y + 2 * a_[4] * x, uy = a_[2] + a_[3] * x + 2 * a_[5] * y;
      const double vx = b_[1] + b_[3] * y + 2 * b_[4] * x, vy = b_[2] + b_[3] * x + 2 * b_[5] * y;
      const double determinant = ux * vy - uy * vx;
      x += (vy * du - uy * dv) / determinant;
      y += (ux * dv - vx * du) / determinant;
      if (!std::isfinite(x) || !std::isfinite(y)) return false;
    }
    return false;
  }

 private:
  using Terms = std::array<double, coefficients>;
  static void read(const Document& document, pugi::xml_node node, const char* name, std::size_t used, Terms& terms) {
    const std::vector<double> values = document.numbers(node, name);
    if (values.size() != coefficients) {
      document.refuse("bad-transform", node,
                      fmt::format("\"{}\" has {} numbers, not {}", name, values.size(), coefficients));
    }
    std::copy_n(values.begin(), used, terms.begin());
  }
  static double value(const Terms& c, double x, double y) {
    return c[0] + c[1] * x + c[2] * y + c[3] * x * y + c[4] * x * x + c[5] * y * y;
  }
  Terms a_{}, b_{};
};

Contour contour_in(const Document& document, pugi::xml_node node, const Transform& transform) {
  Contour contour;
  contour.structure = document.text(node, "name");
  check_structure_name(contour.structure, document.place(node));
  const std::vector<double> numbers = document.numbers(node, "points");
  if (numbers.size() % 2 != 0) document.refuse("unparsable", node, "the last point has one coordinate");
  check_point_count(numbers.size() / 2, document.place(node));
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    Point2 point;
    if (!transform.invert(numbers[i], numbers[i + 1], point)) {
      document.refuse("bad-transform", node,
                      fmt::format("the transform leads nowhere to ({}, {}), a point of {}", numbers[i], numbers[i + 1],
                                  in_quotes(contour.structure)));
    }
    contour.points.push_back(point);
  }
  return contour;
}

double millimetres(const Document& document, std::string_view unit) {
  constexpr std::pair<std::string_view, double> units[] = {{"microns", 1e-3}, {"um", 1e-3}, {"nm", 1e-6},
                                                           {"mm", 1},         {"cm", 10},   {"m", 1000}};
  for (const auto& [name, length] : units) {
    if (unit == name) return length;
  }
  document.refuse("wrong-unit", document.root(), fmt::format("the unit {} is not known", in_quotes(unit)));
}

/// Files NAME.1, NAME.2 ... beside NAME.ser, by number.
std::map<long, std::string> section_files(const std::string& file) {
  const fs::path series(file);
  const fs::path folder = series.parent_path().empty() ? fs::path(".") : series.parent_path();
  const std::string stem = series.stem().string() + ".";
  std::map<long, std::string> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(stem)) continue;
    long number = -1;
    const char* last = name.data() + name.size();
    const auto [read, failed] = std::from_chars(name.data() + stem.size(), last, number);
    if (failed != std::errc() || read != last || number < 0) continue;
    files[number] = (series.parent_path() / name).string();
    Place place;
    place.file = file;
    check_slice_count(files.size(), place);
  }
  if (error) throw FileError(folder.string(), "cannot be listed: " + error.message(), "Check its permissions");
  return files;
}

}  // namespace

bool looks_like_series(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096;
  bytes = bytes.substr(0, looked_at);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != bytes.npos && bytes[first] == '<' && bytes.find("<Series") != bytes.npos;
}

SeriesHeader parse_series_header(std::string_view bytes, const std::string& file) {
  const Document document(bytes, file, "Series");
  SeriesHeader header;
  header.millimetres = millimetres(document, document.text(document.root(), "units"));
  header.default_thickness = document.number(document.root(), "defaultThickness");
  header.middle = std::string_view(document.root().attribute("zMidSection").value()) == "true";
  return header;
}

SeriesSection parse_series_section(std::string_view bytes, const std::string& file) {
  const Document document(bytes, file, "Section");
  SeriesSection section;
  const double index = document.number(document.root(), "index");
  if (index != std::floor(index) || std::abs(index) > 1e9)
    document.refuse("unparsable", document.root(), "\"index\" is no whole number");
  section.index = static_cast<long>(index);
  section.thickness = document.number(document.root(), "thickness");
  if (!(section.thickness > 0))
    document.refuse("repeated-z", document.root(), "the section has no thickness, so that two lie at one height");
  std::size_t points = 0;
  for (const pugi::xml_node group : document.root().children("Transform")) {
    const Transform transform(document, group);
    const bool frame = static_cast<bool>(group.child("Image"));
    for (const pugi::xml_node node : group.children("Contour")) {
      if (frame) {
        ++section.frames;
      } else if (document.text(node, "closed") != "true") {
        ++section.open;
      } else {
        section.contours.push_back(contour_in(document, node, transform));
        check_contours_in_slice(section.contours.size(), document.place(node));
        check_point_count(points += section.contours.back().points.size(), document.place(node));
      }
    }
  }
  return section;
}

FileContours read_series(std::string_view bytes, const std::string& file) {
  const SeriesHeader header = parse_series_header(bytes, file);
  FileContours result;
  result.stack.source = file;
  Place whole;
  whole.file = file;
  double height = 0;
  std::size_t open = 0, contours = 0, points = 0;
  long next = 0;
  for (const auto& [number, name] : section_files(file)) {
    SeriesSection section = parse_series_section(read_file(name, limits::xml_bytes), name);
    if (section.index != number) {
      Place place;
      place.file = name;
      refuse("wrong-section", place, fmt::format("the file says that it is section {}", section.index),
             "Give each file its section's number as ending");
    }
    if (!result.stack.slices.empty() && number != next) {
      result.remarks.push_back(fmt::format("sections {} to {} are missing; their thickness was taken as {} each", next,
                                           number - 1, header.default_thickness));
      height += static_cast<double>(number - next) * header.default_thickness;
    }
    next = number + 1;
    Slice slice{(height + (header.middle ? section.thickness / 2 : 0)) * header.millimetres,
                std::move(section.contours)};
    height += section.thickness;
    open += section.open;
    check_contour_count(contours += slice.contours.size(), whole);
    Place place = whole;
    place.slice = result.stack.slices.size();
    check_magnitude(slice.z, "z", place);
    for (Contour& contour : slice.contours) {
      check_point_count(points += contour.points.size(), whole);
      for (Point2& p : contour.points) {
        p = {p.x * header.millimetres, p.y * header.millimetres};
        check_magnitude(p.x, "x", place);
        check_magnitude(p.y, "y", place);
      }
    }
    result.stack.slices.push_back(std::move(slice));
  }
  if (result.stack.slices.empty()) {
    refuse("no-sections", whole, "no file of a section is there", "Put the files NAME.1, NAME.2 ... beside it");
  }
  if (open > 0) result.remarks.push_back(fmt::format("{} open traces were left out", open));
  return result;
}

}  // namespace odontoscope
