#pragma once
// Stand-ins for what this project uses of TBB, where a WebAssembly module has several threads (stand_ins has those for
// one): a pool of threads that is as large as JavaScript made it, and work that may be nested.

#include <cstddef>

namespace tbb::detail {

/// Calls call(work, i) for i in [0, count) on this thread and those of the pool that are free, at most allowed()
/// together. Whoever waits for it waits for no more than its own items. The exception of the lowest i is thrown.
void run(std::size_t count, void (*call)(const void* work, std::size_t i), const void* work);

/// How many threads work may be done by here.
int allowed();

/// On this thread, and in what it begins; never more than the pool has.
class Bound {
 public:
  explicit Bound(int threads);
  ~Bound();
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

 private:
  int before_;
};

template <class Work>
void run(std::size_t count, const Work& work) {
  run(
      count, [](const void* given, std::size_t i) { (*static_cast<const Work*>(given))(i); }, &work);
}

}  // namespace tbb::detail
