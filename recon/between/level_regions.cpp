#include "recon/between/level_regions.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "recon/between/plane_distance.h"
#include "recon/core/union_find.h"

namespace odontoscope::between {

RegionClasses classes_of(const SliceSet& given, const Surroundings& links) {
  const std::size_t lower = given.facts[at_lower].size(), upper = given.facts[at_upper].size();
  const auto unbounded = static_cast<std::uint32_t>(lower + upper);
  const auto below = [&](std::size_t c) { return c == outside ? unbounded : static_cast<std::uint32_t>(c); };
  const auto above = [&](std::size_t c) { return c == outside ? unbounded : static_cast<std::uint32_t>(lower + c); };
  UnionFind joined(unbounded + 1);
  std::vector<bool> loop(unbounded + 1, false);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const ContourLink& link : links.material) pairs.emplace_back(below(link.lower), above(link.upper));
  for (const ContourLink& link : links.voids) pairs.emplace_back(below(link.lower), above(link.upper));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::uint32_t> in_loop;
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;  // the outside of both
    if (joined.find(a) == joined.find(b)) in_loop.push_back(a);
    joined.join(a, b);
  }
  for (const std::uint32_t a : in_loop) loop[joined.find(a)] = true;
  RegionClasses classes;
  for (std::size_t c = 0; c < lower; ++c) classes.lower.push_back(joined.find(below(c)));
  for (std::size_t c = 0; c < upper; ++c) classes.upper.push_back(joined.find(above(c)));
  classes.outside = joined.find(unbounded);
  classes.loop = std::move(loop);
  return classes;
}

namespace {

/// The last line of the grid at or before a place.
std::ptrdiff_t line_before(double place, double anchor, const Grid& grid) {
  return static_cast<std::ptrdiff_t>(std::floor((place - anchor) / grid.step));
}

}  // namespace

LevelStack::LevelStack(std::vector<Window>& slices, const Grid& grid, const SliceSet& given,
                       const RegionClasses& classes)
    : grid_(grid) {
  Box box;
  for (const std::size_t slice : {at_lower, at_upper})
    for (const ContourFacts& facts : given.facts[slice]) box.take(facts.box);
  constexpr std::ptrdiff_t margin = 3;
  first_i_ = line_before(box.low.x, grid.anchor.x, grid) - margin;
  first_j_ = line_before(box.low.y, grid.anchor.y, grid) - margin;
  std::ptrdiff_t end_i = line_before(box.high.x, grid.anchor.x, grid) + margin + 2;
  std::ptrdiff_t end_j = line_before(box.high.y, grid.anchor.y, grid) + margin + 2;
  for (const Window& window : slices) {
    if (window.values.empty()) continue;
    first_i_ = std::min(first_i_, window.first_i - 1);
    first_j_ = std::min(first_j_, window.first_j - 1);
    end_i = std::max(end_i, window.first_i + window.columns + 1);
    end_j = std::max(end_j, window.first_j + window.rows + 1);
  }
  columns_ = end_i - first_i_;
  rows_ = end_j - first_j_;
  add_given(*given.outlines[at_lower], given.facts[at_lower]);
  for (const Window& window : slices) add_interpolated(window);
  add_given(*given.outlines[at_upper], given.facts[at_upper]);
  lower_class_ = classes.lower;
  lower_class_.push_back(classes.outside);
  upper_class_ = classes.upper;
  upper_class_.push_back(classes.outside);
}

void LevelStack::add_given(const Outline& outline, const std::vector<ContourFacts>& facts) {
  Level level;
  level.solid.assign(points(), 0);
  level.region.assign(points(), static_cast<std::uint32_t>(facts.size()));  // outside
  level.regions = static_cast<std::uint32_t>(facts.size() + 1);
  for (const std::size_t c : outside_in(facts)) {
    const Box& box = facts[c].box;
    const std::ptrdiff_t i = line_before(box.low.x, grid_.anchor.x, grid_),
                         j = line_before(box.low.y, grid_.anchor.y, grid_);
    const Lattice part{
        {grid_.anchor.x + grid_.step * static_cast<double>(i), grid_.anchor.y + grid_.step * static_cast<double>(j)},
        grid_.step,
        line_before(box.high.x, grid_.anchor.x, grid_) + 2 - i,
        line_before(box.high.y, grid_.anchor.y, grid_) + 2 - j};
    const std::vector<std::uint8_t> mask = inside_mask(part, {outline[c]});
    for (std::ptrdiff_t n = 0; n < part.columns * part.rows; ++n) {
      if (mask[static_cast<std::size_t>(n)] == 0) continue;
      const auto point =
          static_cast<std::size_t>((j - first_j_ + n / part.columns) * columns_ + i - first_i_ + n % part.columns);
      level.solid[point] = facts[c].outer() ? 1 : 0;
      level.region[point] = static_cast<std::uint32_t>(c);
    }
  }
  levels_.push_back(std::move(level));
}

void LevelStack::add_interpolated(const Window& window) {
  Level level;
  level.values.assign(points(), far_outside);
  for (std::ptrdiff_t j = 0; j < window.rows; ++j)
    for (std::ptrdiff_t i = 0; i < window.columns; ++i)
      level.values[static_cast<std::size_t>((window.first_j + j - first_j_) * columns_ + window.first_i + i -
                                            first_i_)] =
          window.values[static_cast<std::size_t>(j * window.columns + i)];
  for (const double value : level.values) level.solid.push_back(value < 0 ? 1 : 0);
  levels_.push_back(std::move(level));
}

bool LevelStack::on_border(std::size_t point) const {
  const auto column = static_cast<std::ptrdiff_t>(point) % columns_,
             row = static_cast<std::ptrdiff_t>(point) / columns_;
  return column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_;
}

void LevelStack::flip(std::size_t number, std::size_t point) {
  Level& level = levels_[number];
  level.solid[point] = level.solid[point] ? 0 : 1;
  level.values[point] = level.solid[point] ? -grid_.step : grid_.step;
}

/// As contours are traced: the saddle of the bilinear surface decides (traced.cpp). a and b lie across a cell, c and d
/// are of the other kind.
bool LevelStack::diagonal(const Level& level, std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
  const double own = level.values[a] * level.values[b], other = level.values[c] * level.values[d];
  return level.solid[a] ? own >= other : own > other;
}

void LevelStack::find_regions() {
  for (std::size_t number = 1; number + 1 < levels_.size(); ++number) {
    Level& level = levels_[number];
    level.region.assign(points(), no_class);
    level.regions = 0;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < points(); ++start) {
      if (level.region[start] != no_class) continue;
      level.region[start] = level.regions;
      open.assign(1, start);
      while (!open.empty()) {
        const std::size_t point = open.back();
        open.pop_back();
        for_joined(number, point, [&](std::size_t other) {
          if (level.region[other] != no_class) return;
          level.region[other] = level.regions;
          open.push_back(other);
        });
      }
      ++level.regions;
    }
  }
}

std::vector<std::vector<std::uint32_t>> LevelStack::spread_classes() const {
  std::vector<std::vector<std::uint32_t>> found(levels_.size(), std::vector<std::uint32_t>(points(), no_class));
  using Place = std::pair<std::size_t, std::size_t>;  // slice and point
  std::deque<Place> now;
  for (const std::size_t end : {std::size_t{0}, levels_.size() - 1}) {
    const std::vector<std::uint32_t>& classes = end == 0 ? lower_class_ : upper_class_;
    for (std::size_t point = 0; point < points(); ++point) {
      found[end][point] = classes[levels_[end].region[point]];
      now.emplace_back(end, point);
    }
  }
  while (!now.empty()) {
    std::vector<Place> reached;  // at this many steps within slices
    while (!now.empty()) {
      const auto [level, point] = now.front();
      now.pop_front();
      if (interpolated(level)) reached.emplace_back(level, point);
      for (const std::size_t beside : {level - 1, level + 1}) {  // below the first it wraps round, and is no slice
        if (beside >= levels_.size() || !interpolated(beside) || found[beside][point] != no_class) continue;
        if (levels_[beside].solid[point] != levels_[level].solid[point]) continue;
        found[beside][point] = found[level][point];
        now.emplace_back(beside, point);
      }
    }
    for (const auto& [level, point] : reached) {
      for_joined(level, point, [&, level = level, point = point](std::size_t other) {
        if (found[level][other] != no_class) return;
        found[level][other] = found[level][point];
        now.emplace_back(level, other);
      });
    }
  }
  return found;
}

std::vector<Window> LevelStack::windows() const {
  std::vector<Window> made;
  for (std::size_t number = 1; number + 1 < levels_.size(); ++number)
    made.push_back({first_i_, first_j_, columns_, rows_, levels_[number].values});
  return made;
}

}  // namespace odontoscope::between
