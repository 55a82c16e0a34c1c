#include "recon/between/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/limits.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"

namespace odontoscope::between {
namespace {

struct Moments {
  double area = 0;
  Point2 centroid;
  double spread = 0;  // root mean square distance from the centroid
};

/// Of what lies within; contours of the shape are oriented as outer ones and holes.
Moments moments_of(const Outline& shape) {
  AreaMoments sums(shape.front().front());
  for (const Polygon& ring : shape) sums.add(ring);
  return {std::abs(sums.signed_area()), sums.centroid(), std::sqrt(std::max(sums.mean_square(), 0.0))};
}

Box box_of(const Outline& shape) {
  Box box;
  for (const std::vector<Point2>& ring : shape) {
    for (const Point2 p : ring) box.take(p);
  }
  return box;
}

/// Is it wide enough for the moments of its area to be more than rounding?
bool is_measured(const Moments& moments, const Outline& shape) {
  const Box box = box_of(shape);
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  constexpr double rounding = 4096 * std::numeric_limits<double>::epsilon();
  return moments.area > rounding * side * side && moments.spread > 0 && moments.spread <= 2 * side;
}

/// Part of the smaller shape's area that the other covers, counted on a grid.
double overlap(const Outline& a, const Outline& b, double step) {
  Box box = box_of(a);
  const Box other = box_of(b);
  if (box.high.x < other.low.x || other.high.x < box.low.x || box.high.y < other.low.y || other.high.y < box.low.y)
    return 0;
  box.take(other);
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  Lattice lattice{box.low, std::max(step, side / limits::overlap_columns), 0, 0};
  lattice.columns = static_cast<std::ptrdiff_t>((box.high.x - box.low.x) / lattice.step) + 2;
  lattice.rows = static_cast<std::ptrdiff_t>((box.high.y - box.low.y) / lattice.step) + 2;
  const std::vector<std::uint8_t> in_a = inside_mask(lattice, a), in_b = inside_mask(lattice, b);
  std::size_t count_a = 0, count_b = 0, both = 0;
  for (std::size_t n = 0; n < in_a.size(); ++n) {
    count_a += in_a[n];
    count_b += in_b[n];
    both += in_a[n] & in_b[n];
  }
  const std::size_t smaller = std::min(count_a, count_b);
  return smaller == 0 ? 1 : static_cast<double>(both) / static_cast<double>(smaller);
}

/// 1 without overlap, 0 with a good one, smooth in between.
double amount_of_motion(double overlapping) {
  const double share = std::clamp(
      (limits::blend_good_overlap - overlapping) / (limits::blend_good_overlap - limits::blend_poor_overlap), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

Motion full_motion(const std::array<Moments, slices_used>& moments, const BlendUnit& unit, bool scales) {
  Motion motion;
  motion.moves = true;
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (unit.presence[n] != Presence::shape) continue;
    motion.origin[n] = moments[n].centroid;
    if (scales) motion.log_scale[n] = portable::log(moments[n].spread / moments[at_lower].spread);
  }
  return motion;
}

double overlap_moved(const BlendUnit& unit, const Motion& motion, double step) {
  return overlap(in_frame(unit.shapes[at_lower], motion, at_lower), in_frame(unit.shapes[at_upper], motion, at_upper),
                 step);
}

}  // namespace

Point2 Motion::origin_at(const SliceWeights& weights) const {
  Point2 result;
  for (std::size_t n = 0; n < slices_used; ++n) {
    result.x += weights[n] * origin[n].x;
    result.y += weights[n] * origin[n].y;
  }
  return result;
}

double Motion::scale_at(const SliceWeights& weights) const {
  double sum = 0;
  for (std::size_t n = 0; n < slices_used; ++n) sum += weights[n] * log_scale[n];
  return portable::exp(sum);
}

Motion motion_of(const BlendUnit& unit, double step) {
  if (unit.presence[at_lower] != Presence::shape || unit.presence[at_upper] != Presence::shape) return {};
  const double unmoved = overlap(unit.shapes[at_lower], unit.shapes[at_upper], step);
  const double amount = amount_of_motion(unmoved);
  if (amount <= 0) return {};
  std::array<Moments, slices_used> moments;
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (unit.presence[n] != Presence::shape) continue;
    moments[n] = moments_of(unit.shapes[n]);
    if (!is_measured(moments[n], unit.shapes[n])) return {};
  }
  Motion motion = full_motion(moments, unit, false);
  double moved = overlap_moved(unit, motion, step);
  if (moved < limits::blend_good_overlap) {
    const Motion scaled = full_motion(moments, unit, true);
    const double overlapping = overlap_moved(unit, scaled, step);
    if (overlapping > moved + limits::blend_better_overlap) {
      motion = scaled;
      moved = overlapping;
    }
  }
  if (moved < unmoved + limits::blend_better_overlap) return {};
  const Point2 fixed = motion.origin[at_lower];
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (unit.presence[n] != Presence::shape) continue;
    motion.origin[n] = {fixed.x + amount * (motion.origin[n].x - fixed.x),
                        fixed.y + amount * (motion.origin[n].y - fixed.y)};
    motion.log_scale[n] *= amount;
  }
  return motion;
}

Outline in_frame(const Outline& shape, const Motion& motion, std::size_t slice) {
  if (!motion.moves) return shape;
  const Point2 origin = motion.origin[slice];
  const double factor = portable::exp(-motion.log_scale[slice]);
  Outline result = shape;
  for (std::vector<Point2>& ring : result) {
    for (Point2& p : ring) p = {(p.x - origin.x) * factor, (p.y - origin.y) * factor};
  }
  return result;
}

}  // namespace odontoscope::between
