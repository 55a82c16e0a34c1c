#include <algorithm>
#include <cmath>

#include "recon/between/composed.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope::between {
namespace {

std::ptrdiff_t whole_below(double value) { return static_cast<std::ptrdiff_t>(std::floor(value)); }

/// How far apart the boxes' sides are at most.
double travel(const Box& a, const Box& b) {
  if (a.empty() || b.empty()) return 0;
  return std::max({std::abs(a.low.x - b.low.x), std::abs(a.low.y - b.low.y), std::abs(a.high.x - b.high.x),
                   std::abs(a.high.y - b.high.y)});
}

/// The box with room for what a cubic may overshoot.
Lattice around(const Box& box, double margin, double step, Point2 anchor) {
  const std::ptrdiff_t first_i = whole_below((box.low.x - margin - anchor.x) / step);
  const std::ptrdiff_t first_j = whole_below((box.low.y - margin - anchor.y) / step);
  Lattice lattice;
  lattice.step = step;
  lattice.origin = {anchor.x + step * static_cast<double>(first_i), anchor.y + step * static_cast<double>(first_j)};
  lattice.columns = whole_below((box.high.x + margin - lattice.origin.x) / step) + 2;
  lattice.rows = whole_below((box.high.y + margin - lattice.origin.y) / step) + 2;
  return lattice;
}

bool on_border(std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t columns, std::ptrdiff_t rows) {
  return i == 0 || j == 0 || i == columns - 1 || j == rows - 1;
}

/// Part of what either covers that both do: of a mask, and of what has negative distances.
double likeness(const std::vector<std::uint8_t>& mask, const std::vector<double>& distances) {
  std::size_t both = 0, either = 0;
  for (std::size_t p = 0; p < mask.size(); ++p) {
    both += mask[p] != 0 && distances[p] < 0;
    either += mask[p] != 0 || distances[p] < 0;
  }
  return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either);
}

/// The contours round those regions and voids of a slice more than half of which have negative distances.
Outline mostly_within(const Lattice& lattice, const Outline& contours, const std::vector<ContourFacts>& facts,
                      const std::vector<double>& distances) {
  std::vector<std::size_t> innermost(lattice.size(), ContourFacts::none);
  for (const std::size_t c : outside_in(facts)) {
    const std::vector<std::uint8_t> inside = inside_mask(lattice, {contours[c]});
    for (std::size_t p = 0; p < inside.size(); ++p) {
      if (inside[p] != 0) innermost[p] = c;
    }
  }
  std::vector<std::size_t> all(contours.size(), 0), within(contours.size(), 0);
  for (std::size_t p = 0; p < innermost.size(); ++p) {
    if (innermost[p] == ContourFacts::none) continue;
    ++all[innermost[p]];
    within[innermost[p]] += distances[p] < 0;
  }
  const auto belongs = [&](std::size_t c) { return c != ContourFacts::none && 2 * within[c] > all[c]; };
  Outline boundary;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    if (belongs(c) != belongs(facts[c].parent)) boundary.push_back(contours[c]);
  }
  return boundary;
}

double tip_power(double radius) { return portable::pow(radius, limits::blend_tip); }

double inradius(const std::vector<double>& distances) {
  double deepest = 0;
  for (const double value : distances) deepest = std::max(deepest, -value);
  return deepest;
}

}  // namespace

UnitField::UnitField(const BlendUnit& unit, const SliceSet& slices, const Grid& grid, bool strips)
    : grid_(grid), motion_(motion_of(unit, grid.step)), heights_{{}, slices.z[at_lower], slices.z[at_upper], {}} {
  measure(unit, slices);
  continue_beyond(unit, slices, at_before, at_lower);
  continue_beyond(unit, slices, at_after, at_upper);
  find_end(unit, slices);
  const bool both = unit.presence[at_lower] == Presence::shape && unit.presence[at_upper] == Presence::shape;
  if (!both || !strips) return;
  strips_ = strip_points(lattice_, distances_[at_lower], distances_[at_upper], heights_.upper - heights_.lower);
}

/// What the unit continues as beyond the slab: those regions and voids of the slice that lie mostly within the unit's
/// shape beside it; of a shape that moves, its contours' partners. If that is unlike the shape, as across a furcation
/// or where a roof closes, the slice has no say: its slope would be that of another shape.
void UnitField::continue_beyond(const BlendUnit& unit, const SliceSet& slices, std::size_t beyond, std::size_t beside) {
  if (unit.presence[beside] != Presence::shape || slices.outlines[beyond]->empty()) return;
  const Outline& slice = *slices.outlines[beyond];
  Outline shape;
  if (!motion_.moves) shape = mostly_within(lattice_, slice, slices.facts[beyond], distances_[beside]);
  if (motion_.moves && unit.presence[beyond] == Presence::shape) shape = in_frame(unit.shapes[beyond], motion_, beyond);
  if (!(likeness(inside_mask(lattice_, shape), distances_[beside]) > limits::blend_alike)) return;
  distances_[beyond] = signed_distances(lattice_, shape);
  (beyond == at_before ? heights_.before : heights_.after) = slices.z[beyond];
}

/// A shape that is gone in the slab's other slice ends where its own course says: a power of its inner radius goes down
/// evenly (limits::blend_tip). Beyond the slab that radius is the depth, in what is there, of the shape's deepest
/// point: it may be part of a larger shape, as a horn is of the chamber.
void UnitField::find_end(const BlendUnit& unit, const SliceSet& slices) {
  for (const auto& [beyond, beside, other] :
       {std::array{at_before, at_lower, at_upper}, std::array{at_after, at_upper, at_lower}}) {
    if (unit.presence[other] != Presence::gone || unit.presence[beside] != Presence::shape) continue;
    const std::vector<double>& own = distances_[beside];
    const std::size_t deepest = static_cast<std::size_t>(std::min_element(own.begin(), own.end()) - own.begin());
    const double radius = -own[deepest];
    const bool same = inside_mask(lattice_, *slices.outlines[beyond])[deepest] ==
                      inside_mask(lattice_, *slices.outlines[beside])[deepest];
    if (!same || slices.outlines[beyond]->empty()) continue;
    const double here = tip_power(radius), there = tip_power(distances(lattice_, *slices.outlines[beyond])[deepest]);
    if (!(here > 0) || !(there > here)) continue;
    const double course = (there - here) / std::abs(slices.z[beside] - slices.z[beyond]);
    const double share = here / course / std::abs(slices.z[other] - slices.z[beside]);
    end_ = Ending{beside, radius, std::clamp(share, limits::blend_least_end, 1.0)};
  }
}

void UnitField::measure(const BlendUnit& unit, const SliceSet& slices) {
  std::array<Outline, slices_used> shapes;
  std::array<Box, slices_used> boxes;
  for (std::size_t n = 0; n < slices_used; ++n) {
    shapes[n] = in_frame(unit.shapes[n], motion_, n);
    for (const std::vector<Point2>& ring : shapes[n]) {
      for (const Point2 p : ring) boxes[n].take(p);
    }
  }
  Box box = boxes[at_lower];
  if (!boxes[at_upper].empty()) box.take(boxes[at_upper]);
  const double farthest = std::max({travel(boxes[at_before], boxes[at_lower]), travel(boxes[at_lower], boxes[at_upper]),
                                    travel(boxes[at_upper], boxes[at_after])});
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double step = motion_.moves ? std::min(grid_.step, side / limits::blend_columns_of_moved) : grid_.step;
  const double margin = limits::blend_margin_steps * step + std::min(farthest / 4, side);
  lattice_ = around(box, margin, step, motion_.moves ? Point2{} : grid_.anchor);
  first_i_ = static_cast<std::ptrdiff_t>(std::round((lattice_.origin.x - grid_.anchor.x) / grid_.step));
  first_j_ = static_cast<std::ptrdiff_t>(std::round((lattice_.origin.y - grid_.anchor.y) / grid_.step));
  for (const std::size_t n : {at_lower, at_upper}) {
    if (unit.presence[n] == Presence::shape) distances_[n] = signed_distances(lattice_, shapes[n]);
    if (unit.presence[n] == Presence::gone && !slices.outlines[n]->empty())
      distances_[n] = distances(lattice_, *slices.outlines[n]);
  }
  for (const std::size_t n : {at_lower, at_upper}) {  // an empty slice: the unit closes half-way
    if (distances_[n].empty()) distances_[n].assign(lattice_.size(), inradius(distances_[at_lower + at_upper - n]));
  }
}

std::vector<double> UnitField::blended(double share) const {
  const std::vector<double>&lower = distances_[at_lower], &upper = distances_[at_upper];
  std::vector<double> values(lattice_.size());
  if (end_) {
    const double way = (end_->beside == at_lower ? share : 1 - share) / end_->share;
    const double radius =
        way < 1 ? end_->radius * portable::pow(1 - way, 1 / limits::blend_tip) : end_->radius * (1 - way);
    for (std::size_t p = 0; p < values.size(); ++p) values[p] = distances_[end_->beside][p] + end_->radius - radius;
    return values;
  }
  for (std::size_t p = 0; p < values.size(); ++p)
    values[p] = (1 - share) * lower[p] + share * upper[p] - curvature(p, share) * share * (1 - share) / 2;
  for (const StripPoint& strip : strips_) {
    const auto [deepest, farthest] = std::minmax(lower[strip.at], upper[strip.at]);
    const double along = (upper[strip.at] < 0 ? strip.share - share : share - strip.share) * strip.length;
    double& value = values[strip.at];
    value += strip.certainty * (std::clamp(along, deepest, farthest) - value);
  }
  return values;
}

/// Second derivative over the slab, times its height squared: of the cubic over four slices, of the parabola over
/// three, or none. How much of it is believed is bounded, since a slice beyond may hold another shape there.
double UnitField::curvature(std::size_t p, double share) const {
  const double height = heights_.upper - heights_.lower;
  const double change = distances_[at_upper][p] - distances_[at_lower][p];
  const auto bend = [&](double change_beyond, double height_beyond) {
    const double counted = std::max(height_beyond, limits::blend_least_neighbour * height);
    return 2 * height / (height + counted) * (change - change_beyond * height / height_beyond);
  };
  double below = 0, above = 0;
  if (heights_.before)
    below = bend(distances_[at_lower][p] - distances_[at_before][p], heights_.lower - *heights_.before);
  if (heights_.after)
    above = -bend(distances_[at_after][p] - distances_[at_upper][p], *heights_.after - heights_.upper);
  double most = limits::blend_bend_of_change * std::abs(change);
  if (!heights_.before || !heights_.after) return std::clamp(below + above, -most, most);
  if ((below < 0) == (above < 0))
    most = std::max(most, limits::blend_bend * std::min(std::abs(below), std::abs(above)));
  return std::clamp((1 - share) * below + share * above, -most, most);
}

/// A cubic may go beyond both slices: a bulge of the shape is welcome, but where it is not one with what the slices
/// agree on it would be an island or a bubble; there the straight line is taken.
void UnitField::drop_overshoot(std::vector<double>& values, double share) const {
  const std::vector<double>&lower = distances_[at_lower], &upper = distances_[at_upper];
  const auto beyond = [&](std::size_t p) {
    return (values[p] < 0) != (lower[p] < 0) && (values[p] < 0) != (upper[p] < 0);
  };
  std::vector<std::size_t> loose, reached;
  std::vector<bool> open(values.size(), false);
  for (std::size_t p = 0; p < values.size(); ++p) {
    open[p] = beyond(p);
    if (open[p]) loose.push_back(p);
  }
  if (loose.empty()) return;
  const std::ptrdiff_t columns = lattice_.columns;
  const auto for_neighbours = [&](std::size_t p, const auto& visit) {
    const auto at = static_cast<std::ptrdiff_t>(p), i = at % columns, j = at / columns;
    if (i > 0) visit(p - 1);
    if (i + 1 < columns) visit(p + 1);
    if (j > 0) visit(static_cast<std::size_t>(at - columns));
    if (j + 1 < lattice_.rows) visit(static_cast<std::size_t>(at + columns));
  };
  for (const std::size_t p : loose) {
    bool attached = false;
    for_neighbours(p,
                   [&](std::size_t q) { attached = attached || (!beyond(q) && (values[q] < 0) == (values[p] < 0)); });
    if (!attached) continue;
    open[p] = false;
    reached.push_back(p);
  }
  while (!reached.empty()) {
    const std::size_t p = reached.back();
    reached.pop_back();
    for_neighbours(p, [&](std::size_t q) {
      if (!open[q] || (values[q] < 0) != (values[p] < 0)) return;
      open[q] = false;
      reached.push_back(q);
    });
  }
  for (const std::size_t p : loose) {
    if (open[p]) values[p] = (1 - share) * lower[p] + share * upper[p];
  }
}

Window UnitField::at(double share) const {
  std::vector<double> values = blended(share);
  drop_overshoot(values, share);
  for (std::ptrdiff_t j = 0; j < lattice_.rows; ++j) {
    for (std::ptrdiff_t i = 0; i < lattice_.columns; ++i) {
      double& value = values[static_cast<std::size_t>(j * lattice_.columns + i)];
      if (on_border(i, j, lattice_.columns, lattice_.rows)) value = std::max(value, lattice_.step);
    }
  }
  if (motion_.moves) return moved(values, slice_weights(heights_, share));
  return {first_i_, first_j_, lattice_.columns, lattice_.rows, std::move(values)};
}

/// From the unit's frame onto the grid, bilinear.
Window UnitField::moved(const std::vector<double>& values, const SliceWeights& weights) const {
  const Point2 origin = motion_.origin_at(weights);
  const double scale = motion_.scale_at(weights);
  const auto cell_of = [&](double place) { return (place) / grid_.step; };
  Window window;
  const Point2 low{origin.x + scale * lattice_.origin.x - grid_.anchor.x,
                   origin.y + scale * lattice_.origin.y - grid_.anchor.y};
  const double width = scale * lattice_.step * static_cast<double>(lattice_.columns - 1);
  const double height = scale * lattice_.step * static_cast<double>(lattice_.rows - 1);
  window.first_i = whole_below(cell_of(low.x)) - 1;
  window.first_j = whole_below(cell_of(low.y)) - 1;
  window.columns = whole_below(cell_of(low.x + width)) + 3 - window.first_i;
  window.rows = whole_below(cell_of(low.y + height)) + 3 - window.first_j;
  window.values.assign(static_cast<std::size_t>(window.columns * window.rows), far_outside);
  for (std::ptrdiff_t j = 0; j < window.rows; ++j) {
    const double v = (static_cast<double>(window.first_j + j) * grid_.step - low.y) / (scale * lattice_.step);
    const std::ptrdiff_t row = whole_below(v);
    if (row < 0 || row + 1 >= lattice_.rows) continue;
    for (std::ptrdiff_t i = 0; i < window.columns; ++i) {
      const double u = (static_cast<double>(window.first_i + i) * grid_.step - low.x) / (scale * lattice_.step);
      const std::ptrdiff_t column = whole_below(u);
      if (column < 0 || column + 1 >= lattice_.columns) continue;
      const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
      const double* cell = values.data() + row * lattice_.columns + column;
      const double* above = cell + lattice_.columns;
      window.values[static_cast<std::size_t>(j * window.columns + i)] =
          scale * ((1 - t) * ((1 - s) * cell[0] + s * cell[1]) + t * ((1 - s) * above[0] + s * above[1]));
    }
  }
  return window;
}

}  // namespace odontoscope::between
