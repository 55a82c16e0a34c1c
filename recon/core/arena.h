#pragma once
// Where parallel work runs.

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <thread>

namespace odontoscope {

/// 0: as many as the machine has.
inline int threads_of(int wanted) {
  return wanted > 0 ? wanted : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// For as long as the result lives no more threads work, and as many may as are wanted, were it more than the machine
/// has: bytes do not depend on it.
[[nodiscard]] inline tbb::global_control allow_threads(int wanted) {
  return {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_of(wanted))};
}

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
