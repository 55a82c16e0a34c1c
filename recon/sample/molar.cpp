// Lower left first molar (FDI 36), after Wheeler: crown 7.5 mm, root 14 mm; mesiodistal 11.0 mm (cervix 9.0),
// buccolingual 10.5 mm (cervix 9.0). Five cusps; the mesiolingual is the highest, the distal the lowest. The
// mesiolingual and the distobuccal cusp meet in the central fossa, which bends the fissures into a Y. The crown leans
// lingually: buccal crest of contour in the cervical third, lingual in the middle third.

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {
namespace {

CrownSides molar_sides() {
  CrownSides s{
      .mesial = {{12, 4.35}, {14, 4.5}, {15.2, 4.75}, {16.6, 5.15}, {18, 5.42}, {18.9, 5.5}, {20, 5.3}, {21.5, 4.7}},
      .distal = {{12, -4.4},
                 {14, -4.5},
                 {15.2, -4.85},
                 {16.6, -5.25},
                 {17.8, -5.47},
                 {18.4, -5.5},
                 {19.6, -5.3},
                 {21.5, -4.6}},
      .buccal = {{12, 4.4}, {14, 4.5}, {15, 4.95}, {16.2, 5.28}, {17, 5.15}, {18.5, 4.7}, {20, 4.15}, {21.5, 3.3}},
      .lingual =
          {{12, -4.4}, {14, -4.45}, {15.2, -4.6}, {16.5, -4.95}, {17.8, -5.2}, {18.6, -5.24}, {20, -4.9}, {21.5, -4.2}},
      .exponent_mesiobuccal = 3.0,
      .exponent_mesiolingual = 2.7,
      .exponent_distolingual = 2.6,
      .exponent_distobuccal = 2.4,
      .wider_mesially = 0.06,
      .wider_buccally = 0.05};
  s.furrows = {// mesiobuccal groove, ending in the buccal pit; distobuccal groove; lingual groove
               {Side::buccal, {{16, 0.5}, {20, 0.85}}, 0.55, {{16.2, 0.0}, {17.4, 0.3}, {20, 0.45}}},
               {Side::buccal, {{16, -2.9}, {20, -2.75}}, 0.5, {{16, 0.0}, {18, 0.22}, {20, 0.4}}},
               {Side::lingual, {{16, -0.15}, {20, 0.0}}, 0.6, {{17.4, 0.0}, {19, 0.22}, {20.5, 0.4}}},
               // hollows above the furcation
               {Side::buccal, {{10, 0.0}, {16, 0.2}}, 1.3, {{10, 0.5}, {13.0, 0.35}, {14.8, 0.0}}},
               {Side::lingual, {{10, 0.0}, {16, 0.0}}, 1.3, {{10, 0.5}, {13.0, 0.3}, {14.8, 0.0}}}};
  return s;
}

Occlusal molar_occlusal() {
  Occlusal o;
  o.cusps = {{"mesiobuccal", {2.6, 2.75, 21.1}, {0.9, 0.0}, 0.74, 1.5, 0.55, 0.6},
             {"distobuccal", {-0.95, 2.95, 20.95}, {-0.6, 0.0}, 0.7, 1.5, 0.6, 0.55},
             {"distal", {-3.95, 1.3, 20.4}, {-2.1, 0.0}, 0.7, 1.4, 0.6, 0.5, {0.57, 0.82}},
             {"mesiolingual", {2.3, -3.2, 21.5}, {0.7, -0.1}, 0.8, 1.5, 0.6, 0.45},
             {"distolingual", {-2.35, -3.15, 21.3}, {-1.2, -0.1}, 0.78, 1.5, 0.6, 0.45}};
  o.ridges = {{{{3.9, 2.2, 20.4}, {4.55, 0.8, 20.05}, {4.55, -1.0, 20.05}, {3.8, -2.6, 20.6}}, 1.1, 0.4},
              {{{-4.5, 0.5, 20.05}, {-4.75, -0.5, 19.8}, {-4.4, -1.7, 19.9}, {-3.6, -2.7, 20.5}}, 1.0, 0.4}};
  o.fissure_depth = 0.4;
  o.fissure_width = 0.4;
  o.supplemental_depth = 0.12;
  o.blend = 0.12;
  o.edge_blend = 0.7;
  return o;
}

std::vector<Root> molar_roots() {
  return {{.name = "mesial",
           .apex_z = 0,
           .blunt = 1.7,
           .x = {{0, 1.7}, {2.5, 2.65}, {6, 3.05}, {10, 2.5}, {12, 2.2}, {14, 2.2}},
           .y = {{0, -0.1}, {14, 0.0}},
           .half_mesiodistal = {{0, 0.9}, {3, 1.35}, {7, 1.8}, {10, 2.2}, {12, 2.25}, {14, 2.25}},
           .half_buccolingual = {{0, 1.0}, {3, 1.35}, {7, 1.75}, {11, 2.1}, {14, 2.2}},
           .lobe_offset = {{0, 0.95}, {3, 1.35}, {7, 1.85}, {11, 2.15}, {14, 2.25}}},
          {.name = "distal",
           .apex_z = 0.8,
           .blunt = 1.6,
           .x = {{0.8, -4.4}, {3, -3.95}, {7, -3.1}, {10, -2.5}, {12, -2.2}, {14, -2.2}},
           .y = {{0.8, -0.1}, {14, 0.0}},
           .half_mesiodistal = {{0.8, 0.85}, {4, 1.4}, {7, 1.75}, {10, 2.3}, {12, 2.3}, {14, 2.25}},
           .half_buccolingual = {{0.8, 1.4}, {4, 2.3}, {8, 3.2}, {11, 3.85}, {14, 4.3}},
           .lobe_offset = 0.0,
           .exponent = 2.0}};
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
  t.sides = molar_sides();
  t.occlusal = molar_occlusal();
  t.enamel = {1.6, 4.0, 1.6};
  t.roots = molar_roots();
  t.root_blend = 1.2;
  t.trunk_low_z = 11.0;
  t.trunk_high_z = 14.4;
  t.chamber = {{-3.1, -2.5, 13.5}, {3.1, 2.5, 15.6}, 3.0, 0.8};
  t.horns = {{"mesiobuccal", {2.2, 1.7, 14.9}, {2.35, 2.1, 17.2}, 0.75, 0.15},
             {"distobuccal", {-0.9, 1.7, 14.9}, {-0.95, 2.2, 16.9}, 0.7, 0.15},
             {"distal", {-2.5, 0.7, 14.8}, {-2.95, 1.1, 16.5}, 0.65, 0.15},
             {"mesiolingual", {2.1, -1.8, 14.9}, {2.2, -2.4, 17.4}, 0.7, 0.15},
             {"distolingual", {-2.0, -1.8, 14.9}, {-2.1, -2.3, 17.1}, 0.7, 0.15}};
  const Profile narrow{{0.5, 0.17}, {3, 0.24}, {8, 0.36}, {12, 0.48}, {14, 0.6}};
  t.canals = {
      {"mesiobuccal", 0, 1, narrow, narrow},
      {"mesiolingual", 0, -1, narrow, narrow},
      {"distal", 1, 0, {{1.3, 0.2}, {4, 0.28}, {9, 0.42}, {14, 0.65}}, {{1.3, 0.3}, {4, 0.55}, {9, 1.0}, {14, 1.4}}}};
  t.canal_top_z = 14.8;
  t.pulp_blend = 0.45;
  return t;
}

}  // namespace odontoscope::sample
