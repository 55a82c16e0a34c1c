#pragma once
// Things that are joined, and which are then in one group: disjoint sets with path halving.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace odontoscope {

class UnionFind {
 public:
  /// Things 0 to count - 1, each by itself.
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// The least thing of the group.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace odontoscope
