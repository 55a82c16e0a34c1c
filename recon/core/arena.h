#pragma once
// Where parallel work runs.

#include <tbb/task_arena.h>

namespace odontoscope {

/// An arena of so many threads: the caller's own where that has as many, since oneTBB 2021.8 never gives back some 7 kB
/// of each arena that it made.
template <class Arena = tbb::task_arena>
Arena arena_of(int threads) {
  if constexpr (requires { typename Arena::attach; }) {  // WebAssembly has one thread, and no arena to be in
    if (threads == tbb::this_task_arena::max_concurrency()) return Arena(typename Arena::attach{});
  }
  return Arena(threads);
}

}  // namespace odontoscope
