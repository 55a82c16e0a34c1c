#include "engine/ui/loading.h"

#include <chrono>
#include <utility>

namespace odontoscope {

LoadJob::LoadJob(Loader loader, LoadRequest request) : request_(std::move(request)) {
  std::promise<LoadedModel> promise;
  result_ = promise.get_future();
  thread_ = std::jthread([this, loader = std::move(loader), promise = std::move(promise)](std::stop_token stop) mutable {
    const auto report = [this](std::string_view name, double fraction) {
      const std::lock_guard lock(mutex_);
      stage_ = {std::string(name), fraction};
    };
    try {
      promise.set_value(loader(request_, {report, stop}));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  });
}

LoadJob::Stage LoadJob::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

bool LoadJob::finished() const { return result_.valid() && result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace odontoscope
