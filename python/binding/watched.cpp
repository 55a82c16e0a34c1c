#include "python/binding/watched.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace odontoscope::python {
namespace {

/// What the worker has to say, and whether it is done.
class News {
 public:
  void tell(std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    if (stages_.empty() || stages_.back().first != stage)
      stages_.emplace_back(stage, fraction);
    else
      stages_.back().second = fraction;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }
  /// True once the work has ended.
  bool wait() {
    constexpr std::chrono::milliseconds beat{50};
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, beat, [this] { return ended_; });
  }
  std::vector<std::pair<std::string, double>> taken() {
    const std::lock_guard lock(mutex_);
    return std::exchange(stages_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::pair<std::string, double>> stages_;
  bool ended_ = false;
};

/// Where all watched work runs. Each thread that computes on its own would get an arena of its own, and oneTBB 2021.8
/// gives back none of their 9 kB. Lives until the process ends, since TBB may be gone before what is static here.
tbb::task_arena& common_arena() {
  static auto* const arena = new tbb::task_arena;
  return *arena;
}

/// With the interpreter's lock. Throws what a signal handler or the listener raises.
void look_after(News& news, const py::object& listener) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (listener.is_none()) return;
  for (const auto& [stage, fraction] : news.taken()) listener(stage, fraction);
}

}  // namespace

void run_watched(const py::object& listener, const std::function<void(const Progress&)>& work) {
  News news;
  std::stop_source stop;
  std::exception_ptr failed, raised;
  const bool heard = !listener.is_none();
  const Progress progress{[&](std::string_view stage, double fraction) {
                            if (heard) news.tell(stage, fraction);
                          },
                          stop.get_token()};
  {
    const py::gil_scoped_release unlocked;
    std::thread worker([&] {
      try {
        common_arena().execute([&] { work(progress); });
      } catch (...) {
        failed = std::current_exception();
      }
      news.end();
    });
    while (!news.wait()) {
      if (raised) continue;
      const py::gil_scoped_acquire locked;
      try {
        look_after(news, listener);
      } catch (...) {
        raised = std::current_exception();
        stop.request_stop();
      }
    }
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
  look_after(news, listener);
}

}  // namespace odontoscope::python
