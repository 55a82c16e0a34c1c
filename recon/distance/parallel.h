#pragma once
// Work on numbered layers, each independent of the others, in the caller's TBB arena. For the .cpp files of this room
// only.

#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>
#include <string_view>

#include "recon/core/progress.h"

namespace odontoscope::distance {

/// Calls work(i) for i in [0, count); tells how much of [from, to] of the stage is done, and throws Cancelled once
/// asked to stop.
struct Share {
  double from = 0, to = 1;
};
template <class Work>
void for_each_layer(std::size_t count, std::string_view stage, Share share, const Progress& progress, Work work) {
  std::atomic<std::size_t> done{0};
  std::mutex telling;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (progress.stop.stop_requested()) return;
    work(i);
    const double part = static_cast<double>(++done) / static_cast<double>(count);
    const std::lock_guard lock(telling);
    progress.tell(stage, share.from + (share.to - share.from) * part);
  });
  progress.check();
}

}  // namespace odontoscope::distance
