#include "recon/sample/field_loops.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/contours/trace.h"
#include "recon/core/error.h"
#include "recon/core/portable_math.h"

namespace odontoscope::sample {
namespace {

/// Crossings keep this share of an edge away from its ends.
constexpr double keep_off = 0.01;

/// For the walk along contours. Where a contour crosses the grid's edge between two vertices is told by number: twice
/// that of the vertex from which the edge runs right, and one more if it runs up.
struct GridField {
  const Grid& grid;

  std::size_t number(trace::Vertex v) const {
    return static_cast<std::size_t>(v.j) * grid.columns + static_cast<std::size_t>(v.i);
  }
  bool inside(trace::Vertex v) const {
    return v.i >= 0 && v.j >= 0 && static_cast<std::size_t>(v.i) < grid.columns &&
           static_cast<std::size_t>(v.j) < grid.rows && grid.values[number(v)] < 0;
  }
  bool joined(trace::Vertex a, trace::Vertex b, trace::Vertex, trace::Vertex) const {
    const std::size_t low = number({std::min(a.i, b.i), std::min(a.j, b.j)}), high = low + grid.columns;
    return grid.values[low] + grid.values[low + 1] + grid.values[high + 1] + grid.values[high] < 0;
  }
  std::size_t crossing(trace::Vertex in, trace::Vertex out) const {
    return 2 * std::min(number(in), number(out)) + (in.i == out.i ? 1 : 0);
  }
  Point2 place(std::size_t edge) const {
    const std::size_t vertex = edge / 2, column = vertex % grid.columns, row = vertex / grid.columns;
    const bool upwards = edge % 2 == 1;
    const double a = grid.values[vertex], b = grid.values[vertex + (upwards ? grid.columns : 1)];
    const double share = std::clamp(a / (a - b), keep_off, 1 - keep_off);
    const Point2 start = grid.at(column, row);
    return upwards ? Point2{start.x, start.y + share * grid.step} : Point2{start.x + share * grid.step, start.y};
  }
};

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

Polygon rounded(const Polygon& loop, double grain) {
  Polygon result;
  for (const Point2& p : loop) result.push_back({std::round(p.x / grain) * grain, std::round(p.y / grain) * grain});
  return result;
}

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = portable::hypot(dx, dy);
  if (length <= 0) return portable::hypot(p.x - a.x, p.y - a.y);
  return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

Polygon thinned(const Polygon& loop, double spacing, double deviation) {
  Polygon kept{loop.front()};
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

double distance(const Point2& p, const Segment& s) { return distance_to_edge(p, s.a, s.b); }

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
    return distance(s_first ? s.a : s.b, t) >= clearance && distance(s_first ? t.b : t.a, s) >= clearance;
  }
  return !cross(s, t) && distance(s.a, t) >= clearance && distance(s.b, t) >= clearance &&
         distance(t.a, s) >= clearance && distance(t.b, s) >= clearance;
}

/// Sweep along x over the segments of all loops.
bool all_clear(const std::vector<Polygon>& loops, double clearance) {
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

double length_of(const Polygon& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2& ahead = loop[(i + 1) % loop.size()];
    length += portable::hypot(ahead.x - loop[i].x, ahead.y - loop[i].y);
  }
  return length;
}

}  // namespace

std::vector<Polygon> trace(const Grid& grid, double speck) {
  require_border_outside(grid);
  const GridField field{grid};
  std::vector<std::vector<std::size_t>> crossed;  // each loop from its lowest edge on, the lowest loop first
  trace::contours(field, grid.columns, grid.rows, [&](std::vector<std::size_t>&& edges) {
    std::rotate(edges.begin(), std::min_element(edges.begin(), edges.end()), edges.end());
    crossed.push_back(std::move(edges));
    return true;
  });
  std::sort(crossed.begin(), crossed.end());
  std::vector<Polygon> loops;
  for (const std::vector<std::size_t>& edges : crossed) {
    Polygon loop;
    for (const std::size_t edge : edges) loop.push_back(field.place(edge));
    if (std::abs(signed_area(loop)) >= speck) loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Polygon> thin(const std::vector<Polygon>& loops, const Thinning& thinning) {
  constexpr double points_of_small_loop = 90, closest = 0.06;  // a canal of 0.4 mm keeps about 20 points
  constexpr int attempts = 5;
  double share = 1;
  for (int attempt = 0; attempt < attempts; ++attempt, share /= 2) {
    std::vector<Polygon> result;
    for (const Polygon& loop : loops) {
      const double spacing = std::min(thinning.spacing, std::max(closest, length_of(loop) / points_of_small_loop));
      result.push_back(rounded(thinned(loop, share * spacing, share * thinning.deviation), thinning.grain));
    }
    if (all_clear(result, thinning.clearance)) return result;
  }
  std::vector<Polygon> result;
  for (const Polygon& loop : loops) result.push_back(rounded(loop, thinning.grain));
  if (!all_clear(result, thinning.clearance))
    throw InternalError("a traced contour comes too close to itself or another");
  return result;
}

}  // namespace odontoscope::sample
