#include "recon/sample/tooth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odontoscope::sample {
namespace {

constexpr double far_outside = 1e3;   // mm; larger than any tooth

double smooth_min(double a, double b, double width) {
  const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - overlap * overlap * width / 4;
}

double smooth_max(double a, double b, double width) { return -smooth_min(-a, -b, width); }

double smooth_step(double low, double high, double at) {
  const double t = std::clamp((at - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// First-order distance to |u/a|^n + |v/b|^n = 1.
double superellipse(double u, double v, double a, double b, double n) {
  const double p = std::abs(u) / a, q = std::abs(v) / b;
  const double sum = std::pow(p, n) + std::pow(q, n);
  if (sum <= 0) return -std::min(a, b);
  const double radius = std::pow(sum, 1 / n);
  const double gradient = std::pow(radius, 1 - n) * std::hypot(std::pow(p, n - 1) / a, std::pow(q, n - 1) / b);
  return (radius - 1) / gradient;
}

double segment_distance(const Point3& p, const Point3& a, const Point3& b, double& along) {
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
  const double t = ((p.x - a.x) * dx + (p.y - a.y) * dy + (p.z - a.z) * dz) / (dx * dx + dy * dy + dz * dz);
  along = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy, p.z - a.z - along * dz);
}

/// Height that a cusp alone would give the surface at `at`.
double cusp_height(const Cusp& cusp, Point2 at) {
  const double ix = cusp.inward.x - cusp.tip.x, iy = cusp.inward.y - cusp.tip.y, length = std::hypot(ix, iy);
  const double dx = at.x - cusp.tip.x, dy = at.y - cusp.tip.y;
  const double in = (dx * ix + dy * iy) / length, side = (dy * ix - dx * iy) / length;
  // An exponent between 1 (sharp edges) and 2 (a cone) rounds the four ridges.
  constexpr double ridge_exponent = 1.45;
  const double fall_in = (in > 0 ? cusp.slope_in : cusp.slope_out) * std::abs(in), fall_side = cusp.slope_side * std::abs(side);
  const double fall = std::pow(std::pow(fall_in, ridge_exponent) + std::pow(fall_side, ridge_exponent), 1 / ridge_exponent);
  return cusp.tip.z - (std::hypot(fall, cusp.rounding) - cusp.rounding);
}

double ridge_height(const Ridge& ridge, Point2 at) {
  double best = -far_outside;
  for (std::size_t i = 0; i + 1 < ridge.crest.size(); ++i) {
    const Point3 &a = ridge.crest[i], &b = ridge.crest[i + 1];
    double along = 0;
    const double away = segment_distance({at.x, at.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0}, along);
    const double crest = a.z + along * (b.z - a.z);
    best = std::max(best, crest - (std::hypot(ridge.slope * away, ridge.rounding) - ridge.rounding));
  }
  return best;
}

double root_section(const Root& root, const Point3& at) {
  const double shrunk = blunt_end(at.z - root.apex_z, root.blunt);
  if (shrunk <= 0) return far_outside;
  const double u = at.x - root.x(at.z), v = at.y - root.y(at.z);
  const double a = shrunk * root.half_mesiodistal(at.z), b = shrunk * root.half_buccolingual(at.z);
  const double offset = shrunk * root.lobe_offset(at.z);
  if (offset <= 0) return superellipse(u, v, a, b, root.exponent);
  // The waist between the lobes is filled over the width of a lobe.
  return smooth_min(superellipse(u, v - offset, a, b, root.exponent), superellipse(u, v + offset, a, b, root.exponent), a);
}

double furrow_depth(const Furrow& furrow, double u, double v, const Point3& at) {
  const double depth = furrow.depth(at.z);
  if (depth == 0) return 0;
  const bool across_x = furrow.side == Side::buccal || furrow.side == Side::lingual;
  const double outward = across_x ? v : u;
  const bool positive = furrow.side == Side::buccal || furrow.side == Side::mesial;
  const double away = ((across_x ? at.x : at.y) - furrow.place(at.z)) / furrow.width;
  return depth * std::exp(-away * away) * smooth_step(0.2, 0.7, positive ? outward : -outward);
}

/// Section of the crown without its top.
double crown_section(const CrownSides& sides, const Point3& at) {
  const double mesial = sides.mesial(at.z), distal = sides.distal(at.z);
  const double buccal = sides.buccal(at.z), lingual = sides.lingual(at.z);
  const double a = (mesial - distal) / 2, b = (buccal - lingual) / 2;
  const double dx = at.x - (mesial + distal) / 2, dy = at.y - (buccal + lingual) / 2;
  const double u = dx / (1 + sides.wider_buccally * std::clamp(dy / b, -1.5, 1.5));
  const double v = dy / (1 + sides.wider_mesially * std::clamp(dx / a, -1.5, 1.5));
  const double exponent = u > 0 ? (v > 0 ? sides.exponent_mesiobuccal : sides.exponent_mesiolingual)
                                : (v > 0 ? sides.exponent_distobuccal : sides.exponent_distolingual);
  double distance = superellipse(u, v, a, b, exponent);
  for (const Furrow& furrow : sides.furrows) distance += furrow_depth(furrow, u / a, v / b, at);
  return distance;
}

/// Section of roots, trunk and crown without its top.
double side_section(const ToothShape& shape, const Point3& at) {
  const double crown_share = smooth_step(shape.trunk_low_z, shape.trunk_high_z, at.z);
  const double crown = crown_share > 0 ? crown_section(shape.sides, at) : 0.0;
  if (crown_share >= 1) return crown;
  double roots = far_outside;
  for (const Root& root : shape.roots) roots = smooth_min(roots, root_section(root, at), shape.root_blend);
  return crown_share * crown + (1 - crown_share) * roots;
}

double enamel_side_thickness(const ToothShape& shape, const Point3& at) {
  const double above = at.z - cervical_height(shape, {at.x, at.y});
  if (above <= 0) return 0;
  // Square root: a blunt margin, thick enough for the sections of neighbouring slices to overlap.
  return shape.enamel.side * std::sqrt(above / (above + shape.enamel.side_height));
}

double chamber(const PulpChamber& box, const Point3& at) {
  const Point3 middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
  const double n = box.exponent, a = box.high.x - middle.x, b = box.high.y - middle.y, c = box.high.z - middle.z;
  const double p = std::abs(at.x - middle.x) / a, q = std::abs(at.y - middle.y) / b, r = std::abs(at.z - middle.z) / c;
  const double sum = std::pow(p, n) + std::pow(q, n) + std::pow(r, n);
  if (sum <= 0) return -std::min({a, b, c});
  const double radius = std::pow(sum, 1 / n);
  const double gradient = std::pow(radius, 1 - n) *
                          std::hypot(std::pow(p, n - 1) / a, std::pow(q, n - 1) / b, std::pow(r, n - 1) / c);
  return (radius - 1) / gradient;
}

double canal_section(const ToothShape& shape, const Canal& canal, const Point3& at) {
  constexpr double round_end = 0.35, round_orifice = 0.6;   // mm
  const double shrunk = std::min(blunt_end(at.z - shape.roots[canal.root].apex_z - apical_stop, round_end),
                                 blunt_end(shape.canal_top_z - at.z, round_orifice));
  if (shrunk <= 0) return far_outside;
  const Point3 centre = canal_centre(shape, canal, at.z);
  return superellipse(at.x - centre.x, at.y - centre.y, shrunk * canal.half_mesiodistal(at.z),
                      shrunk * canal.half_buccolingual(at.z), 2);
}

}  // namespace

double blunt_end(double above, double length) {
  if (above <= 0) return 0;
  if (above >= length) return 1;
  const double missing = 1 - above / length;
  return std::sqrt(1 - missing * missing);
}

double cervical_height(const ToothShape& shape, Point2 at) {
  const CervicalLine& line = shape.cervical_line;
  const double square = at.x * at.x + at.y * at.y;
  if (square <= 0) return line.z;
  const double along_x = at.x * at.x / square, along_y = at.y * at.y / square;
  return line.z + along_x * (at.x > 0 ? line.rise_mesial : line.rise_distal) + (at.y < 0 ? along_y * line.rise_lingual : 0.0);
}

Point3 canal_centre(const ToothShape& shape, const Canal& canal, double z) {
  const Root& root = shape.roots[canal.root];
  const double shrunk = blunt_end(z - root.apex_z, root.blunt);
  return {root.x(z), root.y(z) + canal.lobe * shrunk * root.lobe_offset(z), z};
}

OcclusalHeights occlusal_heights(const ToothShape& shape, Point2 at) {
  const Occlusal& occlusal = shape.occlusal;
  double outer = -far_outside, smoother = -far_outside, highest = -far_outside, second = -far_outside;
  const auto join = [&](double height, double blend, double smoother_blend) {
    outer = smooth_max(outer, height, blend);
    smoother = smooth_max(smoother, height, smoother_blend);
  };
  for (const Cusp& cusp : occlusal.cusps) {
    const double height = cusp_height(cusp, at);
    second = std::max(second, std::min(highest, height));
    highest = std::max(highest, height);
    join(height, occlusal.blend, 3 * occlusal.blend);
  }
  for (const Ridge& ridge : occlusal.ridges) join(ridge_height(ridge, at), 2 * occlusal.blend, 4 * occlusal.blend);
  // A fissure runs where the second highest cusp is as high as the surface: between two cusps, not across a ridge.
  const double closeness = std::clamp(1 - (outer - second) / occlusal.fissure_width, 0.0, 1.0);
  return {outer - occlusal.fissure_depth * closeness * std::sqrt(closeness), smoother - shape.enamel.top};
}

HardTissue hard_tissue(const ToothShape& shape, const OcclusalHeights& heights, const Point3& at) {
  const double side = side_section(shape, at), blend = shape.occlusal.edge_blend;
  // Vertical distances overstate the distance to slopes; this brings those of the usual cusp slope to scale.
  constexpr double to_distance = 0.8;
  return {smooth_max(side, to_distance * (at.z - heights.enamel), blend),
          smooth_max(side + enamel_side_thickness(shape, at), to_distance * (at.z - heights.dentine), blend)};
}

double pulp(const ToothShape& shape, const Point3& at) {
  double distance = chamber(shape.chamber, at);
  for (const Horn& horn : shape.horns) {
    double along = 0;
    const double away = segment_distance(at, horn.base, horn.tip, along);
    distance = smooth_min(distance, away - horn.base_radius - along * (horn.tip_radius - horn.base_radius), shape.pulp_blend);
  }
  for (const Canal& canal : shape.canals) distance = smooth_min(distance, canal_section(shape, canal, at), shape.pulp_blend);
  return distance;
}

}  // namespace odontoscope::sample
