#pragma once
// See pool.h.

#include <tbb/pool.h>

#include <algorithm>

namespace tbb {

class task_arena {
 public:
  explicit task_arena(int threads = detail::allowed()) : threads_(std::max(1, threads)) {}
  int max_concurrency() const { return std::min(threads_, detail::allowed()); }
  template <class Work>
  auto execute(const Work& work) {
    const detail::Bound bound(threads_);
    return work();
  }

 private:
  int threads_;
};

namespace this_task_arena {
inline int max_concurrency() { return detail::allowed(); }
template <class Work>
auto isolate(const Work& work) {
  return work();
}
}  // namespace this_task_arena

}  // namespace tbb
