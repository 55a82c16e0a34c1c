#include "engine/comparison/db_worker.h"

#include <utility>

namespace odontoscope {

DbWorker::DbWorker(std::shared_ptr<const ContourStack> stack)
    : pipeline_(std::move(stack)), thread_([this](const std::stop_token& leaving) { run(leaving); }) {}

DbWorker::~DbWorker() { leave(); }

void DbWorker::want(const ComparisonOptions& options) {
  const std::lock_guard lock(mutex_);
  if (!wish_ && at_work_on_ == options && !run_stop_.stop_requested()) return;
  wish_ = options;
  outcome_.reset();
  run_stop_.request_stop();
  wished_.notify_all();
}

void DbWorker::forget() {
  const std::lock_guard lock(mutex_);
  wish_.reset();
  outcome_.reset();
  run_stop_.request_stop();
}

bool DbWorker::working() const {
  const std::lock_guard lock(mutex_);
  return wish_ || (at_work_on_ && !run_stop_.stop_requested()) || outcome_;
}

DbWorker::Stage DbWorker::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

std::optional<DbWorker::Outcome> DbWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

void DbWorker::leave() {
  thread_.request_stop();
  forget();
}

bool DbWorker::gone() const {
  const std::lock_guard lock(mutex_);
  return gone_;
}

void DbWorker::run(const std::stop_token& leaving) {
  const auto report = [this](std::string_view name, double fraction) {
    const std::lock_guard lock(mutex_);
    stage_ = {std::string(name), fraction};
  };
  while (true) {
    Progress progress;
    ComparisonOptions options;
    {
      std::unique_lock lock(mutex_);
      if (!wished_.wait(lock, leaving, [this] { return wish_.has_value(); })) {
        gone_ = true;
        return;
      }
      options = *std::exchange(wish_, std::nullopt);
      at_work_on_ = options;
      run_stop_ = std::stop_source();
      stage_ = {};
      progress = {report, run_stop_.get_token()};
    }
    Outcome outcome;
    try {
      outcome.result = pipeline_.run(options, progress);
    } catch (...) {
      outcome.trouble = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    at_work_on_.reset();
    if (!run_stop_.stop_requested()) outcome_ = std::move(outcome);  // else nobody wants it any more
  }
}

}  // namespace odontoscope
