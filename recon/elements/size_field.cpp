#include "recon/elements/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "recon/elements/limits.h"
#include "recon/mesh/box_tree.h"
#include "recon/mesh/corners.h"

namespace odontoscope::elements {
namespace {

using Vector = std::array<double, 3>;
using Tree = BoxTree<Vector>;

/// The faces, to be met by rays. In doubles: a size is no decision that must be exact.
class Walls {
 public:
  explicit Walls(const InterfaceWeb& web) : web_(web) {
    std::vector<Tree::Bounds> bounds;
    for (std::uint32_t f = 0; f < web.faces().size(); ++f) bounds.push_back(box_round(corners(f)));
    tree_ = Tree(bounds);
  }

  Corners corners(std::uint32_t f) const {
    const Triangle& t = web_.faces()[f].triangle;
    return {web_.points()[t[0]], web_.points()[t[1]], web_.points()[t[2]]};
  }
  Direction normal(std::uint32_t f) const {
    const Direction n = normal_of(corners(f));
    const double l = length(n);
    return l > 0 ? (1 / l) * n : Direction{};
  }

  /// From the middle of a face along a unit vector to the first wall that faces it, no farther than `most`.
  double thickness(std::uint32_t from, const Direction& along, double most) const {
    const Point3 start = middle_of(corners(from));
    double nearest = most;
    const Vector origin{start.x, start.y, start.z}, way{along.x, along.y, along.z};
    tree_.along(
        way, [&](const Vector& low, const Vector& high) { return crosses(low, high, origin, way, nearest); },
        [&](std::uint32_t first, std::uint32_t end) {
          for (std::uint32_t i = first; i < end; ++i) {
            const std::uint32_t f = tree_.order()[i];
            if (f != from && std::abs(dot(normal(f), along)) > limits::facing_cosine)
              nearest = std::min(nearest, hit(f, start, along));
          }
          return true;
        });
    return nearest;
  }

 private:
  static bool crosses(const Vector& low, const Vector& high, const Vector& from, const Vector& way, double most) {
    double enter = 0, leave = most;
    for (int axis = 0; axis < 3; ++axis) {
      if (way[axis] == 0) {
        if (from[axis] < low[axis] || from[axis] > high[axis]) return false;
        continue;
      }
      double near = (low[axis] - from[axis]) / way[axis], far = (high[axis] - from[axis]) / way[axis];
      if (near > far) std::swap(near, far);
      enter = std::max(enter, near);
      leave = std::min(leave, far);
    }
    return enter <= leave;
  }

  /// Infinite if the ray misses the face. After T. Moeller and B. Trumbore, 1997.
  double hit(std::uint32_t f, const Point3& from, const Direction& along) const {
    constexpr double miss = std::numeric_limits<double>::infinity();
    const auto [a, b, c] = corners(f);
    const Direction ab = b - a, ac = c - a, p = cross(along, ac);
    const double det = dot(ab, p);
    if (det == 0) return miss;
    const Direction off = from - a;
    const double u = dot(off, p) / det;
    if (u < 0 || u > 1) return miss;
    const Direction q = cross(off, ab);
    const double v = dot(along, q) / det;
    if (v < 0 || u + v > 1) return miss;
    const double at = dot(ac, q) / det;
    return at > 0 ? at : miss;
  }

  const InterfaceWeb& web_;
  Tree tree_;
};

/// No vertex may be much coarser than its neighbours.
void grade(const InterfaceWeb& web, std::vector<double>& size) {
  using Entry = std::tuple<double, PointIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (PointIndex v = 0; v < size.size(); ++v) queue.emplace(size[v], v);
  while (!queue.empty()) {
    const auto [own, v] = queue.top();
    queue.pop();
    if (own > size[v]) continue;
    for (const InterfaceWeb::Neighbour& n : web.ring(v)) {
      const double most = own + limits::size_gradient * length(web.points()[n.vertex] - web.points()[v]);
      if (size[n.vertex] > most) queue.emplace(size[n.vertex] = most, n.vertex);
    }
  }
}

}  // namespace

std::vector<double> size_field(const InterfaceWeb& web, double size) {
  std::vector<double> sizes(web.points().size(), size);
  const Walls walls(web);
  const double most = size / limits::size_of_thickness, least = size * limits::least_of_size;
  for (std::uint32_t f = 0; f < web.faces().size(); ++f) {
    const Direction outwards = walls.normal(f);
    double thickness = walls.thickness(f, -1.0 * outwards, most);
    if (web.faces()[f].outer != void_label) thickness = std::min(thickness, walls.thickness(f, outwards, most));
    const double own = std::clamp(limits::size_of_thickness * thickness, least, size);
    for (const PointIndex v : web.faces()[f].triangle) sizes[v] = std::min(sizes[v], own);
  }
  grade(web, sizes);
  return sizes;
}

}  // namespace odontoscope::elements
