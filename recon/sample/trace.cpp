#include "recon/sample/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/portable_math.h"

namespace odontoscope::sample {
namespace {

/// Crossings keep this share of an edge away from its ends.
constexpr double keep_off = 0.01;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Grid edges, numbered: the one from a vertex to the right, and the one upwards.
struct Edges {
  const Grid& grid;
  std::uint32_t right(std::size_t column, std::size_t row) const {
    return static_cast<std::uint32_t>(2 * (row * grid.columns + column));
  }
  std::uint32_t up(std::size_t column, std::size_t row) const { return right(column, row) + 1; }

  Point2 crossing(std::uint32_t edge) const {
    const std::size_t vertex = edge / 2, column = vertex % grid.columns, row = vertex / grid.columns;
    const bool upwards = edge % 2 == 1;
    const double a = grid.values[vertex], b = grid.values[vertex + (upwards ? grid.columns : 1)];
    const double share = std::clamp(a / (a - b), keep_off, 1 - keep_off);
    const Point2 start = grid.at(column, row);
    return upwards ? Point2{start.x, start.y + share * grid.step} : Point2{start.x + share * grid.step, start.y};
  }
};

/// For each edge that the surface crosses, the one where the segment that starts there ends.
std::vector<std::uint32_t> directed_segments(const Grid& grid, const Edges& edges) {
  std::vector<std::uint32_t> next(2 * grid.columns * grid.rows, none);
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const std::size_t vertex = row * grid.columns + column;
      const double corner[4] = {grid.values[vertex], grid.values[vertex + 1], grid.values[vertex + grid.columns + 1],
                                grid.values[vertex + grid.columns]};
      const std::uint32_t side[4] = {edges.right(column, row), edges.up(column + 1, row), edges.right(column, row + 1),
                                     edges.up(column, row)};
      // Going round the cell, a segment starts where we leave the inside and ends where we enter it.
      int leaving[2] = {}, leavings = 0, entering = 0;
      for (int k = 0; k < 4; ++k) {
        const bool inside = corner[k] < 0, then_inside = corner[(k + 1) % 4] < 0;
        if (inside && !then_inside) leaving[leavings++] = k;
        if (!inside && then_inside) entering = k;
      }
      if (leavings == 1) next[side[leaving[0]]] = side[entering];
      if (leavings < 2) continue;
      const bool joined = corner[0] + corner[1] + corner[2] + corner[3] < 0;
      for (const int k : leaving) next[side[k]] = side[(k + (joined ? 1 : 3)) % 4];
    }
  }
  return next;
}

void require_border_outside(const Grid& grid) {
  const auto outside = [&grid](std::size_t column, std::size_t row) {
    return !(grid.values[row * grid.columns + column] < 0);
  };
  bool all = true;
  for (std::size_t column = 0; column < grid.columns; ++column)
    all = all && outside(column, 0) && outside(column, grid.rows - 1);
  for (std::size_t row = 0; row < grid.rows; ++row) all = all && outside(0, row) && outside(grid.columns - 1, row);
  if (!all) throw InternalError("a sample tooth does not fit its sampling grid");
}

Loop rounded(const Loop& loop, double grain) {
  Loop result;
  for (const Point2& p : loop) result.push_back({std::round(p.x / grain) * grain, std::round(p.y / grain) * grain});
  return result;
}

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = portable::hypot(dx, dy);
  if (length <= 0) return portable::hypot(p.x - a.x, p.y - a.y);
  return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

Loop thinned(const Loop& loop, double spacing, double deviation) {
  Loop kept{loop.front()};
  std::size_t last = 0;
  double length = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    length += portable::hypot(loop[i].x - loop[i - 1].x, loop[i].y - loop[i - 1].y);
    const Point2& ahead = loop[(i + 1) % loop.size()];
    const double step = portable::hypot(ahead.x - loop[i].x, ahead.y - loop[i].y);
    double off = 0;
    for (std::size_t k = last + 1; k <= i; ++k) off = std::max(off, distance_to_line(loop[k], loop[last], ahead));
    if (length + step <= spacing && off <= deviation) continue;
    kept.push_back(loop[i]);
    last = i;
    length = 0;
  }
  return kept;
}

struct Segment {
  Point2 a, b;
  std::size_t loop = 0, index = 0, loop_size = 0;
  double low_x() const { return std::min(a.x, b.x); }
  double high_x() const { return std::max(a.x, b.x); }
};

double point_segment(const Point2& p, const Segment& s) {
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return portable::hypot(p.x - s.a.x - t * dx, p.y - s.a.y - t * dy);
}

bool cross(const Segment& s, const Segment& t) {
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  return (turn(s.a, s.b, t.a) < 0) != (turn(s.a, s.b, t.b) < 0) &&
         (turn(t.a, t.b, s.a) < 0) != (turn(t.a, t.b, s.b) < 0);
}

bool neighbours(const Segment& s, const Segment& t) {
  if (s.loop != t.loop) return false;
  const std::size_t apart = s.index > t.index ? s.index - t.index : t.index - s.index;
  return apart == 1 || apart + 1 == s.loop_size;
}

bool clear(const Segment& s, const Segment& t, double clearance) {
  if (std::max(s.a.y, s.b.y) + clearance < std::min(t.a.y, t.b.y)) return true;
  if (std::max(t.a.y, t.b.y) + clearance < std::min(s.a.y, s.b.y)) return true;
  if (neighbours(s, t)) {
    // Their far ends must keep off each other's segment; the shared point is theirs.
    const bool s_first = s.b == t.a;
    return point_segment(s_first ? s.a : s.b, t) >= clearance && point_segment(s_first ? t.b : t.a, s) >= clearance;
  }
  return !cross(s, t) && point_segment(s.a, t) >= clearance && point_segment(s.b, t) >= clearance &&
         point_segment(t.a, s) >= clearance && point_segment(t.b, s) >= clearance;
}

/// Sweep along x over the segments of all loops.
bool all_clear(const std::vector<Loop>& loops, double clearance) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (loops[l].size() < 3) return false;
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      segments.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i, loops[l].size()});
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) {
    return s.low_x() != t.low_x() ? s.low_x() < t.low_x() : s.loop != t.loop ? s.loop < t.loop : s.index < t.index;
  });
  std::vector<Segment> active;
  for (const Segment& s : segments) {
    std::erase_if(active, [&](const Segment& t) { return t.high_x() + clearance < s.low_x(); });
    for (const Segment& t : active)
      if (!clear(s, t, clearance)) return false;
    active.push_back(s);
  }
  return true;
}

double length_of(const Loop& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2& ahead = loop[(i + 1) % loop.size()];
    length += portable::hypot(ahead.x - loop[i].x, ahead.y - loop[i].y);
  }
  return length;
}

}  // namespace

double signed_area(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / 2;
}

std::vector<Loop> trace(const Grid& grid, double speck) {
  require_border_outside(grid);
  const Edges edges{grid};
  std::vector<std::uint32_t> next = directed_segments(grid, edges);
  std::vector<Loop> loops;
  for (std::uint32_t first = 0; first < next.size(); ++first) {
    if (next[first] == none) continue;
    Loop loop;
    for (std::uint32_t edge = first; next[edge] != none;) {
      loop.push_back(edges.crossing(edge));
      edge = std::exchange(next[edge], none);
    }
    if (std::abs(signed_area(loop)) >= speck) loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Loop> thin(const std::vector<Loop>& loops, const Thinning& thinning) {
  constexpr double points_of_small_loop = 90, closest = 0.06;  // a canal of 0.4 mm keeps about 20 points
  constexpr int attempts = 5;
  double share = 1;
  for (int attempt = 0; attempt < attempts; ++attempt, share /= 2) {
    std::vector<Loop> result;
    for (const Loop& loop : loops) {
      const double spacing = std::min(thinning.spacing, std::max(closest, length_of(loop) / points_of_small_loop));
      result.push_back(rounded(thinned(loop, share * spacing, share * thinning.deviation), thinning.grain));
    }
    if (all_clear(result, thinning.clearance)) return result;
  }
  std::vector<Loop> result;
  for (const Loop& loop : loops) result.push_back(rounded(loop, thinning.grain));
  if (!all_clear(result, thinning.clearance))
    throw InternalError("a traced contour comes too close to itself or another");
  return result;
}

}  // namespace odontoscope::sample
