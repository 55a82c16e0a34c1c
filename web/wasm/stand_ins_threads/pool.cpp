#include <emscripten.h>
#include <tbb/pool.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

// clang-format off
EM_JS(int, odontoscope_threads, (), { return Module.threads || 1; });
// clang-format on

namespace tbb::detail {
namespace {

/// Items that are handed out one by one, each once.
struct Job {
  std::size_t count;
  void (*call)(const void*, std::size_t);
  const void* work;
  int bound;  // threads in all
  std::atomic<std::size_t> next{0};
  int helpers = 0;  // besides who began it; the pool's mutex guards what follows
  std::size_t failed = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure;
};

thread_local int bound_here = std::numeric_limits<int>::max();

class Pool {
 public:
  Pool() : size_(odontoscope_threads()) {
    for (int n = 1; n < size_; ++n) std::thread([this] { help(); }).detach();  // they end with the module
  }
  int size() const { return size_; }
  void be_alone() { size_ = 1; }

  void run(Job& job) {
    if (job.count < 2 || job.bound < 2 || size_ < 2) return alone(job);
    {
      const std::lock_guard lock(mutex_);
      jobs_.push_back(&job);
    }
    wanted_.notify_all();
    work(job);
    std::unique_lock lock(mutex_);
    jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job));
    done_.wait(lock, [&job] { return job.helpers == 0; });
    lock.unlock();
    if (job.failure) std::rethrow_exception(job.failure);
  }

 private:
  static void alone(Job& job) {
    for (std::size_t i = 0; i < job.count; ++i) job.call(job.work, i);
  }

  void work(Job& job) {
    for (std::size_t i = job.next++; i < job.count; i = job.next++) {
      try {
        job.call(job.work, i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (i < job.failed) job.failed = i, job.failure = std::current_exception();
      }
    }
  }

  /// The latest that wants help: it is what somebody waits for within another. Null: none.
  Job* wanting() const {
    const auto wants = [](const Job* job) { return job->next < job->count && job->helpers + 1 < job->bound; };
    const auto found = std::find_if(jobs_.rbegin(), jobs_.rend(), wants);
    return found == jobs_.rend() ? nullptr : *found;
  }

  [[noreturn]] void help() {
    std::unique_lock lock(mutex_);
    while (true) {
      Job* job = nullptr;
      wanted_.wait(lock, [&] { return (job = wanting()) != nullptr; });
      ++job->helpers;
      lock.unlock();
      bound_here = job->bound;
      work(*job);
      lock.lock();
      if (--job->helpers == 0) done_.notify_all();
    }
  }

  int size_;
  std::mutex mutex_;
  std::condition_variable wanted_, done_;
  std::vector<Job*> jobs_;
};

Pool& pool() {
  static Pool& made = *new Pool;  // its threads outlive all that could end it
  return made;
}

}  // namespace

void run(std::size_t count, void (*call)(const void*, std::size_t), const void* work) {
  Job job{.count = count, .call = call, .work = work, .bound = bound_here};
  pool().run(job);
}

int allowed() { return std::max(1, std::min(bound_here, pool().size())); }

Bound::Bound(int threads) : before_(bound_here) { bound_here = std::max(1, std::min(before_, threads)); }
Bound::~Bound() { bound_here = before_; }

}  // namespace tbb::detail

/// The pool's threads are about to be ended: what is done later is done by the first alone.
extern "C" EMSCRIPTEN_KEEPALIVE void odontoscope_be_alone() { tbb::detail::pool().be_alone(); }
