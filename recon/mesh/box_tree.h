#pragma once
// A binary tree of boxes over numbered things, usually triangles: which could be nearest, which could a line meet?
//
// It holds boxes and numbers only; whoever owns the things asks them for what is exact. `Vector` is any type of three
// coordinates with [] (std::array, glm's): float where memory counts, double else. Same boxes, same tree. After it is
// made it may be read from any number of threads.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace odontoscope {

template <class Vector>
class BoxTree {
 public:
  using Scalar = std::remove_cvref_t<decltype(std::declval<Vector>()[0])>;
  struct Bounds {
    Vector low, high;
  };

  BoxTree() = default;

  /// `bounds[i]` encloses thing i; none may hold NaN. Halved at the median of the axis along which the boxes' middles
  /// spread most, down to four things. `made` is told now and then how many things have found their place and may
  /// throw.
  template <class Made>
  BoxTree(const std::vector<Bounds>& bounds, Made made) : order_(bounds.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (bounds.empty()) return;
    nodes_.reserve(bounds.size());
    nodes_.emplace_back();
    std::vector<Part> open = {{0, 0, static_cast<std::uint32_t>(bounds.size())}};
    std::uint32_t placed = 0, told = 0;
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      const std::uint32_t children = divide(part, bounds);
      if (children == 0) {
        placed += part.count;
        if (placed - told >= 4096) made(told = placed);
        continue;
      }
      const std::uint32_t half = part.count / 2;
      open.push_back({children + 1, part.first + half, part.count - half});
      open.push_back({children, part.first, half});
    }
  }
  explicit BoxTree(const std::vector<Bounds>& bounds) : BoxTree(bounds, [](std::uint32_t) {}) {}

  bool empty() const { return nodes_.empty(); }

  /// The things' numbers leaf by leaf. Owners keep their things in this order: searches speak of places in it.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Encloses all. Precondition: not empty().
  Bounds bounds() const { return {nodes_[0].low, nodes_[0].high}; }

  /// Calls `ask(first, end)` for runs of places whose box is nearer to `place` than the square root of `square`, nearer
  /// boxes first. `ask` lowers `square` when it finds something. Ends once `square` is not more than `enough`.
  template <class Place, class Ask>
  void nearest_first(const Place& place, double& square, double enough, Ask ask) const {
    if (nodes_.empty()) return;
    struct Waiting {
      std::uint32_t node;
      double square;
    };
    std::array<Waiting, deepest> waiting;
    std::size_t count = 0;
    waiting[count++] = {0, squared_distance(nodes_[0], place)};
    while (count > 0 && square > enough) {
      const Waiting next = waiting[--count];
      if (next.square >= square) continue;
      const Node& node = nodes_[next.node];
      if (node.count > 0) {
        ask(node.first, node.first + node.count);
        continue;
      }
      const double left = squared_distance(nodes_[node.first], place),
                   right = squared_distance(nodes_[node.first + 1], place);
      const bool left_first = left <= right;
      if (const double far = left_first ? right : left; far < square)
        waiting[count++] = {node.first + (left_first ? 1 : 0), far};
      if (const double near = left_first ? left : right; near < square)
        waiting[count++] = {node.first + (left_first ? 0 : 1), near};
    }
  }

  /// Calls `ask(first, end)` for runs of places in whose box `may_hold(low, high)`, those nearer along `direction`
  /// mostly first. Ends when `ask` returns false.
  template <class Place, class MayHold, class Ask>
  void along(const Place& direction, MayHold may_hold, Ask ask) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, deepest> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (!may_hold(node.low, node.high)) continue;
      if (node.count > 0) {
        if (!ask(node.first, node.first + node.count)) return;
        continue;
      }
      const Node &left = nodes_[node.first], &right = nodes_[node.first + 1];
      double ahead = 0;
      for (int axis = 0; axis < 3; ++axis)
        ahead += direction[axis] * (double(right.low[axis]) + right.high[axis] - left.low[axis] - left.high[axis]);
      const bool left_first = ahead > 0;
      waiting[count++] = node.first + (left_first ? 1 : 0);
      waiting[count++] = node.first + (left_first ? 0 : 1);
    }
  }

 private:
  struct Node {
    Vector low, high;
    std::uint32_t first;  // of its places, or of its two children
    std::uint32_t count;  // places; 0 for a node with children
  };
  struct Part {
    std::uint32_t node, first, count;
  };
  static constexpr std::uint32_t most_in_leaf = 4;
  /// A tree over 2^32 things that is halved each time is 32 deep; one more waits on each level.
  static constexpr std::size_t deepest = 64;

  template <class Place>
  static double squared_distance(const Node& node, const Place& place) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double off =
          std::max(std::max(double(node.low[axis]) - place[axis], place[axis] - double(node.high[axis])), 0.0);
      sum += off * off;
    }
    return sum;
  }

  /// Boxes the part and halves it. Returns the first of its two children, or 0 for a leaf.
  std::uint32_t divide(const Part& part, const std::vector<Bounds>& bounds) {
    const auto begin = order_.begin() + part.first, end = begin + part.count;
    const auto twice_middle = [&](std::uint32_t i, int axis) { return bounds[i].low[axis] + bounds[i].high[axis]; };
    Bounds all = bounds[*begin];
    std::array<Scalar, 3> spread{};
    for (int axis = 0; axis < 3; ++axis) {
      Scalar least = twice_middle(*begin, axis), most = least;
      for (auto i = begin; i != end; ++i) {
        all.low[axis] = std::min(all.low[axis], bounds[*i].low[axis]);
        all.high[axis] = std::max(all.high[axis], bounds[*i].high[axis]);
        least = std::min(least, twice_middle(*i, axis));
        most = std::max(most, twice_middle(*i, axis));
      }
      spread[axis] = most - least;
    }
    nodes_[part.node] = {all.low, all.high, part.first, part.count};
    if (part.count <= most_in_leaf) {
      std::sort(begin, end);  // which of two equally near is met first does not depend on how nth_element went about it
      return 0;
    }
    const int axis = spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : spread[1] >= spread[2] ? 1 : 2;
    std::nth_element(begin, begin + part.count / 2, end, [&](std::uint32_t a, std::uint32_t b) {
      const Scalar u = twice_middle(a, axis), v = twice_middle(b, axis);
      return u != v ? u < v : a < b;
    });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[part.node].first = children;
    nodes_[part.node].count = 0;
    nodes_.resize(nodes_.size() + 2);
    return children;
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace odontoscope
