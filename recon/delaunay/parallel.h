#pragma once
// Work on numbered items, each independent of the others, on a given number of threads.

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <string_view>
#include <vector>

#include "recon/core/progress.h"

namespace odontoscope::delaunay {

/// Calls work(i) for i in [0, count), tells `progress` and checks for cancellation. If calls throw, the exception of the lowest i is thrown
/// again, so that the same input gives the same error on any number of threads.
template <class Work>
void for_each(std::size_t count, tbb::task_arena& arena, std::string_view stage, const Progress& progress, Work work) {
  std::vector<std::exception_ptr> failed(count);
  std::atomic<std::size_t> done{0};
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      try {
        progress.check();
        work(i);
      } catch (...) {
        failed[i] = std::current_exception();
      }
      const std::size_t so_far = ++done;
      progress.tell(stage, static_cast<double>(so_far) / static_cast<double>(count));
    });
  });
  for (const std::exception_ptr& failure : failed)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace odontoscope::delaunay
