#include "recon/cavity/linking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "recon/mesh/half_edges.h"

namespace odontoscope::cavity {
namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

/// A direction that no scanner's or slicer's grid has, so that nothing lies exactly above anything else.
Point3 turned(const Point3& p) {
  constexpr double a = 0.3826834323650898, b = 0.9238795325112867, c = 0.2756373558169992,
                   d = 0.9612616959383189;  // sines and cosines
  const double x = b * p.x - a * p.y, y = a * p.x + b * p.y;
  return {x, d * y - c * p.z, c * y + d * p.z};
}

/// Seen from above: on which side of the line from a to b. Whichever way round the line is drawn a place is on one side
/// of it, however near: ways that lead there and back add nothing.
bool left_of(const Point3& a, const Point3& b, const Point3& p) {
  if (std::tie(b.x, b.y) < std::tie(a.x, a.y)) return !left_of(b, a, p);
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0;
}

std::uint64_t weight(std::uint64_t loop) {  // splitmix64, made odd
  std::uint64_t z = (loop + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (z ^ (z >> 31)) | 1u;
}

/// Half-edges that start from each vertex.
struct Stars {
  std::vector<std::uint32_t> first;
  std::vector<HalfEdge> out;
};
Stars stars_of(const SurfaceMesh& surface) {
  Stars stars{std::vector<std::uint32_t>(surface.points.size() + 1, 0),
              std::vector<HalfEdge>(3 * surface.triangles.size())};
  for (const Triangle& t : surface.triangles)
    for (const PointIndex v : t) ++stars.first[v + 1];
  for (std::size_t v = 0; v < surface.points.size(); ++v) stars.first[v + 1] += stars.first[v];
  std::vector<std::uint32_t> next_place(stars.first.begin(), stars.first.end() - 1);
  for (HalfEdge h = 0; h < stars.out.size(); ++h) stars.out[next_place[start(surface, h)]++] = h;
  return stars;
}

/// The way round that an edge closes in a tree of vertices.
std::vector<PointIndex> closed_by(PointIndex a, PointIndex b, const std::vector<PointIndex>& parent) {
  const auto to_root = [&](PointIndex v) {
    std::vector<PointIndex> way{v};
    while (parent[v] != v) way.push_back(v = parent[v]);
    return way;
  };
  std::vector<PointIndex> up = to_root(a), down = to_root(b);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  down.pop_back();  // where they meet
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

}  // namespace

std::vector<std::vector<PointIndex>> loops_on_surface(const SurfaceMesh& surface) {
  const EdgeMates edges = edge_mates(surface);
  const Stars stars = stars_of(surface);
  std::vector<char> used(3 * surface.triangles.size(), 0);  // by either tree
  const auto use = [&](HalfEdge h) { used[h] = used[edges.mate[h]] = 1; };
  std::vector<PointIndex> parent(surface.points.size(), nothing), vertices{surface.triangles.front()[0]};
  parent[vertices.front()] = vertices.front();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::uint32_t s = stars.first[vertices[i]]; s < stars.first[vertices[i] + 1]; ++s) {
      const HalfEdge h = stars.out[s];
      const PointIndex v = end(surface, h);
      if (parent[v] != nothing) continue;
      parent[v] = vertices[i];
      vertices.push_back(v);
      use(h);
    }
  }
  std::vector<char> reached(surface.triangles.size(), 0);
  std::vector<std::uint32_t> triangles{0};
  reached[0] = 1;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (HalfEdge h = 3 * triangles[i]; h < 3 * triangles[i] + 3; ++h) {
      const std::uint32_t beyond = edges.mate[h] / 3;
      if (used[h] || reached[beyond]) continue;
      reached[beyond] = 1;
      triangles.push_back(beyond);
      use(h);
    }
  }
  std::vector<std::vector<PointIndex>> loops;
  for (HalfEdge h = 0; h < used.size(); ++h)
    if (!used[h] && h < edges.mate[h]) loops.push_back(closed_by(start(surface, h), end(surface, h), parent));
  return loops;
}

Linking::Linking(const SurfaceMesh& wall) {
  const std::vector<std::vector<PointIndex>> loops = loops_on_surface(wall);
  loop_count_ = loops.size();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double high_x = -infinity, high_y = -infinity, sum = 0;
  low_x_ = low_y_ = infinity;
  for (std::uint32_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const Edge edge{turned(wall.points[loops[l][i]]), turned(wall.points[loops[l][(i + 1) % loops[l].size()]]), l};
      edges_.push_back(edge);
      low_x_ = std::min(low_x_, edge.from.x);
      low_y_ = std::min(low_y_, edge.from.y);
      high_x = std::max(high_x, edge.from.x);
      high_y = std::max(high_y, edge.from.y);
      sum += length(edge.to - edge.from);
    }
  }
  if (edges_.empty()) return;
  constexpr double most_cells = 512;  // a side
  cell_ = std::max(
      {sum / static_cast<double>(edges_.size()), (high_x - low_x_) / most_cells, (high_y - low_y_) / most_cells});
  columns_ = static_cast<std::size_t>((high_x - low_x_) / cell_) + 1;
  rows_ = static_cast<std::size_t>((high_y - low_y_) / cell_) + 1;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  // cell, edge
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const auto [x0, x1] = std::minmax(edges_[e].from.x, edges_[e].to.x);
    const auto [y0, y1] = std::minmax(edges_[e].from.y, edges_[e].to.y);
    for (std::size_t r = row(y0); r <= row(y1); ++r)
      for (std::size_t c = column(x0); c <= column(x1); ++c)
        places.emplace_back(static_cast<std::uint32_t>(r * columns_ + c), e);
  }
  std::sort(places.begin(), places.end());
  first_.assign(columns_ * rows_ + 1, 0);
  for (const auto& [cell, edge] : places) {
    ++first_[cell + 1];
    in_cell_.push_back(edge);
  }
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
}

std::size_t Linking::column(double x) const {
  return static_cast<std::size_t>(std::clamp((x - low_x_) / cell_, 0.0, static_cast<double>(columns_ - 1)));
}
std::size_t Linking::row(double y) const {
  return static_cast<std::size_t>(std::clamp((y - low_y_) / cell_, 0.0, static_cast<double>(rows_ - 1)));
}

template <class Tell>
void Linking::crossings(const Point3& start, const Point3& end, Tell tell) const {
  const Point3 a = turned(start), b = turned(end);
  const auto [x0, x1] = std::minmax(a.x, b.x);
  const auto [y0, y1] = std::minmax(a.y, b.y);
  const std::size_t c0 = column(x0), c1 = column(x1), r0 = row(y0), r1 = row(y1);
  for (std::size_t r = r0; r <= r1; ++r) {
    for (std::size_t c = c0; c <= c1; ++c) {
      for (std::uint32_t i = first_[r * columns_ + c]; i < first_[r * columns_ + c + 1]; ++i) {
        const Edge& edge = edges_[in_cell_[i]];
        // An edge stands in several cells: it counts in the first of them that is looked at.
        if (c != std::max(c0, column(std::min(edge.from.x, edge.to.x))) ||
            r != std::max(r0, row(std::min(edge.from.y, edge.to.y))))
          continue;
        const bool from_left = left_of(a, b, edge.from), to_left = left_of(a, b, edge.to);
        if (from_left == to_left || left_of(edge.from, edge.to, a) == left_of(edge.from, edge.to, b)) continue;
        const Direction way = b - a, other = edge.to - edge.from, apart = edge.from - a;
        const double whole = way.x * other.y - way.y * other.x;
        const double s = (apart.x * other.y - apart.y * other.x) / whole,
                     t = (apart.x * way.y - apart.y * way.x) / whole;
        if (a.z + s * way.z > edge.from.z + t * other.z) tell(edge.loop, to_left ? 1 : -1);
      }
    }
  }
}

std::uint64_t Linking::contribution(const Point3& a, const Point3& b) const {
  std::uint64_t sum = 0;
  crossings(a, b, [&](std::uint32_t loop, int sign) { sum += sign > 0 ? weight(loop) : -weight(loop); });
  return sum;
}

std::vector<std::int64_t> Linking::linked(const std::vector<Point3>& closed_way) const {
  std::vector<std::int64_t> times(loop_count_, 0);
  for (std::size_t i = 0; i < closed_way.size(); ++i)
    crossings(closed_way[i], closed_way[(i + 1) % closed_way.size()],
              [&](std::uint32_t loop, int sign) { times[loop] += sign; });
  return times;
}

}  // namespace odontoscope::cavity
