#pragma once
// See pool.h.

#include <tbb/blocked_range.h>

#include <vector>

namespace tbb {

/// The parts are joined in their order.
template <class Range, class Value, class Work, class Join>
Value parallel_reduce(const Range& range, const Value& identity, const Work& work, const Join& join) {
  std::vector<Value> values(range.parts(), identity);
  detail::run(values.size(), [&](std::size_t i) { values[i] = work(range.part(i, values.size()), identity); });
  Value all = identity;
  for (const Value& value : values) all = join(all, value);
  return all;
}

}  // namespace tbb
