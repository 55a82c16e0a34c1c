// Lower left first molar (FDI 36), after Wheeler: crown 7.5 mm, root 14 mm; mesiodistal 11.0 mm (cervix 9.0), buccolingual 10.5 mm
// (cervix 9.0). Five cusps; the mesiolingual is the highest, the distal the lowest. The mesiolingual and the distobuccal cusp meet in
// the central fossa, which bends the fissures into a Y. The crown leans lingually: buccal crest of contour in the cervical
// third, lingual in the middle third.

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {
namespace {

CrownSides sides() {
  CrownSides s{
      .mesial = {{12, 4.35}, {14, 4.5}, {15.2, 4.75}, {16.6, 5.15}, {18, 5.42}, {18.9, 5.5}, {20, 5.3}, {21.5, 4.7}},
      .distal = {{12, -4.4}, {14, -4.5}, {15.2, -4.85}, {16.6, -5.25}, {17.8, -5.47}, {18.4, -5.5}, {19.6, -5.3}, {21.5, -4.6}},
      .buccal = {{12, 4.4}, {14, 4.5}, {15, 4.95}, {16.2, 5.2}, {17, 5.1}, {18.5, 4.7}, {20, 4.15}, {21.5, 3.3}},
      .lingual = {{12, -4.4}, {14, -4.45}, {15.2, -4.6}, {16.5, -4.95}, {17.8, -5.12}, {18.6, -5.15}, {20, -4.9}, {21.5, -4.2}},
      .exponent_mesiobuccal = 2.9, .exponent_mesiolingual = 2.6, .exponent_distolingual = 2.5, .exponent_distobuccal = 2.3,
      .wider_mesially = 0.06, .wider_buccally = 0.05};
  s.furrows = {
      // mesiobuccal groove, ending in the buccal pit; distobuccal groove; lingual groove
      {Side::buccal, {{16, 0.5}, {20, 0.85}}, 0.55, {{16.2, 0.0}, {17.4, 0.3}, {20, 0.45}}},
      {Side::buccal, {{16, -2.9}, {20, -2.75}}, 0.5, {{16, 0.0}, {18, 0.22}, {20, 0.4}}},
      {Side::lingual, {{16, -0.15}, {20, 0.0}}, 0.6, {{17.4, 0.0}, {19, 0.22}, {20.5, 0.4}}},
      // hollows above the furcation
      {Side::buccal, {{10, 0.0}, {16, 0.2}}, 1.3, {{10, 0.5}, {13.5, 0.35}, {15.2, 0.0}}},
      {Side::lingual, {{10, 0.0}, {16, 0.0}}, 1.3, {{10, 0.5}, {13.5, 0.3}, {15.2, 0.0}}}};
  return s;
}

Occlusal occlusal() {
  Occlusal o;
  o.cusps = {{"mesiobuccal", {2.55, 2.75, 21.1}, {0.9, 0.0}, 0.62, 1.5, 0.46, 0.4},
             {"distobuccal", {-0.95, 2.95, 20.95}, {-0.5, 0.0}, 0.6, 1.5, 0.55, 0.4},
             {"distal", {-4.0, 1.35, 20.35}, {-2.0, 0.0}, 0.6, 1.5, 0.6, 0.35},
             {"mesiolingual", {2.3, -3.2, 21.5}, {0.7, -0.1}, 0.7, 1.5, 0.5, 0.3},
             {"distolingual", {-2.35, -3.15, 21.3}, {-1.1, -0.1}, 0.68, 1.5, 0.52, 0.3}};
  o.ridges = {{{{3.9, 2.0, 20.2}, {4.45, 0.6, 19.9}, {4.4, -1.0, 19.9}, {3.7, -2.6, 20.4}}, 0.75, 0.3},
              {{{-4.6, 0.6, 19.7}, {-4.75, -0.5, 19.4}, {-4.4, -1.7, 19.5}, {-3.6, -2.7, 20.2}}, 0.75, 0.3}};
  o.fissure_depth = 0.5;
  o.fissure_width = 0.4;
  o.blend = 0.12;
  o.edge_blend = 0.7;
  return o;
}

std::vector<Root> roots() {
  return {{.name = "mesial", .apex_z = 0, .blunt = 1.6,
           .x = {{0, 1.9}, {2, 2.65}, {4.5, 3.15}, {7.5, 3.2}, {10, 2.85}, {14, 2.25}},
           .y = {{0, -0.1}, {14, 0.0}},
           .half_mesiodistal = {{0, 0.95}, {3, 1.4}, {7, 1.8}, {10, 2.2}, {12, 2.3}, {14, 2.3}},
           .half_buccolingual = {{0, 1.0}, {3, 1.35}, {7, 1.75}, {11, 2.1}, {14, 2.2}},
           .lobe_offset = {{0, 0.95}, {3, 1.35}, {7, 1.85}, {11, 2.15}, {14, 2.25}}},
          {.name = "distal", .apex_z = 0.8, .blunt = 1.5,
           .x = {{0.8, -4.35}, {3, -4.05}, {6, -3.6}, {10, -2.9}, {14, -2.3}},
           .y = {{0, -0.1}, {14, 0.0}},
           .half_mesiodistal = {{0.8, 0.95}, {4, 1.4}, {7, 1.7}, {10, 2.1}, {12, 2.25}, {14, 2.25}},
           .half_buccolingual = {{0.8, 1.5}, {4, 2.3}, {8, 3.2}, {11, 3.8}, {14, 4.2}},
           .lobe_offset = 0.0, .exponent = 2.3}};
}

}  // namespace

ToothShape molar() {
  ToothShape t;
  t.kind = ToothKind::molar;
  t.tooth = "lower left first molar (FDI 36)";
  t.fdi = "36";
  t.proportions = {7.5, 14.0, 11.0, 9.0, 10.5, 9.0, 1.0, 0.0};
  t.top_z = 21.5;
  t.cervical_line = {14.0, 0.9, 0.2, 0.4};
  t.sides = sides();
  t.occlusal = occlusal();
  t.enamel = {1.45, 5.0, 1.6};
  t.roots = roots();
  t.root_blend = 0.9;
  t.trunk_low_z = 11.6;
  t.trunk_high_z = 14.6;
  t.chamber = {{-3.1, -2.5, 13.5}, {3.1, 2.5, 15.6}, 3.0};
  t.horns = {{"mesiobuccal", {2.2, 1.7, 14.9}, {2.35, 2.1, 17.1}, 0.75, 0.25},
             {"distobuccal", {-0.9, 1.7, 14.9}, {-0.95, 2.2, 16.8}, 0.7, 0.22},
             {"distal", {-2.5, 0.7, 14.8}, {-2.95, 1.1, 16.4}, 0.65, 0.2},
             {"mesiolingual", {2.1, -1.8, 14.9}, {2.2, -2.4, 17.3}, 0.7, 0.22},
             {"distolingual", {-2.0, -1.8, 14.9}, {-2.1, -2.3, 17.0}, 0.7, 0.22}};
  const Profile narrow{{0.5, 0.17}, {3, 0.24}, {8, 0.36}, {12, 0.48}, {14, 0.6}};
  t.canals = {{"mesiobuccal", 0, 1, narrow, narrow},
              {"mesiolingual", 0, -1, narrow, narrow},
              {"distal", 1, 0, {{1.3, 0.2}, {4, 0.28}, {9, 0.42}, {14, 0.65}}, {{1.3, 0.3}, {4, 0.55}, {9, 1.0}, {14, 1.4}}}};
  t.canal_top_z = 14.8;
  t.pulp_blend = 0.45;
  return t;
}

}  // namespace odontoscope::sample
