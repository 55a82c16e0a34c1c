#pragma once
// TBB's parallel_for on the one thread that a WebAssembly module has: the same calls, in order. What this project uses
// of it, no more.

#include <tbb/blocked_range.h>

namespace tbb {

template <class Index, class Work>
void parallel_for(Index from, Index to, const Work& work) {
  for (Index i = from; i < to; ++i) work(i);
}

template <class Value, class Work>
void parallel_for(const blocked_range<Value>& range, const Work& work) {
  if (!range.empty()) work(range);
}

}  // namespace tbb
