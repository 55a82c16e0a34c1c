#include "recon/sample/tooth_table.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recon/core/embedded_file.h"
#include "recon/core/error.h"
#include "recon/input/json_schema.h"
#include "recon/sample/limits.h"

namespace odontoscope {

std::span<const EmbeddedFile> tooth_files();  // assets/teeth, made part of the program

}  // namespace odontoscope

namespace odontoscope::sample {
namespace {

constexpr NameTable<Side, 4> sides{
    {{"mesial", Side::mesial}, {"distal", Side::distal}, {"buccal", Side::buccal}, {"lingual", Side::lingual}}};

class ToothSchema {
 public:
  ToothSchema();
  ToothShape read(std::string_view bytes, const std::string& name) {
    schema_.read(bytes, name);
    return std::move(tooth_);
  }

 private:
  template <class Where>
  JsonField number(std::string_view key, Where&& where) {
    return schema_.number(key, std::forward<Where>(where),
                          {.low = -limits::table_number, .high = limits::table_number});
  }
  template <class Where>
  JsonField list(std::string_view key, std::string_view one, Where&& where, const JsonSchema::Fields& fields) {
    return schema_.list(key, one, std::forward<Where>(where),
                        {.most = limits::table_rows, .cause = "too-many", .remedy = "Leave some out."}, fields);
  }
  template <class Where>
  JsonField point3(std::string_view key, Where&& where) {
    return numbers(key, 3, [get = JsonSchema::place_of(where)](std::span<const double> xyz) {
      get() = {xyz[0], xyz[1], xyz[2]};
    });
  }
  template <class Where>
  JsonField point2(std::string_view key, Where&& where) {
    return numbers(key, 2, [get = JsonSchema::place_of(where)](std::span<const double> xy) { get() = {xy[0], xy[1]}; });
  }
  template <class Where>
  JsonField polyline(std::string_view key, Where&& where) {
    return rows(key, "a point", 3, [get = JsonSchema::place_of(where)](std::span<const double> xyz) {
      get().push_back(Point3{xyz[0], xyz[1], xyz[2]});
    });
  }
  template <class Where>
  JsonField profile(std::string_view key, Where&& where) {
    // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
    return profile_of(key, [get = JsonSchema::place_of(where)](Profile read) { get() = std::move(read); });
  }
  JsonField profile_of(std::string_view key, std::function<void(Profile)> take);
  JsonField zones();

  /// Numbers within what teeth have.
  JsonField numbers(std::string_view key, std::size_t count, std::function<void(std::span<const double>)> take) {
    return schema_.numbers(key, count, within(std::move(take)), "bad-value");
  }
  JsonField rows(std::string_view key, std::string_view one, std::size_t count,
                 std::function<void(std::span<const double>)> take, JsonEffect whole = {}) {
    return schema_.number_rows(key, one, count, within(std::move(take)), std::move(whole), "bad-value");
  }
  std::function<void(std::span<const double>)> within(std::function<void(std::span<const double>)> take);

  JsonField crown_sides();
  JsonField occlusal();
  JsonField enamel();
  JsonField roots();
  JsonField chamber();
  JsonField horns();
  JsonField canals();

  ToothShape tooth_;
  std::vector<Profile::Knot> knots_;  // of the profile that is read
  JsonSchema schema_{"a tooth"};
};

std::function<void(std::span<const double>)> ToothSchema::within(std::function<void(std::span<const double>)> take) {
  return [this, take = std::move(take)](std::span<const double> numbers) {
    for (const double value : numbers)
      if (std::abs(value) > limits::table_number)
        schema_.refuse("bad-value", fmt::format("a number is {}", value),
                       "Take a number in millimetres, at most 1000 either way.");
    take(numbers);
  };
}

JsonField ToothSchema::profile_of(std::string_view key, std::function<void(Profile)> take) {
  const auto add = [this, key](std::span<const double> knot) {
    if (!knots_.empty() && !(knots_.back().at < knot[0]))
      schema_.refuse("bad-profile", fmt::format("the knots of \"{}\" do not ascend", key), "Order them by z.");
    knots_.push_back({knot[0], knot[1]});
  };
  const auto closed = [this, key, take = std::move(take)] {
    if (knots_.empty()) schema_.refuse("bad-profile", fmt::format("\"{}\" has no knots", key), "Give it one at least.");
    take(Profile(knots_));
  };
  return rows(key, "a knot", 2, add, {.opened = [this] { knots_.clear(); }, .closed = closed});
}

JsonField ToothSchema::zones() {
  return rows("steep", "a range", 2, [this](std::span<const double> range) {
    if (!(range[0] < range[1])) schema_.refuse("bad-value", "a range of heights does not ascend", "Write [low, high].");
    if (tooth_.steep.size() == limits::table_rows)
      schema_.refuse("too-many", fmt::format("more than {} ranges", limits::table_rows), "Leave some out.");
    tooth_.steep.push_back({range[0], range[1]});
  });
}

JsonField ToothSchema::crown_sides() {
  const auto furrow = last(tooth_.sides.furrows);
  return schema_.object(
      "sides",
      {profile("mesial", tooth_.sides.mesial), profile("distal", tooth_.sides.distal),
       profile("buccal", tooth_.sides.buccal), profile("lingual", tooth_.sides.lingual),
       number("exponent_mesiobuccal", tooth_.sides.exponent_mesiobuccal),
       number("exponent_mesiolingual", tooth_.sides.exponent_mesiolingual),
       number("exponent_distolingual", tooth_.sides.exponent_distolingual),
       number("exponent_distobuccal", tooth_.sides.exponent_distobuccal),
       number("wider_mesially", tooth_.sides.wider_mesially), number("wider_buccally", tooth_.sides.wider_buccally),
       list("furrows", "a furrow", tooth_.sides.furrows,
            {schema_.word("side", of(furrow, &Furrow::side), sides), profile("place", of(furrow, &Furrow::place)),
             number("width", of(furrow, &Furrow::width)), profile("depth", of(furrow, &Furrow::depth))})});
}

JsonField ToothSchema::occlusal() {
  const auto cusp = last(tooth_.occlusal.cusps);
  const auto ridge = last(tooth_.occlusal.ridges);
  return schema_.object(
      "occlusal",
      {list("cusps", "a cusp", tooth_.occlusal.cusps,
            {schema_.text("name", of(cusp, &Cusp::name)), point3("tip", of(cusp, &Cusp::tip)),
             point2("inward", of(cusp, &Cusp::inward)), number("slope_in", of(cusp, &Cusp::slope_in)),
             number("slope_out", of(cusp, &Cusp::slope_out)), number("slope_along", of(cusp, &Cusp::slope_along)),
             number("rounding", of(cusp, &Cusp::rounding)), optional(point2("along", of(cusp, &Cusp::along)))}),
       list("ridges", "a ridge", tooth_.occlusal.ridges,
            {polyline("crest", of(ridge, &Ridge::crest)), number("slope", of(ridge, &Ridge::slope)),
             number("rounding", of(ridge, &Ridge::rounding))}),
       number("fissure_depth", tooth_.occlusal.fissure_depth), number("fissure_width", tooth_.occlusal.fissure_width),
       optional(number("fissure_round", tooth_.occlusal.fissure_round)),
       number("supplemental_depth", tooth_.occlusal.supplemental_depth), number("blend", tooth_.occlusal.blend),
       number("edge_blend", tooth_.occlusal.edge_blend)});
}

JsonField ToothSchema::enamel() {
  const auto edge = last(tooth_.enamel.dentine_edge);
  return schema_.object(
      "enamel", {number("side", tooth_.enamel.side), number("side_height", tooth_.enamel.side_height),
                 number("top", tooth_.enamel.top), optional(number("highest_dentine", tooth_.enamel.highest_dentine)),
                 optional(list("dentine_edge", "a crest", tooth_.enamel.dentine_edge,
                               {polyline("crest", of(edge, &Ridge::crest)), number("slope", of(edge, &Ridge::slope)),
                                number("rounding", of(edge, &Ridge::rounding))})),
                 optional(number("margin_exponent", tooth_.enamel.margin_exponent)),
                 optional(number("margin_height", tooth_.enamel.margin_height))});
}

JsonField ToothSchema::roots() {
  const auto root = last(tooth_.roots);
  return list(
      "roots", "a root", tooth_.roots,
      {schema_.text("name", of(root, &Root::name)), number("apex_z", of(root, &Root::apex_z)),
       number("blunt", of(root, &Root::blunt)), number("exponent", of(root, &Root::exponent)),
       profile("x", of(root, &Root::x)), profile("y", of(root, &Root::y)),
       profile("half_mesiodistal", of(root, &Root::half_mesiodistal)),
       profile("half_buccolingual", of(root, &Root::half_buccolingual)),
       profile("lobe_offset", of(root, &Root::lobe_offset)), optional(profile("groove", of(root, &Root::groove))),
       optional(number("groove_width", of(root, &Root::groove_width))),
       optional(number("wider_buccally", of(root, &Root::wider_buccally)))});
}

JsonField ToothSchema::chamber() {
  return schema_.object("chamber",
                        {point3("low", tooth_.chamber.low), point3("high", tooth_.chamber.high),
                         number("exponent", tooth_.chamber.exponent), number("rounding", tooth_.chamber.rounding),
                         optional(profile("x", tooth_.chamber.x)), optional(profile("y", tooth_.chamber.y)),
                         optional(profile("half_mesiodistal", tooth_.chamber.half_mesiodistal)),
                         optional(profile("half_buccolingual", tooth_.chamber.half_buccolingual)),
                         optional(number("wider_mesially", tooth_.chamber.wider_mesially))});
}

JsonField ToothSchema::horns() {
  const auto horn = last(tooth_.horns);
  return list("horns", "a horn", tooth_.horns,
              {schema_.text("name", of(horn, &Horn::name)), point3("base", of(horn, &Horn::base)),
               point3("tip", of(horn, &Horn::tip)), number("base_radius", of(horn, &Horn::base_radius)),
               number("tip_radius", of(horn, &Horn::tip_radius)), optional(number("blend", of(horn, &Horn::blend)))});
}

JsonField ToothSchema::canals() {
  const auto canal = last(tooth_.canals);
  const JsonField root = schema_.field("root", JsonNode::Shape::count, {.number = [this, canal](double value) {
                                         if (!(value < static_cast<double>(tooth_.roots.size())))
                                           schema_.refuse("bad-value", fmt::format("there is no root {}", value),
                                                          "Count the roots from 0, and put them before the canals.");
                                         canal().root = static_cast<std::size_t>(value);
                                       }});
  return list("canals", "a canal", tooth_.canals,
              {schema_.text("name", of(canal, &Canal::name)), root, number("lobe", of(canal, &Canal::lobe)),
               profile("half_mesiodistal", of(canal, &Canal::half_mesiodistal)),
               profile("half_buccolingual", of(canal, &Canal::half_buccolingual)),
               optional(number("constriction", of(canal, &Canal::constriction))),
               optional(number("foramen", of(canal, &Canal::foramen))),
               optional(profile("shift_x", of(canal, &Canal::shift_x))),
               optional(profile("shift_y", of(canal, &Canal::shift_y)))});
}

ToothSchema::ToothSchema() {
  const auto mark = last(tooth_.landmarks);
  schema_.document(
      "odontoscope.tooth", {1, 1},
      {schema_.word("kind", tooth_.kind, tooth_kinds),
       schema_.text("tooth", tooth_.tooth),
       schema_.text("fdi", tooth_.fdi),
       schema_.object("proportions", {number("crown_length", tooth_.proportions.crown_length),
                                      number("root_length", tooth_.proportions.root_length),
                                      number("crown_mesiodistal", tooth_.proportions.crown_mesiodistal),
                                      number("cervix_mesiodistal", tooth_.proportions.cervix_mesiodistal),
                                      number("crown_buccolingual", tooth_.proportions.crown_buccolingual),
                                      number("cervix_buccolingual", tooth_.proportions.cervix_buccolingual),
                                      number("cervical_curve_mesial", tooth_.proportions.cervical_curve_mesial),
                                      number("cervical_curve_distal", tooth_.proportions.cervical_curve_distal)}),
       number("top_z", tooth_.top_z),
       optional(zones()),
       schema_.object("cervical_line",
                      {number("z", tooth_.cervical_line.z), number("rise_mesial", tooth_.cervical_line.rise_mesial),
                       number("rise_distal", tooth_.cervical_line.rise_distal),
                       number("rise_lingual", tooth_.cervical_line.rise_lingual)}),
       crown_sides(),
       occlusal(),
       enamel(),
       roots(),
       number("root_blend", tooth_.root_blend),
       number("trunk_low_z", tooth_.trunk_low_z),
       number("trunk_high_z", tooth_.trunk_high_z),
       chamber(),
       horns(),
       canals(),
       number("canal_top_z", tooth_.canal_top_z),
       number("pulp_blend", tooth_.pulp_blend),
       optional(number("orifice_blend", tooth_.orifice_blend)),
       optional(list("landmarks", "a landmark", tooth_.landmarks,
                     {schema_.text("name", of(mark, &NamedPoint::name)), point3("at", of(mark, &NamedPoint::at))}))});
}

}  // namespace

ToothShape read_tooth_table(std::string_view bytes, const std::string& name) { return ToothSchema().read(bytes, name); }

ToothShape tooth_shape(ToothKind kind) {
  const std::string file = std::string(name(kind)) + ".json";
  for (const EmbeddedFile& table : tooth_files())
    if (table.name == file) return read_tooth_table(table.bytes, file);
  throw UsageError("unknown kind of sample tooth", "Choose molar, premolar or incisor");
}

}  // namespace odontoscope::sample
