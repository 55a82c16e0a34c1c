#pragma once
// The DB pipeline on a thread of its own: the newest wish counts, an outdated run is stopped, and nobody waits.

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "engine/comparison/db_pipeline.h"

namespace odontoscope {

class DbWorker {
 public:
  explicit DbWorker(std::shared_ptr<const ContourStack> stack);
  /// Stops the run and waits until it has noticed; where that must not be, `leave` first and destroy once `gone`.
  ~DbWorker();
  DbWorker(const DbWorker&) = delete;
  DbWorker& operator=(const DbWorker&) = delete;

  /// Returns at once. A run with other options is stopped; so is one whose outcome has not been taken.
  void want(const ComparisonOptions& options);
  /// Stops the run; nothing is wanted any more.
  void forget();
  bool working() const;

  struct Stage {
    std::string name;
    double fraction = 0;
  };
  Stage stage() const;

  /// The last wish's outcome, once: a result, or what was thrown.
  struct Outcome {
    std::shared_ptr<const ComparisonResult> result;
    std::exception_ptr trouble;
  };
  std::optional<Outcome> take();

  void leave();
  bool gone() const;

 private:
  void run(const std::stop_token& leaving);

  mutable std::mutex mutex_;
  std::condition_variable_any wished_;
  std::optional<ComparisonOptions> wish_;  // not begun
  std::optional<ComparisonOptions> at_work_on_;
  std::stop_source run_stop_;
  Stage stage_;
  std::optional<Outcome> outcome_;
  bool gone_ = false;
  DbPipeline pipeline_;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace odontoscope
