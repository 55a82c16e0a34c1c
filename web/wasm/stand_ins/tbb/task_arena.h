#pragma once
// See parallel_for.h.

namespace tbb {

class task_arena {
 public:
  explicit task_arena(int = 1) {}
  int max_concurrency() const { return 1; }
  template <class Work>
  auto execute(const Work& work) {
    return work();
  }
};

namespace this_task_arena {
inline int max_concurrency() { return 1; }
template <class Work>
auto isolate(const Work& work) {
  return work();
}
}  // namespace this_task_arena

}  // namespace tbb
