// Upper right first premolar (FDI 14), after Wheeler: crown 8.5 mm, root 14 mm; mesiodistal 7.0 mm (cervix 5.0),
// buccolingual 9.0 mm (cervix 8.0). The buccal cusp is 1 mm higher than the lingual and stands distal of the middle;
// the lingual one leans mesially. Two roots, parted for half their length; the hollow of the mesial side runs from the
// root onto the crown.

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {
namespace {

CrownSides premolar_sides() {
  CrownSides s{
      .mesial = {{10, 2.3},
                 {12, 2.42},
                 {14, 2.53},
                 {15.5, 2.8},
                 {17.5, 3.35},
                 {18.6, 3.5},
                 {19.8, 3.35},
                 {21, 2.9},
                 {22.5, 2.2}},
      .distal = {{10, -2.3},
                 {12, -2.42},
                 {14, -2.53},
                 {15.5, -2.85},
                 {17.3, -3.4},
                 {18.3, -3.5},
                 {19.6, -3.35},
                 {21, -2.85},
                 {22.5, -2.1}},
      .buccal = {{12, 3.9}, {14, 4.0}, {15, 4.3}, {16.4, 4.5}, {18.2, 4.3}, {20, 3.85}, {22.5, 2.9}},
      .lingual =
          {{12, -3.9}, {14, -4.0}, {15.5, -4.2}, {17.4, -4.48}, {18.2, -4.5}, {19.6, -4.2}, {21.5, -3.2}, {22.5, -2.7}},
      .exponent_mesiobuccal = 2.3,
      .exponent_mesiolingual = 2.1,
      .exponent_distolingual = 2.1,
      .exponent_distobuccal = 2.3,
      .wider_buccally = 0.08};
  s.furrows = {
      // mesial developmental depression and the groove over the mesial marginal ridge; a fainter hollow distally
      {Side::mesial, -0.2, 1.1, {{11, 0.4}, {14.5, 0.45}, {16.5, 0.25}, {17.8, 0.0}}},
      {Side::mesial, -0.4, 0.45, {{17.6, 0.0}, {19, 0.14}, {21, 0.2}}},
      {Side::distal, 0.0, 1.1, {{11, 0.35}, {13.5, 0.3}, {15.2, 0.0}}},
      // between the three labial lobes
      {Side::buccal, {{16, 1.4}, {21, 1.35}}, 0.5, {{17, 0.0}, {19.5, 0.13}, {21.5, 0.15}}},
      {Side::buccal, {{16, -1.7}, {21, -1.6}}, 0.5, {{17, 0.0}, {19.5, 0.13}, {21.5, 0.15}}}};
  return s;
}

Occlusal premolar_occlusal() {
  Occlusal o;
  o.cusps = {{"buccal", {-0.2, 2.65, 22.5}, {-0.1, 0.0}, 0.82, 1.5, 0.7, 0.3},
             {"lingual", {0.4, -2.7, 21.5}, {0.2, 0.0}, 0.66, 1.4, 0.55, 0.45}};
  o.ridges = {{{{2.55, 1.9, 20.7}, {2.95, 0.4, 20.0}, {2.9, -0.8, 19.9}, {2.35, -2.2, 20.4}}, 0.8, 0.3},
              {{{-2.6, 1.8, 20.6}, {-2.95, 0.3, 19.9}, {-2.85, -0.9, 19.9}, {-2.2, -2.2, 20.4}}, 0.8, 0.3}};
  o.fissure_depth = 0.45;
  o.fissure_width = 0.4;
  o.supplemental_depth = 0.08;
  o.blend = 0.15;
  o.edge_blend = 0.6;
  return o;
}

std::vector<Root> premolar_roots() {
  return {{.name = "buccal",
           .apex_z = 0,
           .blunt = 1.3,
           .x = {{0, -0.55}, {3, -0.15}, {7, 0.0}, {14, 0.0}},
           .y = {{0, 2.2}, {3, 2.35}, {6, 2.2}, {10, 1.95}, {14, 1.9}},
           .half_mesiodistal = {{0, 0.8}, {3, 1.3}, {7, 1.85}, {10, 2.25}, {12, 2.4}, {14, 2.5}},
           .half_buccolingual = {{0, 0.8}, {3, 1.25}, {6, 1.65}, {9, 2.0}, {14, 2.1}},
           .lobe_offset = 0.0},
          {.name = "lingual",
           .apex_z = 0.6,
           .blunt = 1.3,
           .x = {{0.6, -0.45}, {3, -0.1}, {7, 0.0}, {14, 0.0}},
           .y = {{0.6, -2.0}, {3, -2.25}, {6, -2.15}, {10, -1.95}, {14, -1.9}},
           .half_mesiodistal = {{0.6, 0.75}, {3, 1.2}, {7, 1.8}, {10, 2.2}, {12, 2.35}, {14, 2.45}},
           .half_buccolingual = {{0.6, 0.75}, {3, 1.15}, {6, 1.6}, {9, 1.95}, {14, 2.1}},
           .lobe_offset = 0.0}};
}

}  // namespace

ToothShape premolar() {
  ToothShape t;
  t.kind = ToothKind::premolar;
  t.tooth = "upper right first premolar (FDI 14)";
  t.fdi = "14";
  t.proportions = {8.5, 14.0, 7.0, 5.0, 9.0, 8.0, 1.0, 0.0};
  t.top_z = 22.5;
  t.cervical_line = {14.0, 1.0, 0.15, 0.2};
  t.sides = premolar_sides();
  t.occlusal = premolar_occlusal();
  t.enamel = {1.45, 4.0, 1.6};
  t.roots = premolar_roots();
  t.root_blend = 1.6;
  t.trunk_low_z = 10.5;
  t.trunk_high_z = 14.2;
  t.chamber = {{-0.75, -2.4, 12.4}, {0.75, 2.4, 15.6}, 2.6, 0.8};
  t.horns = {{"buccal", {-0.05, 1.7, 14.8}, {-0.15, 2.15, 17.9}, 0.6, 0.2},
             {"lingual", {0.1, -1.7, 14.8}, {0.3, -2.15, 17.1}, 0.6, 0.2}};
  const Profile radius{{0.5, 0.19}, {4, 0.3}, {9, 0.42}, {13, 0.6}};
  t.canals = {{"buccal", 0, 0, radius, radius}, {"lingual", 1, 0, radius, radius}};
  t.canal_top_z = 13.8;
  t.pulp_blend = 0.4;
  return t;
}

}  // namespace odontoscope::sample
