#include "recon/exchange/read_jser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "recon/core/limits.h"
#include "recon/exchange/limits.h"
#include "recon/formats/parsing.h"
#include "recon/input/counts.h"

namespace odontoscope {
namespace {

using nlohmann::json;
using parsing::refuse;

constexpr double millimetres_per_micrometre = 1e-3;
using Affine = std::array<double, 6>;

class JserReader {
 public:
  explicit JserReader(const std::string& file) { whole_.file = file; }

  FileContours read(const json& document) {
    result_.stack.source = whole_.file;
    const json& series = member(document, "series", json::value_t::object);
    const auto alignment = series.find("alignment");
    if (alignment != series.end()) {
      if (!alignment->is_string()) refuse("wrong-type", whole_, "\"alignment\" is no text");
      alignment_ = alignment->get<std::string>();
    }
    const json& sections = member(document, "sections", json::value_t::array);
    std::size_t missing = 0;
    for (number_ = 0; number_ < sections.size(); ++number_) {
      if (sections[number_].is_null()) {
        missing += !result_.stack.slices.empty();
        continue;
      }
      height_ += static_cast<double>(std::exchange(missing, 0)) * thickness_;
      add_section(sections[number_]);
    }
    if (result_.stack.slices.empty())
      refuse("no-sections", whole_, "it has no section", "Check that it is the file you mean");
    tell();
    return std::move(result_);
  }

 private:
  const json& member(const json& object, const char* key, json::value_t type) const {
    if (!object.is_object()) refuse("wrong-type", place(), "an object was expected");
    const auto found = object.find(key);
    if (found == object.end())
      refuse("missing-key", place(), fmt::format("there is no \"{}\"", key), "Save it again with PyReconstruct");
    if (found->type() != type) refuse("wrong-type", place(), fmt::format("\"{}\" has another type than expected", key));
    return *found;
  }

  Place place() const {
    Place place = whole_;
    if (in_section_) place.slice = result_.stack.slices.size();
    return place;
  }

  double number(const json& value, const char* what) const {
    if (!value.is_number()) refuse("wrong-type", place(), fmt::format("{} is no number", what));
    const double number = value.get<double>();
    check_magnitude(number, what, place());
    return number;
  }

  void add_section(const json& section) {
    in_section_ = true;
    if (!section.is_object()) refuse("wrong-type", place(), fmt::format("section {} is no object", number_));
    const auto thickness = section.find("thickness");
    if (thickness == section.end())
      refuse("missing-key", place(), fmt::format("section {} has no \"thickness\"", number_));
    const double above = number(*thickness, "thickness");
    if (!(above > 0))
      refuse("repeated-z", place(), fmt::format("section {} has no thickness, so that two lie at one height", number_));
    if (number_ > 0 && !result_.stack.slices.empty() && number_ != last_ + 1) gaps_ += number_ - last_ - 1;
    check_slice_count(result_.stack.slices.size() + 1, place());
    Slice slice{height_ * millimetres_per_micrometre, {}};
    check_magnitude(slice.z, "z", place());
    const Affine transform = transform_of(section);
    const auto contours = section.find("contours");
    if (contours != section.end()) {
      if (!contours->is_object()) refuse("wrong-type", place(), "\"contours\" is no object");
      for (const auto& [name, traces] : contours->items()) {
        if (!traces.is_array()) refuse("wrong-type", place(), "the traces of a contour are no list");
        for (const json& trace : traces) add_trace(name, trace, transform, slice);
      }
    }
    result_.stack.slices.push_back(std::move(slice));
    thickness_ = above;
    height_ += above;
    last_ = number_;
    in_section_ = false;
  }

  Affine transform_of(const json& section) const {
    if (alignment_ == "no-alignment") return {1, 0, 0, 0, 1, 0};
    const auto all = section.find("tforms");
    if (all == section.end() && alignment_ == "default") return {1, 0, 0, 0, 1, 0};
    if (all == section.end() || !all->is_object() || !all->contains(alignment_)) {
      refuse("missing-key", place(),
             fmt::format("section {} has no transform for the alignment \"{}\"", number_,
                         parsing::tame(alignment_.substr(0, limits::quoted_length))),
             "Choose another alignment in PyReconstruct and save");
    }
    const json& numbers = (*all)[alignment_];
    if (!numbers.is_array() || numbers.size() != 6) refuse("wrong-type", place(), "a transform has six numbers");
    Affine transform{};
    for (std::size_t i = 0; i < 6; ++i) transform[i] = number(numbers[i], "a transform's number");
    if (transform[0] * transform[4] == transform[1] * transform[3])
      refuse("bad-transform", place(), "a transform has no inverse");
    return transform;
  }

  void add_trace(const std::string& name, const json& trace, const Affine& transform, Slice& slice) {
    // Eight values; nine where the name comes first, or a history last.
    constexpr std::size_t values = 8;
    const bool list = trace.is_array();
    const std::size_t first = list && !trace.empty() && trace[0].is_string() ? 1 : 0;
    if (list ? trace.size() < first + values : !trace.is_object())
      refuse("wrong-type", place(), fmt::format("a trace of {} is incomplete", parsing::tame(name)));
    const json& x = list ? trace[first] : member(trace, "x", json::value_t::array);
    const json& y = list ? trace[first + 1] : member(trace, "y", json::value_t::array);
    const json& closed = list ? trace[first + 3] : member(trace, "closed", json::value_t::boolean);
    if (!x.is_array() || !y.is_array() || x.size() != y.size() || !closed.is_boolean()) {
      refuse("wrong-type", place(),
             fmt::format("a trace of {} has not as many x as y, or does not say whether it is closed",
                         parsing::tame(name)));
    }
    if (closed == false) {
      ++open_;
      return;
    }
    Contour contour{name, {}};
    check_contours_in_slice(slice.contours.size() + 1, place());
    check_contour_count(++contours_, whole_);
    check_point_count(points_ += x.size(), whole_);
    for (std::size_t i = 0; i < x.size(); ++i)
      contour.points.push_back(mapped(number(x[i], "x"), number(y[i], "y"), transform));
    slice.contours.push_back(std::move(contour));
  }

  Point2 mapped(double x, double y, const Affine& t) const {
    const Point2 p{(t[0] * x + t[1] * y + t[2]) * millimetres_per_micrometre,
                   (t[3] * x + t[4] * y + t[5]) * millimetres_per_micrometre};
    check_magnitude(p.x, "x", place());
    check_magnitude(p.y, "y", place());
    return p;
  }

  void tell() {
    if (alignment_ != "default")
      result_.remarks.push_back(fmt::format("aligned by \"{}\", as the series says",
                                            parsing::tame(alignment_.substr(0, limits::quoted_length))));
    if (gaps_ > 0)
      result_.remarks.push_back(fmt::format("{} missing; counted as thick as the last one before",
                                            gaps_ == 1 ? "1 section is" : fmt::format("{} sections are", gaps_)));
    if (open_ > 0)
      result_.remarks.push_back(
          fmt::format("{} left out", open_ == 1 ? "1 open trace" : fmt::format("{} open traces", open_)));
  }

  Place whole_;
  FileContours result_;
  std::string alignment_ = "default";
  bool in_section_ = false;
  std::size_t number_ = 0, last_ = 0, gaps_ = 0, open_ = 0, contours_ = 0, points_ = 0;
  double height_ = 0, thickness_ = 0;  // micrometres
};

}  // namespace

bool looks_like_jser(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096;
  const std::string_view head = bytes.substr(0, looked_at);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == head.npos || head[first] != '{') return false;
  const std::size_t key = head.find_first_not_of(" \t\r\n", first + 1);
  return key != head.npos && head.substr(key).starts_with("\"sections\"");
}

FileContours parse_jser(std::string_view bytes, const std::string& file) {
  Place place;
  place.file = file;
  const auto parts = static_cast<std::size_t>(
      std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == ',' || c == '[' || c == '{'; }));
  if (bytes.size() > limits::jser_bytes || parts > limits::jser_parts) {
    refuse(
        "file-too-large", place,
        fmt::format("the series has more than {} MiB, or than {} values", limits::jser_bytes >> 20, limits::jser_parts),
        "Split it");
  }
  const json document = json::parse(bytes, nullptr, false);
  if (document.is_discarded())
    refuse("unparsable", place, "the file is no JSON, or was cut short", "Copy or save it again");
  return JserReader(file).read(document);
}

}  // namespace odontoscope
