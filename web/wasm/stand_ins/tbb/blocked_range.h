#pragma once
// See parallel_for.h.

#include <cstddef>

namespace tbb {

template <class Value>
class blocked_range {
 public:
  blocked_range(Value from, Value to, std::size_t = 1) : from_(from), to_(to) {}
  Value begin() const { return from_; }
  Value end() const { return to_; }
  bool empty() const { return !(from_ < to_); }

 private:
  Value from_, to_;
};

}  // namespace tbb
