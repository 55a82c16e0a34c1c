#pragma once
// Numbers that are joined to each other, as the oracle has them: plain and small, and nothing of the engine's.

#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace odontoscope::test {

class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
  /// For each its class, numbered from 0.
  std::vector<std::size_t> classes(std::size_t& count) const {
    std::map<std::size_t, std::size_t> number;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < parent_.size(); ++i)
      result.push_back(number.emplace(find(i), number.size()).first->second);
    count = number.size();
    return result;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace odontoscope::test
