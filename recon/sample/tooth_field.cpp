#include "recon/sample/tooth_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/core/portable_math.h"
#include "recon/sample/implicit.h"

namespace odontoscope::sample {
namespace {

struct CuspHeight {
  double z = 0;       // that the cusp alone would give the surface
  double inward = 0;  // distance from the line of its cusp ridges, positive towards the fossa
  double along = 0;   // distance from its triangular ridge
};

CuspHeight cusp_height(const Cusp& cusp, Point2 at) {
  const double ix = cusp.inward.x - cusp.tip.x, iy = cusp.inward.y - cusp.tip.y, dx = at.x - cusp.tip.x,
               dy = at.y - cusp.tip.y;
  const Point2 s = cusp.along;
  const double inward_of_ridge = s.x * iy - s.y * ix;  // of the triangular ridge's far end
  const double inward = (s.x * dy - s.y * dx) * (inward_of_ridge > 0 ? 1 : -1);
  constexpr double crest_rounding = 0.2;  // mm across the cusp ridges
  const double across = portable::hypot(inward, crest_rounding) - crest_rounding;
  double fall_across = cusp.slope_out * across;
  double along = s.x * dx + s.y * dy;
  if (inward > 0) {
    // The triangular ridge may run aslant of the cusp ridges: measure along it, and sideways from it.
    const double share = inward / std::abs(inward_of_ridge);
    fall_across = cusp.slope_in * across * portable::hypot(ix, iy) / std::abs(inward_of_ridge);
    along -= share * (s.x * ix + s.y * iy);
  }
  // An exponent between 1 (sharp edges) and 2 (a cone) rounds the four ridges.
  constexpr double n = 1.5;
  const double fall =
      portable::pow(portable::pow(fall_across, n) + portable::pow(cusp.slope_along * std::abs(along), n), 1 / n);
  return {cusp.tip.z - (portable::hypot(fall, cusp.rounding) - cusp.rounding), inward, std::abs(along)};
}

/// Depth, 0 to 1, of the shallow grooves that part the triangular ridge from the slopes beside it.
double supplemental_groove(const CuspHeight& cusp) {
  constexpr double begin = 0.3, full = 1.0, place = 0.35, spread = 0.45,
                   width = 0.3;  // mm; spread: mm/mm of widening fossawards
  const double away = (cusp.along - place - spread * cusp.inward) / width;
  return smooth_step(begin, full, cusp.inward) * portable::exp(-away * away);
}

/// Thickness of the enamel on the sides, at a height above the cervical line.
double side_thickness(const Enamel& enamel, double above) {
  return above > 0 ? enamel.side * portable::pow(above / (above + enamel.side_height), enamel.margin_exponent) : 0.0;
}

/// Depth of a fissure that is `depth` deep at a closeness of 0 to 1 to its bottom line.
double fissure(double depth, double closeness, double round) {
  const double crack = depth * closeness * std::sqrt(closeness);
  return round > 0 ? (1 - round) * crack + round * depth * smooth_step(0, 1, closeness) : crack;
}

/// Half the width of a canal where it is `own` by its table: round and narrow towards the constriction, and flaring
/// from there to the foramen.
double narrowed(const Canal& canal, double own, double above_apex) {
  if (canal.constriction <= 0) return own;
  constexpr double taper_begin = 3;  // mm above the apex
  if (above_apex < constriction_height) {
    if (!canal.open) return canal.constriction;
    const double beyond = 1 - std::max(above_apex, 0.0) / constriction_height;
    return canal.constriction + (canal.foramen - canal.constriction) * beyond * std::sqrt(beyond);
  }
  return canal.constriction + (own - canal.constriction) * smooth_step(constriction_height, taper_begin, above_apex);
}

/// Share of its section that a root has at a height: less where its tip rounds off.
double root_end(const Root& root, double z) {
  return z < root.apex_z ? 0.0 : blunt_end(z - root.apex_z + root.cut, root.blunt);
}

constexpr double taper_end = 1.5;  // half widths from the middle, outside, where a taper would turn over

double ridge_height(const Ridge& ridge, Point2 at) {
  double best = -far_outside;
  for (std::size_t i = 0; i + 1 < ridge.crest.size(); ++i) {
    const Point3 &a = ridge.crest[i], &b = ridge.crest[i + 1];
    double along = 0;
    const double away = segment_distance({at.x, at.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0}, along);
    const double crest = a.z + along * (b.z - a.z);
    best = std::max(best, crest - (portable::hypot(ridge.slope * away, ridge.rounding) - ridge.rounding));
  }
  return best;
}

}  // namespace

OcclusalHeights occlusal_heights(const ToothShape& shape, Point2 at) {
  const Occlusal& occlusal = shape.occlusal;
  double outer = -far_outside, smoother = -far_outside;
  const auto join = [&](double height, double blend, double smoother_blend) {
    outer = smooth_max(outer, height, blend);
    smoother = smooth_max(smoother, height, smoother_blend);
  };
  CuspHeight highest{-far_outside, 0, 0}, second = highest;
  for (const Cusp& cusp : occlusal.cusps) {
    CuspHeight height = cusp_height(cusp, at);
    join(height.z - occlusal.supplemental_depth * supplemental_groove(height), occlusal.blend, 3 * occlusal.blend);
    if (height.z > highest.z) std::swap(height, highest);
    if (height.z > second.z) second = height;
  }
  for (const Ridge& ridge : occlusal.ridges) join(ridge_height(ridge, at), 2 * occlusal.blend, 4 * occlusal.blend);
  double dentine = std::min(smoother - shape.enamel.top, shape.enamel.highest_dentine);
  constexpr double edge_fillet = 0.5;  // mm
  for (const Ridge& edge : shape.enamel.dentine_edge)
    dentine = smooth_min(dentine, ridge_height(edge, at), edge_fillet);
  // A fissure runs where the second highest cusp is as high as the surface: between two cusps, not across a ridge.
  // Beyond the margin of the occlusal surface the grooves of the sides take over.
  constexpr double fade_begin = -0.3, fade_end = -1.1;  // mm
  const double inside = smooth_step(fade_end, fade_begin, std::min(highest.inward, second.inward));
  const double closeness = std::clamp(1 - (outer - second.z) / occlusal.fissure_width, 0.0, 1.0);
  return {outer - fissure(inside * occlusal.fissure_depth, closeness, occlusal.fissure_round), dentine};
}

ToothSection::ToothSection(const ToothShape& shape, double z)
    : shape_(shape), z_(z), crown_share_(smooth_step(shape.trunk_low_z, shape.trunk_high_z, z)) {
  const CrownSides& sides = shape.sides;
  crown_middle_ = {(sides.mesial(z) + sides.distal(z)) / 2, (sides.buccal(z) + sides.lingual(z)) / 2};
  crown_half_ = {(sides.mesial(z) - sides.distal(z)) / 2, (sides.buccal(z) - sides.lingual(z)) / 2};
  for (const Furrow& furrow : sides.furrows)
    if (furrow.depth(z) != 0) grooves_.push_back({furrow.side, furrow.place(z), furrow.width, furrow.depth(z)});
  for (const Root& root : shape.roots) {
    const double shrunk = root_end(root, z);
    if (shrunk <= 0) continue;
    roots_.push_back({{root.x(z), root.y(z)},
                      shrunk * root.half_mesiodistal(z),
                      shrunk * root.half_buccolingual(z),
                      root.exponent,
                      shrunk * root.lobe_offset(z),
                      shrunk * root.groove(z),
                      root.groove_width,
                      root.wider_buccally});
  }
  constexpr double round_end = 0.35, round_orifice = 0.6;  // mm
  for (const Canal& canal : shape.canals) {
    const double end = shape.roots[canal.root].apex_z + apical_stop;
    const double shrunk =
        std::min(canal.open ? 1.0 : blunt_end(z - end, round_end), blunt_end(shape.canal_top_z - z, round_orifice));
    if (shrunk <= 0) continue;
    const Point3 centre = canal_centre(shape, canal, z);
    const double above_apex = z - shape.roots[canal.root].apex_z;
    canals_.push_back({{centre.x, centre.y},
                       shrunk * narrowed(canal, canal.half_mesiodistal(z), above_apex),
                       shrunk * narrowed(canal, canal.half_buccolingual(z), above_apex)});
  }
  const PulpChamber& box = shape.chamber;
  chamber_ = {{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2},
              (box.high.x - box.low.x) / 2,
              (box.high.y - box.low.y) / 2,
              box.exponent};
  if (box.half_mesiodistal.knots().front().value > 0)
    chamber_ = {{box.x(z), box.y(z)}, box.half_mesiodistal(z), box.half_buccolingual(z), box.exponent};
}

double ToothSection::root(const Ellipse& s, Point2 at) {
  double u = at.x - s.centre.x;
  const double v = at.y - s.centre.y;
  if (s.wider_buccally != 0) u /= 1 + s.wider_buccally * std::clamp(v / s.b, -taper_end, taper_end);
  if (s.groove > 0) {
    const double away = v / s.groove_width;
    return superellipse(u, v, s.a, s.b, s.exponent) + s.groove * portable::exp(-away * away);
  }
  if (s.lobe_offset <= 0) return superellipse(u, v, s.a, s.b, s.exponent);
  // The waist between the lobes is filled over the width of a lobe.
  return smooth_min(superellipse(u, v - s.lobe_offset, s.a, s.b, s.exponent),
                    superellipse(u, v + s.lobe_offset, s.a, s.b, s.exponent), s.a);
}

double ToothSection::crown(Point2 at) const {
  const CrownSides& sides = shape_.sides;
  const double a = crown_half_.x, b = crown_half_.y, dx = at.x - crown_middle_.x, dy = at.y - crown_middle_.y;
  const double u = dx / (1 + sides.wider_buccally * std::clamp(dy / b, -taper_end, taper_end));
  const double v = dy / (1 + sides.wider_mesially * std::clamp(dx / a, -taper_end, taper_end));
  const double exponent = u > 0 ? (v > 0 ? sides.exponent_mesiobuccal : sides.exponent_mesiolingual)
                                : (v > 0 ? sides.exponent_distobuccal : sides.exponent_distolingual);
  double distance = superellipse(u, v, a, b, exponent);
  for (const Groove& groove : grooves_) {
    const bool across_x = groove.side == Side::buccal || groove.side == Side::lingual;
    const bool positive = groove.side == Side::buccal || groove.side == Side::mesial;
    const double outward = (positive ? 1 : -1) * (across_x ? v / b : u / a);
    const double away = ((across_x ? at.x : at.y) - groove.place) / groove.width;
    // Only near its own side of the crown.
    distance += groove.depth * portable::exp(-away * away) * smooth_step(0.2, 0.7, outward);
  }
  return distance;
}

double ToothSection::side(Point2 at) const {
  const double crown_here = crown_share_ > 0 ? crown(at) : 0.0;
  if (crown_share_ >= 1) return crown_here;
  double roots = far_outside;
  for (const Ellipse& section : roots_) roots = smooth_min(roots, root(section, at), shape_.root_blend);
  return crown_share_ * crown_here + (1 - crown_share_) * roots;
}

HardTissue ToothSection::hard_tissue(const OcclusalHeights& heights, Point2 at) const {
  const double side_distance = side(at), blend = shape_.occlusal.edge_blend;
  // Vertical distances overstate the distance to slopes; this brings those of the usual cusp slope to scale.
  constexpr double to_distance = 0.8;
  const double above = z_ - cervical_height(shape_, at);
  return {smooth_max(side_distance, to_distance * (z_ - heights.enamel), blend),
          smooth_max(side_distance + side_thickness(shape_.enamel, above), to_distance * (z_ - heights.dentine), blend),
          shape_.enamel.margin_height - above};
}

double ToothSection::chamber(Point2 at) const {
  const PulpChamber& box = shape_.chamber;
  const double c = (box.high.z - box.low.z) / 2;
  const double up = std::abs(z_ - (box.low.z + box.high.z) / 2) / c;
  constexpr double far = 1.0;
  const double beyond = (up - 1) * c;
  if (beyond > far) return beyond;
  // A superellipsoid: its section is a superellipse that shrinks towards floor and roof, its distance that to the
  // nearer of wall and lid.
  const double u = at.x - chamber_.centre.x;
  double v = at.y - chamber_.centre.y;
  if (box.wider_mesially != 0) v /= 1 + box.wider_mesially * std::clamp(u / chamber_.a, -taper_end, taper_end);
  return smooth_max(superellipse(u, v, chamber_.a, chamber_.b, chamber_.exponent), beyond, std::min(c, box.rounding));
}

double ToothSection::pulp(Point2 at) const {
  double distance = chamber(at);
  for (const std::vector<Horn>* tubes : {&shape_.horns, &shape_.accessory_canals}) {
    for (const Horn& tube : *tubes) {
      double along = 0;
      const double away = segment_distance({at.x, at.y, z_}, tube.base, tube.tip, along);
      distance = smooth_min(distance, away - tube.base_radius - along * (tube.tip_radius - tube.base_radius),
                            tube.blend > 0 ? tube.blend : shape_.pulp_blend);
    }
  }
  const double orifice = shape_.orifice_blend > 0 ? shape_.orifice_blend : shape_.pulp_blend;
  for (const Ellipse& canal : canals_) distance = smooth_min(distance, root(canal, at), orifice);
  return distance;
}

double cervical_height(const ToothShape& shape, Point2 at) {
  const CervicalLine& line = shape.cervical_line;
  const double square = at.x * at.x + at.y * at.y;
  if (square <= 0) return line.z;
  const double along_x = at.x * at.x / square, along_y = at.y * at.y / square;
  return line.z + along_x * (at.x > 0 ? line.rise_mesial : line.rise_distal) +
         (at.y < 0 ? along_y * line.rise_lingual : 0.0);
}

Point3 canal_centre(const ToothShape& shape, const Canal& canal, double z) {
  const Root& root = shape.roots[canal.root];
  const double shrunk = root_end(root, z);
  return {root.x(z) + canal.shift_x(z), root.y(z) + canal.lobe * shrunk * root.lobe_offset(z) + canal.shift_y(z), z};
}

}  // namespace odontoscope::sample
