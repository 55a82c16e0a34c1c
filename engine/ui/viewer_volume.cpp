// The viewer before a volume: it asks where the surface lies, and reads the slices to look at meanwhile; what it works
// out of a volume that is shown; and where it looks at a film from.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/scene/deviation.h"
#include "engine/scene/fit_visible.h"
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
  preview_job_ =
      std::make_unique<Job<VolumePreview>>([preview = options_.preview, asked = state_.question->request](
                                               const Progress& progress) { return preview(asked, progress); });
}

void Viewer::update_question() {
  std::erase_if(stopped_previews_, [](const auto& job) { return job->finished(); });
  if (!preview_job_) return;
  if (!state_.question) {  // answered or called off before there was anything to see
    preview_job_->cancel();
    stopped_previews_.push_back(std::move(preview_job_));
    return;
  }
  state_.question->read = preview_job_->stage().fraction;
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

void Viewer::update_deviations() {
  if (!state_.shown || state_.draft) state_.data_colours_asked.reset();
  if (state_.data_colours_asked && !deviation_job_) {
    deviations_of_ = state_.shown;
    deviation_job_ = std::make_unique<Job<LoadedModel>>([of = state_.shown](const Progress&) {
      LoadedModel marked = *of;
      mark_deviations(marked.model, *marked.values, marked.isos);
      marked.deviations = deviations_in(marked.model);
      return marked;
    });
  }
  if (!deviation_job_ || !deviation_job_->finished()) return;
  const auto job = std::move(deviation_job_);
  auto marked = std::make_shared<const LoadedModel>(job->take());
  const bool still_shown = std::exchange(deviations_of_, nullptr) == state_.shown;
  const auto asked = std::exchange(state_.data_colours_asked, std::nullopt);
  if (!still_shown || !asked) return;
  gpu_model_ = upload(*gl_, marked->model);
  state_.shown = std::move(marked);
  if (state_.shown->deviations)
    state_.scene.data_colours = usual_data_colours(*asked, *state_.shown->deviations, *state_.shown->values);
  frames_to_settle_ = 3;
}

void Viewer::swing_tube(double degrees) {
  if (!state_.shown || state_.fly.on) return;
  const AnatomicalFrame tooth;
  Camera camera = transition_ ? transition_->goal() : state_.scene.camera;
  const double far = glm::distance(camera.position, camera.target), angle = glm::radians(degrees);
  camera.target = state_.shown->model.bounds_mm.centre();
  camera.position = camera.target +
                    far * (std::cos(angle) * tooth.buccal + std::sin(angle) * glm::cross(tooth.occlusal, tooth.buccal));
  camera.up = tooth.occlusal;
  transition_.reset();
  state_.scene.camera = camera;
}

void Viewer::show_film() {
  if (!state_.shown || state_.fly.on) return;
  constexpr double room = 1.08;
  const Camera goal = transition_ ? transition_->goal() : state_.scene.camera;
  const double aspect = panes_.front().area.aspect();
  Camera camera = fit_without(hidden_in(state_.scene), goal, state_.shown->model, aspect);
  const glm::dvec2& film = state_.scene.volume.film_mm;
  const double height = room * std::max(film.y, film.x / aspect);
  const glm::dvec3 towards = camera.position - camera.target;
  const double far = 0.5 * height / std::tan(glm::radians(camera.field_of_view_deg) / 2);
  if (film.x > 0) camera.target = state_.shown->model.bounds_mm.centre();
  camera.position = camera.target + std::max(1.0, far / glm::length(towards)) * towards;
  camera.height_mm = std::max(camera.height_mm, height);
  transition_.reset();
  state_.scene.camera = camera;
}

}  // namespace odontoscope
