#include "recon/sample/tooth_schema.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace odontoscope::sample {
namespace {

constexpr std::string_view format_name = "odontoscope.tooth";
constexpr double format_version = 1;

constexpr NameTable<Side, 4> sides{
    {{"mesial", Side::mesial}, {"distal", Side::distal}, {"buccal", Side::buccal}, {"lingual", Side::lingual}}};

}  // namespace

ToothSchema::Field ToothSchema::crown_sides() {
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

ToothSchema::Field ToothSchema::occlusal() {
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

ToothSchema::Field ToothSchema::enamel() {
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

ToothSchema::Field ToothSchema::roots() {
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

ToothSchema::Field ToothSchema::chamber() {
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

ToothSchema::Field ToothSchema::horns() {
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

ToothSchema::Field ToothSchema::canals() {
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

ToothSchema::ToothSchema() {
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

}  // namespace odontoscope::sample
