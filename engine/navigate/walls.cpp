#include "engine/navigate/walls.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/scene/vector.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope {

namespace {

constexpr std::uint32_t most_in_leaf = 4;
/// Deeper than any tree of triangles that fits into memory: each level halves them.
constexpr std::size_t deepest = 64;

Point3 exact(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

int side_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) { return orientation(exact(a), exact(b), exact(c), exact(d)); }

double square(const glm::dvec3& v) { return glm::dot(v, v); }

glm::dvec3 nearest_on_line(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& place) {
  const glm::dvec3 along = b - a;
  const double length = square(along);
  return length > 0 ? a + std::clamp(glm::dot(place - a, along) / length, 0.0, 1.0) * along : a;
}

glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& t, const glm::dvec3& place) {
  const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], w = place - t[0];
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(w, u), wv = glm::dot(w, v);
  const double whole = uu * vv - uv * uv, s = vv * wu - uv * wv, r = uu * wv - uv * wu;
  // Errors along the triangle count only squared; a needle's may be large, so its edges are asked too.
  constexpr double needle = 1e-6;
  const bool over = whole > 0 && s >= 0 && r >= 0 && s + r <= whole;
  const glm::dvec3 within = over ? t[0] + (s / whole) * u + (r / whole) * v : t[0];
  if (over && whole > needle * uu * vv) return within;
  glm::dvec3 best = within;
  for (const glm::dvec3& other : {nearest_on_line(t[0], t[1], place), nearest_on_line(t[1], t[2], place), nearest_on_line(t[2], t[0], place)})
    if (square(other - place) < square(best - place)) best = other;
  return best;
}

double squared_distance(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& place) {
  return square(glm::max(glm::max(low - place, place - high), glm::dvec3(0)));
}

/// Never false where the segment meets the box: slabs with room for rounding.
bool may_meet(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& from, const glm::dvec3& to) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double pad = 1e-12 * (std::abs(from[axis]) + std::abs(to[axis]) + std::abs(low[axis]) + std::abs(high[axis]));
    const double step = to[axis] - from[axis];
    if (std::abs(step) <= pad) {
      if (std::max(from[axis], to[axis]) < low[axis] - pad || std::min(from[axis], to[axis]) > high[axis] + pad) return false;
      continue;
    }
    const double a = (low[axis] - pad - from[axis]) / step, b = (high[axis] + pad - from[axis]) / step;
    enter = std::max(enter, std::min(a, b) - 1e-12);
    leave = std::min(leave, std::max(a, b) + 1e-12);
    if (enter > leave) return false;
  }
  return true;
}

/// +1: the segment passes through the triangle's inside; 0: not at all; -1: it touches an edge, a corner or the plane.
int passes(const std::array<glm::dvec3, 3>& t, const glm::dvec3& from, const glm::dvec3& to) {
  const int start = side_of(t[0], t[1], t[2], from), end = side_of(t[0], t[1], t[2], to);
  if (start * end > 0) return 0;
  const int ab = side_of(from, to, t[0], t[1]), bc = side_of(from, to, t[1], t[2]), ca = side_of(from, to, t[2], t[0]);
  const bool some_left = ab > 0 || bc > 0 || ca > 0, some_right = ab < 0 || bc < 0 || ca < 0;
  if (some_left && some_right) return 0;
  return start != 0 && end != 0 && ab != 0 && bc != 0 && ca != 0 ? 1 : -1;
}

/// Where along from + t * direction; negative if it misses.
double meeting(const std::array<glm::dvec3, 3>& t, const glm::dvec3& from, const glm::dvec3& direction) {
  const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], across = glm::cross(direction, v);
  const double whole = glm::dot(u, across);
  if (whole == 0) return -1;
  const glm::dvec3 w = from - t[0], q = glm::cross(w, u);
  const double s = glm::dot(w, across) / whole, r = glm::dot(direction, q) / whole;
  return s >= -1e-12 && r >= -1e-12 && s + r <= 1 + 1e-12 ? glm::dot(v, q) / whole : -1;
}

/// Directions evenly over the sphere.
glm::dvec3 fibonacci(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, round = std::sqrt(std::max(0.0, 1 - z * z)), angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
  return {round * std::cos(angle), round * std::sin(angle), z};
}

}  // namespace

Walls::Walls(const SurfaceMesh& surface) : Walls(std::vector<const SurfaceMesh*>{&surface}) {}

Walls::Walls(const std::vector<const SurfaceMesh*>& surfaces) {
  for (const SurfaceMesh* surface : surfaces)
    for (const auto& [a, b, c] : surface->triangles) triangles_.push_back({vec(surface->points[a]), vec(surface->points[b]), vec(surface->points[c])});
  build();
}

void Walls::build() {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  divide(0, 0, static_cast<std::uint32_t>(triangles_.size()));
  bounds_ = {nodes_[0].low, nodes_[0].high};
}

void Walls::divide(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  glm::dvec3 low = triangles_[first][0], high = low, centre_low = (low + triangles_[first][1] + triangles_[first][2]) / 3.0, centre_high = centre_low;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Corners& t = triangles_[i];
    for (const glm::dvec3& corner : t) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    const glm::dvec3 centre = (t[0] + t[1] + t[2]) / 3.0;
    centre_low = glm::min(centre_low, centre);
    centre_high = glm::max(centre_high, centre);
  }
  nodes_[node] = {low, high, first, count};
  if (count <= most_in_leaf) return;
  const glm::dvec3 extent = centre_high - centre_low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto begin = triangles_.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [axis](const Corners& a, const Corners& b) { return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis]; });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  nodes_[node].count = 0;
  divide(children, first, half);
  divide(children + 1, first + half, count - half);
}

Walls::Nearest Walls::nearest(const glm::dvec3& place, double most) const {
  Nearest best;
  if (nodes_.empty()) return best;
  double squared = most < std::sqrt(std::numeric_limits<double>::max()) ? most * most : std::numeric_limits<double>::infinity();
  struct Open {
    double squared;
    std::uint32_t node;
  };
  std::array<Open, deepest> stack;
  std::size_t open = 0;
  stack[open++] = {squared_distance(nodes_[0].low, nodes_[0].high, place), 0};
  while (open > 0) {
    const Open next = stack[--open];
    if (next.squared >= squared) continue;
    const Node& node = nodes_[next.node];
    if (node.count == 0) {
      const Node &left = nodes_[node.first], &right = nodes_[node.first + 1];
      const Open a{squared_distance(left.low, left.high, place), node.first}, b{squared_distance(right.low, right.high, place), node.first + 1};
      stack[open++] = a.squared < b.squared ? b : a;
      stack[open++] = a.squared < b.squared ? a : b;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const glm::dvec3 point = nearest_on_triangle(triangles_[i], place);
      if (const double far = square(point - place); far < squared) {
        squared = far;
        best = {0, point};
      }
    }
    if (best.distance == 0) best.distance = std::sqrt(squared);
  }
  if (best.distance < std::numeric_limits<double>::infinity()) best.distance = std::sqrt(squared);
  return best;
}

template <class Visit>
void Walls::along(const glm::dvec3& from, const glm::dvec3& to, Visit visit) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, deepest> stack;
  std::size_t open = 0;
  stack[open++] = 0;
  while (open > 0) {
    const Node& node = nodes_[stack[--open]];
    if (!may_meet(node.low, node.high, from, to)) continue;
    if (node.count == 0) {
      stack[open++] = node.first;
      stack[open++] = node.first + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (!visit(triangles_[i])) return;
  }
}

namespace {

/// As long as any wall can be away.
double beyond(const Box& bounds, const glm::dvec3& eye) { return 2 * (glm::length(bounds.high - bounds.low) + glm::length(bounds.centre() - eye)) + 1; }

}  // namespace

double Walls::free_distance(const glm::dvec3& eye, const glm::dvec3& direction, double most) const {
  double first = std::numeric_limits<double>::infinity();
  along(eye, eye + std::min(most, beyond(bounds_, eye)) * direction, [&](const Corners& t) {
    const double at = meeting(t, eye, direction);
    if (at >= 0 && at <= most) first = std::min(first, at);
    return true;
  });
  return first;
}

std::vector<double> Walls::meetings(const glm::dvec3& eye, const glm::dvec3& direction) const {
  std::vector<double> all;
  along(eye, eye + beyond(bounds_, eye) * direction, [&](const Corners& t) {
    if (const double at = meeting(t, eye, direction); at >= 0) all.push_back(at);
    return true;
  });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a <= 1e-9 * b; }), all.end());
  return all;
}

Walls::Side Walls::locate(const glm::dvec3& place) const {
  if (nodes_.empty()) return Side::outside;
  constexpr int lines = 16;
  for (int line = 0; line < lines; ++line) {
    const glm::dvec3 far = place + beyond(bounds_, place) * fibonacci(line, lines);
    bool clear = true, inside = false;
    along(place, far, [&](const Corners& t) {
      const int how = passes(t, place, far);
      clear = how >= 0;
      inside = inside != (how > 0);
      return clear;
    });
    if (clear) return inside ? Side::inside : Side::outside;
  }
  return Side::on_wall;
}

bool Walls::crosses(const glm::dvec3& from, const glm::dvec3& to) const {
  bool touched = false;
  along(from, to, [&](const Corners& t) {
    touched = passes(t, from, to) != 0 && may_meet(glm::min(glm::min(t[0], t[1]), t[2]), glm::max(glm::max(t[0], t[1]), t[2]), from, to);
    return !touched;
  });
  return touched;
}

std::optional<Roomiest> roomiest_place(const Walls& walls, int places) {
  if (walls.empty()) return std::nullopt;
  const Box& bounds = walls.bounds();
  const glm::dvec3 extent = glm::max(bounds.high - bounds.low, glm::dvec3(1e-9));
  const double step = std::cbrt(extent.x * extent.y * extent.z / std::max(places, 1));
  const glm::ivec3 count = glm::clamp(glm::ivec3(glm::ceil(extent / step)), 3, 256);
  std::optional<Roomiest> best;
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y)
      for (int x = 0; x < count.x; ++x) {
        const glm::dvec3 at = bounds.low + (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(count) * extent;
        const double clearance = walls.nearest(at).distance;
        if ((!best || clearance > best->clearance) && walls.locate(at) == Walls::Side::inside) best = Roomiest{at, clearance};
      }
  if (!best) return best;
  // Then uphill. A step shorter than the clearance cannot leave through a wall.
  for (double reach = 0.5 * best->clearance; reach > 1e-4 * best->clearance;) {
    const Roomiest before = *best;
    for (int i = 0; i < 14; ++i) {
      const glm::dvec3 at = before.at + reach * fibonacci(i, 14);
      if (const double clearance = walls.nearest(at).distance; clearance > best->clearance) best = Roomiest{at, clearance};
    }
    if (best->at == before.at) reach *= 0.5;
    else reach = std::min(reach, 0.5 * before.clearance);
  }
  return best;
}

glm::dvec3 longest_sight(const Walls& walls, const glm::dvec3& eye, int count) {
  glm::dvec3 best = fibonacci(0, count);
  double farthest = -1;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 direction = fibonacci(i, count);
    const double free = walls.free_distance(eye, direction);
    if (free > farthest && std::isfinite(free)) {
      farthest = free;
      best = direction;
    }
  }
  return best;
}

}  // namespace odontoscope
