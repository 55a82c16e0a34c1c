#pragma once
// See pool.h.

#include <tbb/blocked_range.h>

namespace tbb {

template <class Value, class Work>
void parallel_for(const blocked_range<Value>& range, const Work& work) {
  const std::size_t parts = range.parts();
  detail::run(parts, [&](std::size_t i) { work(range.part(i, parts)); });
}

template <class Index, class Work>
void parallel_for(Index from, Index to, const Work& work) {
  parallel_for(blocked_range<Index>(from, to), [&](const blocked_range<Index>& part) {
    for (Index i = part.begin(); i < part.end(); ++i) work(i);
  });
}

}  // namespace tbb
