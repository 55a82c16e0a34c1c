// The viewer before a volume: it asks where the surface lies, and reads the slices to look at meanwhile.

#include <algorithm>
#include <utility>

#include "engine/ui/trouble.h"
#include "engine/ui/viewer.h"

namespace odontoscope {

void Viewer::ask_about(LoadRequest request) {
  state_.question = VolumeQuestion{.request = std::move(request)};
  if (preview_job_) {
    preview_job_->cancel();
    stopped_previews_.push_back(std::move(preview_job_));
  }
  if (!options_.preview) return;
  state_.question->reading = true;
  preview_job_ = std::make_unique<Job<VolumePreview>>(
      [preview = options_.preview, asked = state_.question->request](const Progress& progress) { return preview(asked, progress); });
}

void Viewer::tend_question() {
  std::erase_if(stopped_previews_, [](const auto& job) { return job->finished(); });
  if (!preview_job_) return;
  if (!state_.question) {   // answered or called off before there was anything to see
    preview_job_->cancel();
    stopped_previews_.push_back(std::move(preview_job_));
    return;
  }
  if (!preview_job_->finished()) return;
  const auto job = std::move(preview_job_);
  try {
    take_preview(*state_.question, job->take());
    frames_to_settle_ = 3;
  } catch (...) {
    state_.question.reset();
    failure_ = std::current_exception();
    state_.trouble = words_for_current_exception();
  }
}

}  // namespace odontoscope
