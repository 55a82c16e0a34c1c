#pragma once
// Work on numbered items, each independent of the others. Header only: a room that includes it links TBB.

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <string_view>
#include <vector>

#include "recon/core/progress.h"

namespace odontoscope {

/// What part of a stage this is.
struct Share {
  double from = 0, to = 1;
};

/// Calls work(i) for i in [0, count) in the caller's TBB arena, tells how much of the share is done, and throws
/// Cancelled once asked to stop. If calls throw, the exception of the lowest i is thrown again, so that the same input
/// gives the same error on any number of threads.
template <class Work>
void for_each(std::size_t count, std::string_view stage, Share share, const Progress& progress, Work work) {
  std::vector<std::exception_ptr> failed(count);
  std::atomic<std::size_t> done{0};
  std::mutex telling;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    try {
      progress.check();
      work(i);
    } catch (...) {
      failed[i] = std::current_exception();
    }
    const double part = static_cast<double>(++done) / static_cast<double>(count);
    const std::lock_guard lock(telling);
    progress.tell(stage, share.from + (share.to - share.from) * part);
  });
  for (const std::exception_ptr& failure : failed)
    if (failure) std::rethrow_exception(failure);
}

/// The same in an arena, which sets the number of threads.
template <class Work>
void for_each(std::size_t count, tbb::task_arena& arena, std::string_view stage, const Progress& progress, Work work) {
  arena.execute([&] { for_each(count, stage, {}, progress, work); });
}

}  // namespace odontoscope
