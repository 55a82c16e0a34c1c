#include "recon/input/stack_json.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/core/atomic_file.h"
#include "recon/core/limits.h"
#include "recon/input/counts.h"
#include "recon/input/strict_json.h"
#include "recon/input/structure_names.h"

namespace odontoscope {
namespace {

constexpr std::string_view format_name = "odontoscope.contours";
constexpr int format_version = 1;

// --- reading -----------------------------------------------------------------------------------------------------

enum Node {
  document,
  format,
  version,
  unit,
  slices,
  slice,
  height,
  contours,
  contour,
  structure,
  points,
  point,
  coordinate
};

using Shape = JsonNode::Shape;
constexpr JsonNode::Key document_keys[] = {
    {"format", format, true}, {"version", version, true}, {"unit", unit, true}, {"slices", slices, true}};
constexpr JsonNode::Key slice_keys[] = {{"z", height, true}, {"contours", contours, true}};
constexpr JsonNode::Key contour_keys[] = {{"structure", structure, false}, {"points", points, true}};
constexpr JsonNode nodes[] = {
    {Shape::object, "a contour stack", -1, document_keys},
    {Shape::text, "\"format\""},
    {Shape::number, "\"version\""},
    {Shape::text, "\"unit\""},
    {Shape::array, "\"slices\"", slice},
    {Shape::object, "a slice", -1, slice_keys},
    {Shape::number, "\"z\""},
    {Shape::array, "\"contours\"", contour},
    {Shape::object, "a contour", -1, contour_keys},
    {Shape::text, "\"structure\""},
    {Shape::array, "\"points\"", point},
    {Shape::array, "a point", coordinate},
    {Shape::number, "a coordinate"},
};

/// A file's unit in millimetres is `times` / `over`: exact factors, so that a value is rounded once.
struct Unit {
  std::string_view name;
  double times, over;
};
constexpr Unit units[] = {{"mm", 1, 1},         {"um", 1, 1000}, {"\u00b5m", 1, 1000},
                          {"\u03bcm", 1, 1000}, {"cm", 10, 1},   {"m", 1000, 1}};

class StackReader final : public StrictJson {
 public:
  StackReader() : StrictJson(nodes) {}

  ContourStack read_stack(JsonSource& source) {
    stack_.source = source.name();
    read(source);
    return std::move(stack_);
  }

 private:
  void opened(int node) override;
  void closed(int node) override;
  void number(int node, double value) override;
  void text(int node, const std::string& value) override;
  void add_place(Place& place) const override;
  void to_millimetres();
  Place whole() const;
  Contour& last_contour() { return stack_.slices.back().contours.back(); }

  ContourStack stack_;
  Unit unit_ = units[0];
  bool in_slice_ = false, in_contour_ = false, in_point_ = false, has_height_ = false;
  std::size_t contours_ = 0, points_ = 0;  // of the whole stack
  std::array<double, 2> coordinates_{};
  std::size_t coordinate_ = 0;
};

void StackReader::opened(int node) {
  if (node == slice) {
    check_slice_count(stack_.slices.size() + 1, whole());
    stack_.slices.emplace_back();
    in_slice_ = true;
    has_height_ = false;
  } else if (node == contour) {
    std::vector<Contour>& in_slice = stack_.slices.back().contours;
    check_contours_in_slice(in_slice.size() + 1, place());
    check_contour_count(++contours_, whole());
    in_slice.emplace_back();
    in_contour_ = true;
  } else if (node == point) {
    in_point_ = true;
    coordinate_ = 0;
  }
}

void StackReader::closed(int node) {
  if (node == document) {
    to_millimetres();
  } else if (node == slice) {
    stack_.slices.back().contours.shrink_to_fit();
    in_slice_ = false;
  } else if (node == contour) {
    in_contour_ = false;
  } else if (node == points) {
    last_contour().points.shrink_to_fit();
  } else if (node == point) {
    if (coordinate_ != coordinates_.size()) {
      refuse("wrong-type", fmt::format("a point has two coordinates, this one {}", coordinate_), "Write [x, y]");
    }
    check_point_count(++points_, whole());
    last_contour().points.push_back({coordinates_[0], coordinates_[1]});
    in_point_ = false;
  }
}

void StackReader::number(int node, double value) {
  if (node == version) {
    if (value == format_version) return;
    refuse("wrong-version",
           fmt::format("version {} of the format, but this program reads version {}", value, format_version),
           "Write the file anew with a matching program");
  }
  if (node == height) {
    stack_.slices.back().z = value;
    has_height_ = true;
    return;
  }
  if (coordinate_ == coordinates_.size()) {
    refuse("wrong-type", "a point has two coordinates, this one more", "Write [x, y]; z belongs to the slice");
  }
  coordinates_[coordinate_++] = value;
}

void StackReader::text(int node, const std::string& value) {
  if (node == structure) {
    check_structure_name(value, place());
    last_contour().structure = value;
  } else if (node == format) {
    if (value == format_name) return;
    refuse("wrong-format", fmt::format("the format is {}, not \"{}\"", in_quotes(value), format_name),
           "Check that this is the file you mean");
  } else if (node == unit) {
    for (const Unit& known : units) {
      if (known.name == value) {
        unit_ = known;
        return;
      }
    }
    refuse("wrong-unit", fmt::format("the unit {} is not known", in_quotes(value)),
           "Use \"mm\", \"um\", \"cm\" or \"m\"");
  }
}

void StackReader::add_place(Place& place) const {
  if (!in_slice_) return;
  place.slice = stack_.slices.size() - 1;
  const Slice& at_hand = stack_.slices.back();
  if (has_height_) place.z = at_hand.z;
  if (!in_contour_) return;
  place.contour = at_hand.contours.size() - 1;
  if (in_point_) place.point = at_hand.contours.back().points.size();
}

/// At the end, since "unit" may come after "slices".
void StackReader::to_millimetres() {
  Place place = whole();
  const auto convert = [&](double& value, const char* what) {
    const double millimetres = value * unit_.times / unit_.over;
    if (!(std::abs(millimetres) <= limits::largest_coordinate)) {
      throw InputError("too-large", place,
                       fmt::format("{} = {} {} lies beyond {} mm", what, value, unit_.name, limits::largest_coordinate),
                       "Check the unit");
    }
    value = millimetres;
  };
  for (std::size_t s = 0; s < stack_.slices.size(); ++s) {
    Slice& at_hand = stack_.slices[s];
    place.slice = s;
    convert(at_hand.z, "z");
    for (std::size_t c = 0; c < at_hand.contours.size(); ++c) {
      std::vector<Point2>& in_contour = at_hand.contours[c].points;
      place.contour = c;
      for (std::size_t p = 0; p < in_contour.size(); ++p) {
        place.point = p;
        convert(in_contour[p].x, "x");
        convert(in_contour[p].y, "y");
      }
      place.point.reset();
    }
    place.contour.reset();
  }
}

Place StackReader::whole() const {
  Place place;
  place.file = stack_.source;
  return place;
}

// --- writing -----------------------------------------------------------------------------------------------------

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  const double without_minus_zero = value + 0.0;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), without_minus_zero).ptr;
  text.append(digits.data(), end);
}

void append(std::string& text, const Contour& contour) {
  text += "{\"structure\":";
  text += nlohmann::json(contour.structure).dump();
  text += ",\"points\":[";
  const char* separator = "";
  for (const Point2& p : contour.points) {
    text += separator;
    text += '[';
    append(text, p.x);
    text += ',';
    append(text, p.y);
    text += ']';
    separator = ",";
  }
  text += "]}";
}

/// Hands the text to `take` slice by slice, so that a large stack need not lie in memory twice.
template <class Take>
void write_json(const ContourStack& stack, Take take) {
  take(fmt::format("{{\"format\":\"{}\",\"version\":{},\"unit\":\"mm\",\"slices\":[", format_name, format_version));
  std::string text;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    text = s == 0 ? "\n{\"z\":" : ",\n{\"z\":";
    append(text, stack.slices[s].z);
    text += ",\"contours\":[";
    const char* separator = "\n ";
    for (const Contour& contour : stack.slices[s].contours) {
      text += separator;
      append(text, contour);
      separator = ",\n ";
    }
    text += "]}";
    take(text);
  }
  take("\n]}\n");
}

}  // namespace

ContourStack read_stack(const std::string& file, std::stop_token stop) {
  JsonSource source = JsonSource::from_file(file, std::move(stop));
  return StackReader().read_stack(source);
}

ContourStack parse_stack(std::string_view bytes, std::string name) {
  JsonSource source = JsonSource::from_bytes(bytes, std::move(name));
  return StackReader().read_stack(source);
}

std::string to_json(const ContourStack& stack) {
  std::string text;
  write_json(stack, [&text](std::string_view part) { text += part; });
  return text;
}

void write_stack(const ContourStack& stack, const std::string& file) {
  AtomicFile out(file);
  write_json(stack, [&out](std::string_view part) { out.write(part); });
  out.commit();
}

}  // namespace odontoscope
