#include "recon/distance/slice_sampler.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/portable_math.h"
#include "recon/distance/limits.h"

namespace odontoscope::distance {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// +1 if c is left of the line from a to b, exactly.
int turn(const Point2& a, const Point2& b, const Point2& c) {
  return static_cast<int>(
      Kernel::Orientation_2()(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y)));
}

template <class Visit>
void for_each_edge(const Slice& slice, const std::string& structure, Visit visit) {
  for (const Contour& contour : slice.contours) {
    if (contour.structure != structure) continue;
    const auto& points = contour.points;
    for (std::size_t i = 0; i < points.size(); ++i) visit(points[i], points[(i + 1) % points.size()]);
  }
}

// --- signs -----------------------------------------------------------------------------------------------------------

/// First of `count` places with place(i) >= value; place ascends. The guess is mended, since it is rounded.
template <class PlaceOf>
std::size_t first_from(double value, double guess, std::size_t count, PlaceOf place) {
  std::size_t i = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(count)));
  while (i > 0 && place(i - 1) >= value) --i;
  while (i < count && place(i) < value) ++i;
  return i;
}

class SignSampler {
 public:
  SignSampler(const Grid& grid, std::span<std::int8_t> signs)
      : grid_(grid), signs_(signs), flips_(signs.size(), 0), on_(signs.size(), 0) {}

  void add(const Point2& a, const Point2& b) {
    mark_point(a);
    if (a.y == b.y) {
      mark_level(a, b);
      return;
    }
    const Point2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
    // Rows with low.y <= y < high.y: a vertex on a row then counts once.
    for (std::size_t row = first_row(low.y); row < grid_.rows && grid_.y(row) < high.y; ++row) cross(low, high, row);
  }

  void finish() {
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      std::uint8_t inside = 0;
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        const std::size_t i = row * grid_.columns + column;
        inside ^= flips_[i];
        signs_[i] = on_[i] ? 0 : inside ? -1 : 1;
      }
    }
  }

 private:
  std::size_t first_row(double y) const {
    return first_from(y, (y - grid_.y0) / grid_.dy, grid_.rows, [this](std::size_t row) { return grid_.y(row); });
  }
  std::size_t first_column(double x) const {
    return first_from(x, (x - grid_.x0) / grid_.dx, grid_.columns,
                      [this](std::size_t column) { return grid_.x(column); });
  }

  void mark_point(const Point2& p) {
    const std::size_t row = first_row(p.y), column = first_column(p.x);
    if (row == grid_.rows || column == grid_.columns || grid_.y(row) != p.y || grid_.x(column) != p.x) return;
    on_[row * grid_.columns + column] = 1;
  }

  void mark_level(const Point2& a, const Point2& b) {
    const std::size_t row = first_row(a.y);
    if (row == grid_.rows || grid_.y(row) != a.y) return;
    for (std::size_t column = first_column(std::min(a.x, b.x));
         column < grid_.columns && grid_.x(column) <= std::max(a.x, b.x); ++column) {
      on_[row * grid_.columns + column] = 1;
    }
  }

  /// Everything to the right of the edge changes sides.
  void cross(const Point2& low, const Point2& high, std::size_t row) {
    const double y = grid_.y(row);
    const double x = low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    const auto side = [&](std::size_t column) { return turn(low, high, {grid_.x(column), y}); };
    std::size_t column = static_cast<std::size_t>(
        std::clamp(std::ceil((x - grid_.x0) / grid_.dx), 0.0, static_cast<double>(grid_.columns)));
    while (column > 0 && side(column - 1) < 0) --column;
    while (column < grid_.columns && side(column) >= 0) ++column;
    if (column > 0 && side(column - 1) == 0) on_[row * grid_.columns + column - 1] = 1;
    if (column < grid_.columns) flips_[row * grid_.columns + column] ^= 1;
  }

  const Grid& grid_;
  std::span<std::int8_t> signs_;
  std::vector<std::uint8_t> flips_, on_;
};

// --- distances -------------------------------------------------------------------------------------------------------

struct Segment {
  Point2 from;
  double dx, dy, per_length2;  // per_length2: 1 / length^2

  double squared_distance(double x, double y) const {
    const double px = x - from.x, py = y - from.y;
    const double along = std::clamp((px * dx + py * dy) * per_length2, 0.0, 1.0);
    const double ex = px - along * dx, ey = py - along * dy;
    return ex * ex + ey * ey;
  }
};

struct Block {
  std::size_t left, right, low, high;  // columns [left, right), rows [low, high)
};

class DistanceSampler {
 public:
  DistanceSampler(const Slice& slice, const std::string& structure, const Grid& grid,
                  std::span<const std::uint8_t> wanted, std::span<double> distances)
      : grid_(grid), wanted_(wanted), distances_(distances) {
    for_each_edge(slice, structure, [this](const Point2& a, const Point2& b) {
      const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
      // Points are distinct, but the square of their distance may underflow: then the edge is as good as its end.
      segments_.push_back({a, dx, dy, length2 > 0 && std::isfinite(1 / length2) ? 1 / length2 : 0});
    });
    slack_ = limits::distance_slack *
             portable::hypot(grid.dx * static_cast<double>(grid.columns), grid.dy * static_cast<double>(grid.rows));
  }

  void run() {
    std::vector<std::uint32_t> all(segments_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    descend({0, grid_.columns, 0, grid_.rows}, all);
  }

 private:
  bool is_wanted(const Block& block) const {
    for (std::size_t row = block.low; row < block.high; ++row) {
      const auto first = wanted_.begin() + static_cast<std::ptrdiff_t>(row * grid_.columns);
      if (std::any_of(first + static_cast<std::ptrdiff_t>(block.left), first + static_cast<std::ptrdiff_t>(block.right),
                      [](std::uint8_t w) { return w != 0; })) {
        return true;
      }
    }
    return false;
  }

  /// Those that are nearest to some point of the block, and perhaps a few more.
  std::vector<std::uint32_t> can_be_nearest(const Block& block, const std::vector<std::uint32_t>& candidates) const {
    const double x = (grid_.x(block.left) + grid_.x(block.right - 1)) / 2;
    const double y = (grid_.y(block.low) + grid_.y(block.high - 1)) / 2;
    const double radius = portable::hypot(grid_.x(block.right - 1) - x, grid_.y(block.high - 1) - y);
    std::vector<double> squared(candidates.size());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      squared[i] = segments_[candidates[i]].squared_distance(x, y);
      least = std::min(least, squared[i]);
    }
    // A point of the block has its nearest edge within least + radius, and that edge is at most a radius farther from
    // the centre.
    const double reach = std::sqrt(least) + 2 * radius + slack_;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (squared[i] <= reach * reach) kept.push_back(candidates[i]);
    }
    return kept;
  }

  void descend(const Block& block, const std::vector<std::uint32_t>& candidates) {
    if (!is_wanted(block)) return;
    const std::vector<std::uint32_t> kept = can_be_nearest(block, candidates);
    const std::size_t width = block.right - block.left, height = block.high - block.low;
    if (std::max(width, height) <= limits::distance_block || kept.size() == 1) {
      measure(block, kept);
    } else if (width >= height) {
      const std::size_t middle = block.left + width / 2;
      descend({block.left, middle, block.low, block.high}, kept);
      descend({middle, block.right, block.low, block.high}, kept);
    } else {
      const std::size_t middle = block.low + height / 2;
      descend({block.left, block.right, block.low, middle}, kept);
      descend({block.left, block.right, middle, block.high}, kept);
    }
  }

  void measure(const Block& block, const std::vector<std::uint32_t>& candidates) {
    for (std::size_t row = block.low; row < block.high; ++row) {
      for (std::size_t column = block.left; column < block.right; ++column) {
        const std::size_t i = row * grid_.columns + column;
        if (!wanted_[i]) continue;
        double least = std::numeric_limits<double>::infinity();
        for (const std::uint32_t c : candidates) {
          least = std::min(least, segments_[c].squared_distance(grid_.x(column), grid_.y(row)));
        }
        distances_[i] = std::sqrt(least);
      }
    }
  }

  const Grid& grid_;
  std::span<const std::uint8_t> wanted_;
  std::span<double> distances_;
  std::vector<Segment> segments_;
  double slack_ = 0;
};

}  // namespace

void sample_signs(const Slice& slice, const std::string& structure, const Grid& grid, std::span<std::int8_t> signs) {
  SignSampler sampler(grid, signs);
  for_each_edge(slice, structure, [&sampler](const Point2& a, const Point2& b) { sampler.add(a, b); });
  sampler.finish();
}

void sample_distances(const Slice& slice, const std::string& structure, const Grid& grid,
                      std::span<const std::uint8_t> wanted, std::span<double> distances) {
  DistanceSampler(slice, structure, grid, wanted, distances).run();
}

}  // namespace odontoscope::distance
