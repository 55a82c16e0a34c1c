#pragma once
// See parallel_for.h.

#include <tbb/blocked_range.h>

namespace tbb {

template <class Range, class Value, class Work, class Join>
Value parallel_reduce(const Range& range, const Value& identity, const Work& work, const Join&) {
  return range.empty() ? identity : work(range, identity);
}

}  // namespace tbb
