#pragma once
// A tree of boxes over numbered things that move, grow and vanish, but stay near where they were: triangles of a
// surface that is being simplified. Its shape is settled once (halved at the median along the longer axis); afterwards
// only boxes change, so it stays good for as long as each thing keeps its neighbourhood.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

struct MovingBox {
  static constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{far, far, far}, high{-far, -far, -far};  // holds nothing

  void add(const Point3& p) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
  }
  void add(const MovingBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.low[axis]);
      high[axis] = std::max(high[axis], box.high[axis]);
    }
  }
  void grow(double by) {
    for (int axis = 0; axis < 3; ++axis) low[axis] -= by, high[axis] += by;
  }
  bool empty() const { return low[0] > high[0]; }
  double extent(int axis) const { return empty() ? 0 : high[axis] - low[axis]; }
  double longest() const { return std::max({extent(0), extent(1), extent(2)}); }
  bool meets(const MovingBox& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (low[axis] > box.high[axis] || box.low[axis] > high[axis]) return false;
    }
    return true;
  }
  bool holds(const Point3& p) const {
    return low[0] <= p.x && p.x <= high[0] && low[1] <= p.y && p.y <= high[1] && low[2] <= p.z && p.z <= high[2];
  }
};

class MovingBoxTree {
 public:
  explicit MovingBoxTree(const std::vector<MovingBox>& boxes)
      : leaves_(std::bit_ceil(std::max<std::size_t>(boxes.size(), 1))),
        nodes_(2 * leaves_),
        place_(boxes.size()),
        thing_(leaves_, none) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    settle(boxes, order, 0, order.size(), 0, leaves_);
    for (std::size_t node = leaves_; node-- > 1;) {
      nodes_[node] = nodes_[2 * node];
      nodes_[node].add(nodes_[2 * node + 1]);
    }
  }

  /// An empty box takes the thing out.
  void move(std::size_t thing, const MovingBox& box) {
    std::size_t node = leaves_ + place_[thing];
    nodes_[node] = box;
    while (node > 1) {
      node /= 2;
      nodes_[node] = nodes_[2 * node];
      nodes_[node].add(nodes_[2 * node + 1]);
    }
  }

  /// Calls `found(thing)` for each whose box meets this one, until it returns true; returns whether it did.
  template <class Found>
  bool any(const MovingBox& box, const Found& found) const {
    std::array<std::size_t, 128> open;
    std::size_t count = 0;
    open[count++] = 1;
    while (count > 0) {
      const std::size_t node = open[--count];
      if (!nodes_[node].meets(box)) continue;
      if (node >= leaves_) {
        if (found(thing_[node - leaves_])) return true;
        continue;
      }
      open[count++] = 2 * node + 1;
      open[count++] = 2 * node;
    }
    return false;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Things order[from, to) go to the `room` leaves from `leaf` on.
  void settle(const std::vector<MovingBox>& boxes, std::vector<std::uint32_t>& order, std::size_t from, std::size_t to,
              std::size_t leaf, std::size_t room) {
    if (from == to) return;
    if (room == 1) {
      place_[order[from]] = static_cast<std::uint32_t>(leaf);
      thing_[leaf] = order[from];
      nodes_[leaves_ + leaf] = boxes[order[from]];
      return;
    }
    MovingBox all;
    for (std::size_t n = from; n < to; ++n) all.add(boxes[order[n]]);
    int axis = 0;
    for (const int other : {1, 2}) {
      if (all.extent(other) > all.extent(axis)) axis = other;
    }
    const std::size_t middle = from + (to - from) / 2;
    const auto begin = order.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(to), [&](std::uint32_t a, std::uint32_t b) {
                       const double at_a = boxes[a].low[axis] + boxes[a].high[axis];
                       const double at_b = boxes[b].low[axis] + boxes[b].high[axis];
                       return at_a != at_b ? at_a < at_b : a < b;
                     });
    settle(boxes, order, from, middle, leaf, room / 2);
    settle(boxes, order, middle, to, leaf + room / 2, room / 2);
  }

  std::size_t leaves_;
  std::vector<MovingBox> nodes_;      // node n has the children 2n and 2n + 1; leaves come last
  std::vector<std::uint32_t> place_;  // leaf of each thing
  std::vector<std::uint32_t> thing_;  // of each leaf
};

}  // namespace odontoscope
