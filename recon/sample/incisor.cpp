// Upper right central incisor (FDI 11), after Wheeler: crown 10.5 mm, root 13 mm; mesiodistal 8.5 mm (cervix 7.0),
// labiolingual 7.0 mm (cervix 6.0); the cervical line rises 3.5 mm mesially and 2.5 mm distally, more than on any other
// tooth. Square mesial and rounded distal corner, cingulum, lingual fossa between marginal ridges, a conical root with
// a blunt apex.

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {
namespace {

CrownSides incisor_sides() {
  CrownSides s{
      .mesial = {{9, 3.1}, {11, 3.37}, {13, 3.5}, {15, 3.7}, {18, 4.05}, {21.5, 4.25}, {22.6, 4.22}, {23.5, 4.05}},
      .distal =
          {{9, -3.1}, {11, -3.37}, {13, -3.5}, {15, -3.75}, {18, -4.12}, {20.3, -4.25}, {21.8, -4.18}, {23.5, -3.6}},
      .buccal = {{9, 2.75},
                 {11, 2.92},
                 {13, 3.0},
                 {14.4, 3.45},
                 {15.2, 3.5},
                 {17.5, 3.2},
                 {20, 2.5},
                 {22, 1.65},
                 {23.5, 0.9}},
      .lingual = {{9, -2.75},
                  {11, -2.92},
                  {13, -3.0},
                  {14.2, -3.45},
                  {14.8, -3.5},
                  {16, -3.1},
                  {17.5, -2.1},
                  {19.5, -1.0},
                  {21.5, -0.45},
                  {23.5, -0.1}},
      .exponent_mesiobuccal = 2.4,
      .exponent_mesiolingual = 2.2,
      .exponent_distolingual = 2.2,
      .exponent_distobuccal = 2.3,
      .wider_buccally = 0.08};
  s.furrows = {// lingual fossa and the marginal ridges beside it
               {Side::lingual, {{16, -0.1}, {22, 0.0}}, 1.9, {{15.6, 0.0}, {17.5, 0.5}, {20, 0.45}, {22.5, 0.05}}},
               {Side::lingual, {{16, 1.9}, {22, 3.1}}, 0.7, {{15.5, 0.0}, {17.5, -0.3}, {20, -0.3}, {22.5, 0.0}}},
               {Side::lingual, {{16, -2.0}, {22, -3.1}}, 0.7, {{15.5, 0.0}, {17.5, -0.3}, {20, -0.3}, {22.5, 0.0}}},
               // labial developmental depressions between the three lobes
               {Side::buccal, {{17, 1.3}, {23, 1.5}}, 0.7, {{17.5, 0.0}, {20.5, 0.12}, {23, 0.14}}},
               {Side::buccal, {{17, -1.3}, {23, -1.5}}, 0.7, {{17.5, 0.0}, {20.5, 0.12}, {23, 0.14}}}};
  return s;
}

Occlusal incisor_occlusal() {
  Occlusal o;
  o.ridges = {{{{4.0, 0.35, 23.2},
                {3.5, 0.38, 23.38},
                {2.7, 0.4, 23.48},
                {1.0, 0.4, 23.5},
                {-1.0, 0.4, 23.47},
                {-2.2, 0.4, 23.35},
                {-3.0, 0.38, 23.15},
                {-3.6, 0.35, 22.8}},
               1.0,
               0.3}};
  o.blend = 0.15;
  o.edge_blend = 0.35;
  return o;
}

}  // namespace

ToothShape incisor() {
  ToothShape t;
  t.kind = ToothKind::incisor;
  t.tooth = "upper right central incisor (FDI 11)";
  t.fdi = "11";
  t.proportions = {10.5, 13.0, 8.5, 7.0, 7.0, 6.0, 3.5, 2.5};
  t.top_z = 23.5;
  t.cervical_line = {13.0, 3.5, 2.5, 0.0};
  t.sides = incisor_sides();
  t.occlusal = incisor_occlusal();
  t.enamel = {1.0, 3.5, 1.6, 21.3};
  t.roots = {{.name = "root",
              .apex_z = 0,
              .blunt = 2.0,
              .x = {{0, -0.45}, {4, -0.15}, {9, 0.0}, {13, 0.0}},
              .y = {{0, -0.1}, {13, 0.0}},
              .half_mesiodistal = {{0, 1.35}, {4, 2.2}, {9, 3.1}, {11, 3.37}, {13, 3.5}},
              .half_buccolingual = {{0, 1.3}, {4, 2.05}, {9, 2.75}, {11, 2.92}, {13, 3.0}},
              .lobe_offset = 0.0,
              .exponent = 2.1}};
  t.trunk_low_z = 9;
  t.trunk_high_z = 13;
  t.chamber = {{-1.4, -0.5, 14.0}, {1.4, 0.85, 17.4}, 2.0, 1.4};
  t.horns = {{"mesial", {0.75, 0.3, 16.2}, {1.6, 0.75, 19.2}, 0.55, 0.2},
             {"middle", {0.0, 0.3, 16.2}, {0.0, 0.75, 18.7}, 0.55, 0.2},
             {"distal", {-0.75, 0.3, 16.2}, {-1.55, 0.75, 18.9}, 0.55, 0.2}};
  t.canals = {{"root canal",
               0,
               0,
               {{0.5, 0.22}, {5, 0.45}, {10, 0.8}, {13, 1.1}, {15, 1.3}},
               {{0.5, 0.22}, {5, 0.45}, {10, 0.7}, {15, 0.8}}}};
  t.canal_top_z = 16.0;
  t.pulp_blend = 0.4;
  t.landmarks = {{"mesioincisal angle", {4.0, 0.35, 23.2}}, {"distoincisal angle", {-3.6, 0.35, 22.8}}};
  return t;
}

}  // namespace odontoscope::sample
