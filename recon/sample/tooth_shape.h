#pragma once
// The anatomy of a sample tooth as numbers: what tooth_field.h turns into solids. One table a tooth, in assets/teeth,
// read by tooth_table.h. Axes and units as in sample_tooth.h; profiles are functions of z unless they say
// otherwise.

#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/sample/profile.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::sample {

enum class Side { mesial, distal, buccal, lingual };

/// A vertical furrow (depth > 0) or ridge (depth < 0) on one side of the crown, running over the height where depth is
/// not 0.
struct Furrow {
  Side side = Side::buccal;
  Profile place;       // of its bottom: x on the buccal and lingual side, y on the others
  double width = 0.5;  // at which its depth has fallen to 1/e
  Profile depth;
};

/// A range of heights.
struct Zone {
  double low = 0, high = 0;
};

/// Horizontal sections of the crown: superellipses, in trapezoid taper, given by how far they reach to each side.
struct CrownSides {
  Profile mesial, distal, buccal, lingual;  // x, x, y, y of the outermost points, before taper
  double exponent_mesiobuccal = 2, exponent_mesiolingual = 2, exponent_distolingual = 2, exponent_distobuccal = 2;
  double wider_mesially = 0;  // growth of the buccolingual width from the middle to the mesial side
  double wider_buccally = 0;  // growth of the mesiodistal width from the middle to the buccal side
  std::vector<Furrow> furrows = {};
};

/// A four-sided pyramid with rounded tip and edges; its edges are the cusp's four ridges: the triangular ridge down to
/// the fossa, the outer ridge away from it, and the two cusp ridges along the margin of the crown.
struct Cusp {
  std::string name;
  Point3 tip;
  Point2 inward;                                              // a point that the triangular ridge runs to
  double slope_in = 0.6, slope_out = 1.6, slope_along = 0.5;  // fall of the ridges, mm/mm
  double rounding = 0.6;                                      // height over which the tip is round
  Point2 along = {1, 0};                                      // direction of the cusp ridges, unit
};

/// A crest along a polyline that falls to both sides: marginal ridges and the incisal edge.
struct Ridge {
  std::vector<Point3> crest;
  double slope = 0.6;
  double rounding = 0.3;
};

struct Occlusal {
  std::vector<Cusp> cusps;
  std::vector<Ridge> ridges;
  double fissure_depth = 0, fissure_width = 0.3;  // the width is counted in height above the fissure's bottom
  double fissure_round = 0;                       // 0: a crack with a sharp bottom, 1: a groove with a round one
  double supplemental_depth = 0;                  // of the shallow grooves on both sides of each triangular ridge
  double blend = 0.2;                             // over which neighbouring cusps flow together, mm of height
  double edge_blend = 0.6;                        // over which the top rounds into the sides
};

/// Height of the cervical line (enamel-cement line): lowest on the buccal side, rising by so much on the others.
struct CervicalLine {
  double z = 0, rise_mesial = 0, rise_distal = 0, rise_lingual = 0;
};

struct Enamel {
  double side = 1.4;       // thickness that the sides approach far above the cervical line
  double side_height = 5;  // the larger, the slower they do
  double top = 1.6;        // vertical thickness under cusps and fossae
  double highest_dentine =
      1e3;  // z at which the dentine is cut off flat: an edge too thin to be followed from slice to slice
  // Crests that the dentine keeps below besides: the edge of an incisor's dentine with its mamelons.
  std::vector<Ridge> dentine_edge = {};
  // Below 1: a margin blunter than a knife's edge, so that its sections in neighbouring slices overlap.
  double margin_exponent = 0.7;
  // Height above the cervical line at which it starts: where it is thick enough for the sampling grid.
  double margin_height = 0.1;
};

/// A root: a section swept along a curved axis down to a blunt apex. With an offset it has two lobes, buccal and
/// lingual of the axis: the hourglass section of a root with two canals.
struct Root {
  std::string name;
  double apex_z = 0;
  double blunt = 1.5;  // length over which the apex rounds off
  Profile x, y;        // axis
  Profile half_mesiodistal;
  Profile half_buccolingual;  // of the root, or of each lobe
  Profile lobe_offset;        // 0: one lobe
  double exponent = 2.2;
  Profile groove = {};  // depth of the hollows along its mesial and distal side
  double groove_width = 1;
  double wider_buccally = 0;  // growth of the mesiodistal width from the middle to the buccal side
  double cut = 0;             // so much of the rounded tip is missing below the apex: an open one's rim
};

struct Canal {
  std::string name;
  std::size_t root = 0;
  double lobe = 0;  // +1 in the buccal lobe, -1 in the lingual, 0 on the axis
  Profile half_mesiodistal, half_buccolingual;
  bool open = false;                   // runs out of the apex, else ends apical_stop above it
  double constriction = 0;             // radius where it is narrowest, just above the apex; 0: as the widths have it
  double foramen = 0;                  // radius to which it widens from there to the apex
  Profile shift_x = {}, shift_y = {};  // of its centre from where root and lobe put it
};

/// A round tube, narrowing evenly, with round ends.
struct Horn {
  std::string name;
  Point3 base, tip;
  double base_radius = 0.6, tip_radius = 0.2;
  double blend = 0;  // width of its fillet with the chamber; 0: pulp_blend
};

struct PulpChamber {
  Point3 low, high;       // corners of the box that it fills
  double exponent = 2.6;  // of its horizontal section
  double rounding = 0.8;  // of the edges of floor and roof
  // Where the walls are not upright: the middle and half the width of its section, instead of the box's.
  Profile x = {}, y = {}, half_mesiodistal = {}, half_buccolingual = {};
  double wider_mesially = 0;  // growth of the buccolingual width from the middle to the mesial side
};

struct ToothShape {
  ToothKind kind = ToothKind::molar;
  std::string tooth, fdi;
  Proportions proportions;
  double top_z = 0;
  std::vector<Zone> steep;  // besides those that steep_zones() knows: fissures, cusps, edges
  CervicalLine cervical_line;
  CrownSides sides;
  Occlusal occlusal;
  Enamel enamel;
  std::vector<Root> roots;
  double root_blend = 0.8;                   // width of the fillet between the roots
  double trunk_low_z = 0, trunk_high_z = 0;  // the roots' section turns into the crown's between these
  PulpChamber chamber;
  std::vector<Horn> horns;
  std::vector<Canal> canals;
  std::vector<Horn> accessory_canals;  // from the pulp out of the root's side or its furcation
  double canal_top_z = 0;              // inside the chamber
  double pulp_blend = 0.4;             // width of the fillets between chamber, horns and canals
  double orifice_blend = 0;            // of those between chamber and canals; 0: pulp_blend
  std::vector<NamedPoint> landmarks;   // reported as cusps if there are none
};

/// The canals' blind ends lie so far above their root's apex, mm, and an open one's constriction.
inline constexpr double apical_stop = 0.5, constriction_height = 0.75;

}  // namespace odontoscope::sample
