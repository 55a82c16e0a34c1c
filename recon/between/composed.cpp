#include "recon/between/composed.h"

#include <algorithm>
#include <cmath>

#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

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

}  // namespace

Window around(std::span<const Window* const> windows) {
  Window all = {
      windows.front()->first_i, windows.front()->first_j, windows.front()->columns, windows.front()->rows, {}};
  std::ptrdiff_t end_i = all.first_i + all.columns, end_j = all.first_j + all.rows;
  for (const Window* window : windows) {
    all.first_i = std::min(all.first_i, window->first_i);
    all.first_j = std::min(all.first_j, window->first_j);
    end_i = std::max(end_i, window->first_i + window->columns);
    end_j = std::max(end_j, window->first_j + window->rows);
  }
  all.columns = end_i - all.first_i;
  all.rows = end_j - all.first_j;
  all.values.assign(static_cast<std::size_t>(all.columns * all.rows), far_outside);
  return all;
}

std::optional<Grid> grid_for(const SliceSet& slices, std::size_t most_points, std::size_t finer) {
  Box box;
  double narrow = std::numeric_limits<double>::infinity();
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& facts : slices.facts[slice]) box.take(facts.box);
    narrow = std::min(narrow, narrowest(slices.facts[slice]));
  }
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y, side = std::max(width, height);
  const double farthest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  if (!std::isnormal(width * height)) return std::nullopt;
  Grid grid;
  grid.grain = std::max(std::ldexp(1.0, std::ilogb(side) + 1 - limits::blend_digits_of_size),
                        farthest > 0 ? std::ldexp(1.0, std::ilogb(farthest) + 1 - limits::blend_digits_of_place) : 0);
  const double finest = std::sqrt(width * height / static_cast<double>(most_points));
  const double wanted = std::min(side / limits::blend_columns, narrow / limits::blend_points_across);
  grid.step =
      short_below(std::max({wanted, finest, side / static_cast<double>(most_points)}) / static_cast<double>(finer));
  if (!(grid.step > limits::blend_grains_in_step * grid.grain)) return std::nullopt;
  grid.anchor = {grid.step * std::floor(box.low.x / grid.step), grid.step * std::floor(box.low.y / grid.step)};
  return grid;
}

Composition::Composition(const SliceSet& slices, const BlendPlan& plan, const Grid& grid, bool strips) {
  for (const BlendGroup& group : plan.groups) {
    material_.emplace_back(group.material, slices, grid, strips);
    voids_of_.push_back(group.voids);
  }
  for (const BlendUnit& unit : plan.voids) voids_.emplace_back(unit, slices, grid, strips);
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
  std::vector<const Window*> each;
  for (const Window& group : groups) each.push_back(&group);
  Window all = around(each);
  for (const Window& group : groups) combine(all, group, [](double a, double b) { return std::min(a, b); });
  return all;
}

}  // namespace odontoscope::between
