#include "recon/between/composed.h"

#include <algorithm>
#include <cmath>

#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

std::ptrdiff_t whole_below(double value) { return static_cast<std::ptrdiff_t>(std::floor(value)); }

/// The wall that is left round a region's holes, in the mean, or half of a region's own width.
double narrowest(const std::vector<ContourFacts>& facts) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> area(facts.size()), perimeter(facts.size());
  for (std::size_t n = 0; n < facts.size(); ++n) {
    const std::size_t region = facts[n].outer() ? n : facts[n].parent;
    least = std::min(least, 2 * std::abs(facts[n].area) / facts[n].perimeter);
    if (region == ContourFacts::none) continue;
    area[region] += facts[n].area;
    perimeter[region] += facts[n].perimeter;
  }
  for (std::size_t n = 0; n < facts.size(); ++n) {
    if (perimeter[n] > 0 && area[n] > 0) least = std::min(least, 2 * area[n] / perimeter[n]);
  }
  return least;
}

/// At most `value`, with four binary digits: multiples of it stay exact.
double short_below(double value) {
  const double unit = std::ldexp(1.0, std::ilogb(value) - 3);
  return std::floor(value / unit) * unit;
}

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

/// Writes rule(value, other's value) into a window where the other one lies on it.
template <class Rule>
void combine(Window& window, const Window& other, const Rule& rule) {
  const std::ptrdiff_t end_i = std::min(window.first_i + window.columns, other.first_i + other.columns);
  const std::ptrdiff_t end_j = std::min(window.first_j + window.rows, other.first_j + other.rows);
  for (std::ptrdiff_t j = std::max(window.first_j, other.first_j); j < end_j; ++j) {
    for (std::ptrdiff_t i = std::max(window.first_i, other.first_i); i < end_i; ++i) {
      double& value = window.values[window.at(i, j)];
      value = rule(value, other.values[other.at(i, j)]);
    }
  }
}

/// Far outside, as large as all of them together. Precondition: there is one.
Window around(const std::vector<Window>& windows) {
  Window all = windows.front();
  std::ptrdiff_t end_i = all.first_i + all.columns, end_j = all.first_j + all.rows;
  for (const Window& window : windows) {
    all.first_i = std::min(all.first_i, window.first_i);
    all.first_j = std::min(all.first_j, window.first_j);
    end_i = std::max(end_i, window.first_i + window.columns);
    end_j = std::max(end_j, window.first_j + window.rows);
  }
  all.columns = end_i - all.first_i;
  all.rows = end_j - all.first_j;
  all.values.assign(static_cast<std::size_t>(all.columns * all.rows), far_outside);
  return all;
}

bool on_border(std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t columns, std::ptrdiff_t rows) {
  return i == 0 || j == 0 || i == columns - 1 || j == rows - 1;
}

}  // namespace

std::optional<Grid> grid_for(const SliceSet& slices, std::size_t most_points) {
  Box box;
  double narrow = std::numeric_limits<double>::infinity();
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& facts : slices.facts[slice]) box.take(facts.box);
    narrow = std::min(narrow, narrowest(slices.facts[slice]));
  }
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y, side = std::max(width, height);
  const double farthest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  if (!(width > 0) || !(height > 0)) return std::nullopt;
  Grid grid;
  grid.grain = std::max(std::ldexp(1.0, std::ilogb(side) + 1 - limits::blend_digits_of_size),
                        farthest > 0 ? std::ldexp(1.0, std::ilogb(farthest) + 1 - limits::blend_digits_of_place) : 0);
  const double finest = std::sqrt(width * height / static_cast<double>(most_points));
  const double wanted = std::min(side / limits::blend_columns, narrow / limits::blend_points_across);
  grid.step = short_below(std::max({wanted, finest, side / static_cast<double>(most_points)}));
  if (!(grid.step > limits::blend_grains_in_step * grid.grain)) return std::nullopt;
  grid.anchor = {grid.step * std::floor(box.low.x / grid.step), grid.step * std::floor(box.low.y / grid.step)};
  return grid;
}

std::optional<Grid> finer(const Grid& grid, const SliceSet& slices, std::size_t most_points) {
  Box box;
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& facts : slices.facts[slice]) box.take(facts.box);
  }
  Grid result = grid;
  result.step /= 2;
  const double points = (box.high.x - box.low.x) / result.step * ((box.high.y - box.low.y) / result.step);
  if (points > static_cast<double>(most_points) || !(result.step > limits::blend_grains_in_step * grid.grain))
    return std::nullopt;
  return result;
}

UnitField::UnitField(const BlendUnit& unit, const SliceSet& slices, const Grid& grid)
    : grid_(grid), motion_(motion_of(unit, grid.step)), heights_{{}, slices.z[at_lower], slices.z[at_upper], {}} {
  if (unit.presence[at_before] != Presence::unused) heights_.before = slices.z[at_before];
  if (unit.presence[at_after] != Presence::unused) heights_.after = slices.z[at_after];
  measure(unit, slices);
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
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (unit.presence[n] == Presence::shape) distances_[n] = signed_distances(lattice_, shapes[n]);
    if (unit.presence[n] == Presence::gone && !slices.outlines[n]->empty())
      distances_[n] = distances(lattice_, *slices.outlines[n]);
  }
  for (const std::size_t n : {at_lower, at_upper}) {  // an empty slice: the unit closes half-way
    if (distances_[n].empty()) distances_[n].assign(lattice_.size(), inradius());
  }
}

double UnitField::inradius() const {
  double deepest = 0;
  for (const std::size_t n : {at_lower, at_upper}) {
    for (const double value : distances_[n]) deepest = std::max(deepest, -value);
  }
  return deepest;
}

std::vector<double> UnitField::blended(double share) const {
  const SliceWeights weights = slice_weights(heights_, share);
  std::vector<double> values(lattice_.size(), 0);
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (distances_[n].empty()) continue;
    for (std::size_t p = 0; p < values.size(); ++p) values[p] += weights[n] * distances_[n][p];
  }
  return values;
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

Composition::Composition(const SliceSet& slices, const BlendPlan& plan, const Grid& grid) {
  for (const BlendGroup& group : plan.groups) {
    material_.emplace_back(group.material, slices, grid);
    voids_of_.push_back(group.voids);
  }
  for (const BlendUnit& unit : plan.voids) voids_.emplace_back(unit, slices, grid);
}

Window Composition::at(double share) const {
  std::vector<Window> voids, groups;
  for (const UnitField& field : voids_) voids.push_back(field.at(share));
  for (std::size_t g = 0; g < material_.size(); ++g) {
    groups.push_back(material_[g].at(share));
    for (const std::size_t number : voids_of_[g]) {
      combine(groups.back(), voids[number], [](double solid, double hollow) { return std::max(solid, -hollow); });
    }
  }
  if (groups.empty()) return {};
  Window all = around(groups);
  for (const Window& group : groups) combine(all, group, [](double a, double b) { return std::min(a, b); });
  return all;
}

}  // namespace odontoscope::between
