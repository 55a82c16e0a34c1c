#pragma once
// See pool.h.

#include <tbb/pool.h>

#include <algorithm>
#include <cstddef>

namespace tbb {

template <class Value>
class blocked_range {
 public:
  blocked_range(Value from, Value to, std::size_t grain = 1) : from_(from), to_(to), grain_(grain) {}
  Value begin() const { return from_; }
  Value end() const { return to_; }
  bool empty() const { return !(from_ < to_); }
  std::size_t size() const { return empty() ? 0 : static_cast<std::size_t>(to_ - from_); }

  /// How many parts it is done in.
  std::size_t parts() const {
    constexpr std::size_t each = 8;  // parts a thread, so that none waits long for the last
    const std::size_t most = (size() + grain_ - 1) / grain_;
    return std::min(most, each * static_cast<std::size_t>(detail::allowed()));
  }
  blocked_range part(std::size_t i, std::size_t of) const {
    const auto at = [&](std::size_t n) {
      return static_cast<Value>(from_ + static_cast<Value>(size() / of * n + std::min(n, size() % of)));
    };
    return {at(i), at(i + 1), grain_};
  }

 private:
  Value from_, to_;
  std::size_t grain_;
};

}  // namespace tbb
