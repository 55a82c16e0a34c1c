#include "engine/headset_viewer/headset_comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "recon/core/grouped.h"

namespace odontoscope {

HeadsetComparison::HeadsetComparison(std::shared_ptr<const LoadedModel> loaded, const ComparisonState& desktop)
    : loaded_(std::move(loaded)),
      options_(desktop.made ? desktop.made->options : desktop.wanted),
      made_(desktop.made) {}

void HeadsetComparison::update(bool wanted) {
  if (made_ || !possible() || !trouble_.empty()) return;
  if (wanted && !worker_) {
    worker_ = worker_for(loaded_);
    worker_->want(options_);
  }
  if (!worker_) return;
  auto outcome = worker_->take();
  if (!outcome) return;
  made_ = std::move(outcome->result);
  if (outcome->trouble) trouble_ = words_for(outcome->trouble);
}

std::string HeadsetComparison::in_words() const {
  if (!trouble_.empty()) return trouble_;
  if (made_)
    return fmt::format("DB on a grid of {}: {} edges of cracks, {} misoriented.", made_->options.grid,
                       grouped(made_->cracks()), grouped(made_->misoriented()));
  if (!worker_) return {};
  const DbWorker::Stage stage = worker_->stage();
  return fmt::format("Making DB: {} {} %", stage.name, std::lround(100 * stage.fraction));
}

}  // namespace odontoscope
