#include "recon/sample/tooth_table.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "recon/core/embedded_file.h"
#include "recon/core/error.h"
#include "recon/core/named.h"
#include "recon/input/json_source.h"
#include "recon/input/strict_json.h"
#include "recon/sample/limits.h"

namespace odontoscope {

std::span<const EmbeddedFile> tooth_files();  // assets/teeth, made part of the program

}  // namespace odontoscope

namespace odontoscope::sample {
namespace {

constexpr std::string_view format_name = "odontoscope.tooth";
constexpr double format_version = 1;

constexpr NameTable<Side, 4> sides{
    {{"mesial", Side::mesial}, {"distal", Side::distal}, {"buccal", Side::buccal}, {"lingual", Side::lingual}}};

/// What a value that was read does.
struct Effect {
  std::function<void()> opened = {}, closed = {};
  std::function<void(double)> number = {};
  std::function<void(const std::string&)> text = {};
};

struct Field {
  std::string_view name;
  int node;
  bool required = true;
};
Field optional(Field field) {
  field.required = false;
  return field;
}

/// The nodes of the format with what each does to a tooth. `get` is asked for its target when the value is read, since
/// lists grow.
class Schema {
 public:
  Schema();
  Schema(const Schema&) = delete;
  Schema& operator=(const Schema&) = delete;

  ToothShape tooth;
  std::vector<JsonNode> nodes;
  std::vector<Effect> effects;
  /// Set by whoever reads.
  std::function<void(std::string_view cause, const std::string& wrong, std::string_view remedy)> refuse;

 private:
  using Shape = JsonNode::Shape;

  int node(JsonNode::Shape shape, std::string_view what, Effect effect = {}, int element = -1) {
    nodes.push_back({shape, names_.emplace_back(what), element});
    effects.push_back(std::move(effect));
    return static_cast<int>(nodes.size()) - 1;
  }
  static std::string quoted(std::string_view key) { return fmt::format("\"{}\"", key); }

  void take_fields(int object, std::initializer_list<Field> fields) {
    std::vector<JsonNode::Key>& keys = keys_.emplace_back();
    for (const Field& field : fields) keys.push_back({field.name, field.node, field.required});
    nodes[static_cast<std::size_t>(object)].keys = keys;
  }
  Field object(std::string_view key, std::initializer_list<Field> fields) {
    const int made = node(Shape::object, quoted(key));
    take_fields(made, fields);
    return {key, made};
  }
  /// Objects of a list; each begins as a new one at its end.
  template <class Get>
  Field list(std::string_view key, std::string_view one, Get get, std::initializer_list<Field> fields) {
    const int element =
        node(Shape::object, one, {.opened = [this, get, key] {
               if (get().size() == limits::table_rows)
                 refuse("too-many", fmt::format("more than {} {}", limits::table_rows, key), "Leave some out.");
               get().emplace_back();
             }});
    take_fields(element, fields);
    return {key, node(Shape::array, quoted(key), {}, element)};
  }

  template <class Get>
  Field number(std::string_view key, Get get) {
    return {key, node(Shape::number, quoted(key),
                      {.number = [this, get, key](double value) { get() = in_range(value, key); }})};
  }
  template <class Get>
  Field text(std::string_view key, Get get) {
    return {key, node(Shape::text, quoted(key), {.text = [get](const std::string& value) { get() = value; }})};
  }
  /// One of known words.
  template <class Get, class Value, std::size_t count>
  Field word(std::string_view key, Get get, const NameTable<Value, count>& words) {
    return {key, node(Shape::text, quoted(key), {.text = [this, get, key, &words](const std::string& value) {
                        for (const auto& [known, meant] : words) {
                          if (value != known) continue;
                          get() = meant;
                          return;
                        }
                        refuse("bad-value", fmt::format("\"{}\" cannot be \"{}\"", key, value), "Take a known word.");
                      }})};
  }

  /// So many numbers, handed over together.
  int numbers(const std::string& what, std::size_t count, std::function<void()> taken) {
    const int coordinate = node(Shape::number, "a number", {.number = [this](double value) {
                                  if (numbers_.size() < limits::table_rows)
                                    numbers_.push_back(in_range(value, "a number"));
                                }});
    return node(Shape::array, what,
                {.opened = [this] { numbers_.clear(); },
                 .closed =
                     [this, what, count, taken] {
                       if (numbers_.size() != count)
                         refuse("bad-value", fmt::format("{} has not {} numbers", what, count), "Correct it.");
                       taken();
                     }},
                coordinate);
  }
  template <class Get>
  Field point3(std::string_view key, Get get) {
    return {key, numbers(quoted(key), 3, [this, get] { get() = Point3{numbers_[0], numbers_[1], numbers_[2]}; })};
  }
  template <class Get>
  Field point2(std::string_view key, Get get) {
    return {key, numbers(quoted(key), 2, [this, get] { get() = Point2{numbers_[0], numbers_[1]}; })};
  }
  template <class Get>
  Field polyline(std::string_view key, Get get) {
    const int point = numbers("a point", 3, [this, get] {
      get().push_back(Point3{numbers_[0], numbers_[1], numbers_[2]});
    });
    return {key, node(Shape::array, quoted(key), {}, point)};
  }
  template <class Get>
  Field profile(std::string_view key, Get get) {
    const int knot = numbers("a knot", 2, [this, key] {
      if (!knots_.empty() && !(knots_.back().at < numbers_[0]))
        refuse("bad-profile", fmt::format("the knots of \"{}\" do not ascend", key), "Order them by z.");
      knots_.push_back({numbers_[0], numbers_[1]});
    });
    return {key, node(Shape::array, quoted(key),
                      {.opened = [this] { knots_.clear(); },
                       .closed =
                           [this, get, key] {
                             if (knots_.empty())
                               refuse("bad-profile", fmt::format("\"{}\" has no knots", key), "Give it one at least.");
                             get() = Profile(knots_);
                           }},
                      knot)};
  }

  int zones() {
    const int zone = numbers("a range", 2, [this] {
      if (!(numbers_[0] < numbers_[1])) refuse("bad-value", "a range of heights does not ascend", "Write [low, high].");
      if (tooth.steep.size() == limits::table_rows)
        refuse("too-many", fmt::format("more than {} ranges", limits::table_rows), "Leave some out.");
      tooth.steep.push_back({numbers_[0], numbers_[1]});
    });
    return node(Shape::array, "\"steep\"", {}, zone);
  }

  double in_range(double value, std::string_view what) const {
    if (std::abs(value) > limits::table_number)
      refuse("bad-value", fmt::format("{} is {}", what, value),
             "Take a number in millimetres, at most 1000 either way.");
    return value;
  }

  Field crown_sides();
  Field occlusal();
  Field enamel();
  Field roots();
  Field chamber();
  Field horns();
  Field canals();

  std::deque<std::string> names_;
  std::deque<std::vector<JsonNode::Key>> keys_;
  std::vector<double> numbers_;
  std::vector<Profile::Knot> knots_;
};

Field Schema::crown_sides() {
  const auto furrow = [this]() -> Furrow& { return tooth.sides.furrows.back(); };
  return object("sides", {profile(
                              "mesial", [this]() -> auto& { return tooth.sides.mesial; }),
                          profile(
                              "distal", [this]() -> auto& { return tooth.sides.distal; }),
                          profile(
                              "buccal", [this]() -> auto& { return tooth.sides.buccal; }),
                          profile(
                              "lingual", [this]() -> auto& { return tooth.sides.lingual; }),
                          number(
                              "exponent_mesiobuccal", [this]() -> auto& { return tooth.sides.exponent_mesiobuccal; }),
                          number(
                              "exponent_mesiolingual", [this]() -> auto& { return tooth.sides.exponent_mesiolingual; }),
                          number(
                              "exponent_distolingual", [this]() -> auto& { return tooth.sides.exponent_distolingual; }),
                          number(
                              "exponent_distobuccal", [this]() -> auto& { return tooth.sides.exponent_distobuccal; }),
                          number(
                              "wider_mesially", [this]() -> auto& { return tooth.sides.wider_mesially; }),
                          number(
                              "wider_buccally", [this]() -> auto& { return tooth.sides.wider_buccally; }),
                          list("furrows", "a furrow", [this]() -> auto& { return tooth.sides.furrows; },
                               {word(
                                    "side", [furrow]() -> auto& { return furrow().side; }, sides),
                                profile(
                                    "place", [furrow]() -> auto& { return furrow().place; }),
                                number(
                                    "width", [furrow]() -> auto& { return furrow().width; }),
                                profile(
                                    "depth", [furrow]() -> auto& { return furrow().depth; })})});
}

Field Schema::occlusal() {
  const auto cusp = [this]() -> Cusp& { return tooth.occlusal.cusps.back(); };
  const auto ridge = [this]() -> Ridge& { return tooth.occlusal.ridges.back(); };
  return object("occlusal", {list("cusps", "a cusp", [this]() -> auto& { return tooth.occlusal.cusps; },
                                  {text(
                                       "name", [cusp]() -> auto& { return cusp().name; }),
                                   point3(
                                       "tip", [cusp]() -> auto& { return cusp().tip; }),
                                   point2(
                                       "inward", [cusp]() -> auto& { return cusp().inward; }),
                                   number(
                                       "slope_in", [cusp]() -> auto& { return cusp().slope_in; }),
                                   number(
                                       "slope_out", [cusp]() -> auto& { return cusp().slope_out; }),
                                   number(
                                       "slope_along", [cusp]() -> auto& { return cusp().slope_along; }),
                                   number(
                                       "rounding", [cusp]() -> auto& { return cusp().rounding; }),
                                   optional(point2(
                                       "along", [cusp]() -> auto& { return cusp().along; }))}),
                             list("ridges", "a ridge", [this]() -> auto& { return tooth.occlusal.ridges; },
                                  {polyline(
                                       "crest", [ridge]() -> auto& { return ridge().crest; }),
                                   number(
                                       "slope", [ridge]() -> auto& { return ridge().slope; }),
                                   number(
                                       "rounding", [ridge]() -> auto& { return ridge().rounding; })}),
                             number(
                                 "fissure_depth", [this]() -> auto& { return tooth.occlusal.fissure_depth; }),
                             number(
                                 "fissure_width", [this]() -> auto& { return tooth.occlusal.fissure_width; }),
                             optional(number(
                                 "fissure_round", [this]() -> auto& { return tooth.occlusal.fissure_round; })),
                             number(
                                 "supplemental_depth", [this]() -> auto& { return tooth.occlusal.supplemental_depth; }),
                             number(
                                 "blend", [this]() -> auto& { return tooth.occlusal.blend; }),
                             number(
                                 "edge_blend", [this]() -> auto& { return tooth.occlusal.edge_blend; })});
}

Field Schema::enamel() {
  const auto edge = [this]() -> Ridge& { return tooth.enamel.dentine_edge.back(); };
  return object("enamel",
                {number(
                     "side", [this]() -> auto& { return tooth.enamel.side; }),
                 number(
                     "side_height", [this]() -> auto& { return tooth.enamel.side_height; }),
                 number(
                     "top", [this]() -> auto& { return tooth.enamel.top; }),
                 optional(number(
                     "highest_dentine", [this]() -> auto& { return tooth.enamel.highest_dentine; })),
                 optional(list("dentine_edge", "a crest", [this]() -> auto& { return tooth.enamel.dentine_edge; },
                               {polyline(
                                    "crest", [edge]() -> auto& { return edge().crest; }),
                                number(
                                    "slope", [edge]() -> auto& { return edge().slope; }),
                                number(
                                    "rounding", [edge]() -> auto& { return edge().rounding; })})),
                 optional(number(
                     "margin_exponent", [this]() -> auto& { return tooth.enamel.margin_exponent; })),
                 optional(number(
                     "margin_height", [this]() -> auto& { return tooth.enamel.margin_height; }))});
}

Field Schema::roots() {
  const auto root = [this]() -> Root& { return tooth.roots.back(); };
  return list("roots", "a root", [this]() -> auto& { return tooth.roots; },
              {text(
                   "name", [root]() -> auto& { return root().name; }),
               number(
                   "apex_z", [root]() -> auto& { return root().apex_z; }),
               number(
                   "blunt", [root]() -> auto& { return root().blunt; }),
               number(
                   "exponent", [root]() -> auto& { return root().exponent; }),
               profile(
                   "x", [root]() -> auto& { return root().x; }),
               profile(
                   "y", [root]() -> auto& { return root().y; }),
               profile(
                   "half_mesiodistal", [root]() -> auto& { return root().half_mesiodistal; }),
               profile(
                   "half_buccolingual", [root]() -> auto& { return root().half_buccolingual; }),
               profile(
                   "lobe_offset", [root]() -> auto& { return root().lobe_offset; }),
               optional(profile(
                   "groove", [root]() -> auto& { return root().groove; })),
               optional(number(
                   "groove_width", [root]() -> auto& { return root().groove_width; })),
               optional(number(
                   "wider_buccally", [root]() -> auto& { return root().wider_buccally; }))});
}

Field Schema::chamber() {
  const auto box = [this]() -> PulpChamber& { return tooth.chamber; };
  return object("chamber", {point3(
                                "low", [box]() -> auto& { return box().low; }),
                            point3(
                                "high", [box]() -> auto& { return box().high; }),
                            number(
                                "exponent", [box]() -> auto& { return box().exponent; }),
                            number(
                                "rounding", [box]() -> auto& { return box().rounding; }),
                            optional(profile(
                                "x", [box]() -> auto& { return box().x; })),
                            optional(profile(
                                "y", [box]() -> auto& { return box().y; })),
                            optional(profile(
                                "half_mesiodistal", [box]() -> auto& { return box().half_mesiodistal; })),
                            optional(profile(
                                "half_buccolingual", [box]() -> auto& { return box().half_buccolingual; })),
                            optional(number(
                                "wider_mesially", [box]() -> auto& { return box().wider_mesially; }))});
}

Field Schema::horns() {
  const auto horn = [this]() -> Horn& { return tooth.horns.back(); };
  return list("horns", "a horn", [this]() -> auto& { return tooth.horns; },
              {text(
                   "name", [horn]() -> auto& { return horn().name; }),
               point3(
                   "base", [horn]() -> auto& { return horn().base; }),
               point3(
                   "tip", [horn]() -> auto& { return horn().tip; }),
               number(
                   "base_radius", [horn]() -> auto& { return horn().base_radius; }),
               number(
                   "tip_radius", [horn]() -> auto& { return horn().tip_radius; }),
               optional(number(
                   "blend", [horn]() -> auto& { return horn().blend; }))});
}

Field Schema::canals() {
  const auto canal = [this]() -> Canal& { return tooth.canals.back(); };
  const int root = node(Shape::count, "\"root\"", {.number = [this, canal](double value) {
                          if (!(value < static_cast<double>(tooth.roots.size())))
                            refuse("bad-value", fmt::format("there is no root {}", value),
                                   "Count the roots from 0, and put them before the canals.");
                          canal().root = static_cast<std::size_t>(value);
                        }});
  return list("canals", "a canal", [this]() -> auto& { return tooth.canals; },
              {text(
                   "name", [canal]() -> auto& { return canal().name; }),
               {"root", root},
               number(
                   "lobe", [canal]() -> auto& { return canal().lobe; }),
               profile(
                   "half_mesiodistal", [canal]() -> auto& { return canal().half_mesiodistal; }),
               profile(
                   "half_buccolingual", [canal]() -> auto& { return canal().half_buccolingual; }),
               optional(number(
                   "constriction", [canal]() -> auto& { return canal().constriction; })),
               optional(number(
                   "foramen", [canal]() -> auto& { return canal().foramen; })),
               optional(profile(
                   "shift_x", [canal]() -> auto& { return canal().shift_x; })),
               optional(profile(
                   "shift_y", [canal]() -> auto& { return canal().shift_y; }))});
}

Schema::Schema() {
  node(Shape::object, "a tooth");
  const int format =
      node(Shape::text, "\"format\"", {.text = [this](const std::string& value) {
             if (value != format_name)
               refuse("wrong-format", "this is no table of a tooth", "Write \"format\":\"odontoscope.tooth\".");
           }});
  const int version = node(Shape::number, "\"version\"", {.number = [this](double value) {
                             if (value != format_version)
                               refuse("wrong-version", fmt::format("version {} is not known", value), "Write 1.");
                           }});
  const auto mark = [this]() -> NamedPoint& { return tooth.landmarks.back(); };
  take_fields(
      0,
      {{"format", format},
       {"version", version},
       word(
           "kind", [this]() -> auto& { return tooth.kind; }, tooth_kinds),
       text(
           "tooth", [this]() -> auto& { return tooth.tooth; }),
       text(
           "fdi", [this]() -> auto& { return tooth.fdi; }),
       object("proportions",
              {number(
                   "crown_length", [this]() -> auto& { return tooth.proportions.crown_length; }),
               number(
                   "root_length", [this]() -> auto& { return tooth.proportions.root_length; }),
               number(
                   "crown_mesiodistal", [this]() -> auto& { return tooth.proportions.crown_mesiodistal; }),
               number(
                   "cervix_mesiodistal", [this]() -> auto& { return tooth.proportions.cervix_mesiodistal; }),
               number(
                   "crown_buccolingual", [this]() -> auto& { return tooth.proportions.crown_buccolingual; }),
               number(
                   "cervix_buccolingual", [this]() -> auto& { return tooth.proportions.cervix_buccolingual; }),
               number(
                   "cervical_curve_mesial", [this]() -> auto& { return tooth.proportions.cervical_curve_mesial; }),
               number(
                   "cervical_curve_distal", [this]() -> auto& { return tooth.proportions.cervical_curve_distal; })}),
       number(
           "top_z", [this]() -> auto& { return tooth.top_z; }),
       {"steep", zones(), false},
       object("cervical_line", {number(
                                    "z", [this]() -> auto& { return tooth.cervical_line.z; }),
                                number(
                                    "rise_mesial", [this]() -> auto& { return tooth.cervical_line.rise_mesial; }),
                                number(
                                    "rise_distal", [this]() -> auto& { return tooth.cervical_line.rise_distal; }),
                                number(
                                    "rise_lingual", [this]() -> auto& { return tooth.cervical_line.rise_lingual; })}),
       crown_sides(),
       occlusal(),
       enamel(),
       roots(),
       number(
           "root_blend", [this]() -> auto& { return tooth.root_blend; }),
       number(
           "trunk_low_z", [this]() -> auto& { return tooth.trunk_low_z; }),
       number(
           "trunk_high_z", [this]() -> auto& { return tooth.trunk_high_z; }),
       chamber(),
       horns(),
       canals(),
       number(
           "canal_top_z", [this]() -> auto& { return tooth.canal_top_z; }),
       number(
           "pulp_blend", [this]() -> auto& { return tooth.pulp_blend; }),
       optional(number(
           "orifice_blend", [this]() -> auto& { return tooth.orifice_blend; })),
       optional(list("landmarks", "a landmark", [this]() -> auto& { return tooth.landmarks; },
                     {text(
                          "name", [mark]() -> auto& { return mark().name; }),
                      point3(
                          "at", [mark]() -> auto& { return mark().at; })}))});
}

class ToothTableReader final : public StrictJson {
 public:
  explicit ToothTableReader(Schema& schema) : StrictJson(schema.nodes), schema_(schema) {
    schema_.refuse = [this](std::string_view cause, const std::string& wrong, std::string_view remedy) {
      StrictJson::refuse(cause, wrong, remedy);
    };
  }

 private:
  const Effect& effect(int node) const { return schema_.effects[static_cast<std::size_t>(node)]; }
  void opened(int node) override {
    if (effect(node).opened) effect(node).opened();
  }
  void closed(int node) override {
    if (effect(node).closed) effect(node).closed();
  }
  void number(int node, double value) override {
    if (effect(node).number) effect(node).number(value);
  }
  void count(int node, std::uint64_t value) override { number(node, static_cast<double>(value)); }
  void text(int node, const std::string& value) override {
    if (effect(node).text) effect(node).text(value);
  }

  Schema& schema_;
};

}  // namespace

ToothShape read_tooth_table(std::string_view bytes, const std::string& name) {
  Schema schema;
  JsonSource source = JsonSource::from_bytes(bytes, name);
  ToothTableReader(schema).read(source);
  return std::move(schema.tooth);
}

ToothShape tooth_shape(ToothKind kind) {
  const std::string file = std::string(name(kind)) + ".json";
  for (const EmbeddedFile& table : tooth_files())
    if (table.name == file) return read_tooth_table(table.bytes, file);
  throw UsageError("unknown kind of sample tooth", "Choose molar, premolar or incisor");
}

}  // namespace odontoscope::sample
