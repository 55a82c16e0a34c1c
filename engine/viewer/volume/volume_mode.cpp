#include "engine/viewer/volume/volume_mode.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/scene/deviation.h"
#include "engine/scene/fit_visible.h"
#include "engine/viewer/volume/film_panel.h"
#include "engine/viewer/volume/volume_panel.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

void VolumeMode::model_shown() {
  const auto& greys = state_.shown->greys;
  if (greys) layout_ = {.air = greys->air, .dentine = greys->dentine};
}

void VolumeMode::take_requests() {
  if (const auto degrees = std::exchange(asked_.tube, {})) swing_tube(*degrees);
  if (std::exchange(asked_.film, false)) show_film();
}

/// Measures, off the frame's thread, how the model lies to its data once somebody wants to see it.
void VolumeMode::update() {
  if (!state_.shown || state_.origin.draft) asked_.data_colours.reset();
  if (asked_.data_colours && !deviation_job_) {
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
  take_deviations(std::make_shared<const LoadedModel>(job->take()));
}

void VolumeMode::take_deviations(std::shared_ptr<const LoadedModel> marked) {
  const bool still_shown = std::exchange(deviations_of_, nullptr) == state_.shown;
  const auto asked = std::exchange(asked_.data_colours, std::nullopt);
  if (!still_shown || !asked) return;
  at_.picture.retake(marked->model);
  state_.shown = std::move(marked);
  if (state_.shown->deviations)
    state_.scene.data_colours = usual_data_colours(*asked, *state_.shown->deviations, *state_.shown->values);
  at_.frames_to_settle = 3;
}

void VolumeMode::swing_tube(double degrees) {
  if (!state_.shown || !at_.modes.effects().from_outside) return;
  const AnatomicalFrame tooth;
  Camera camera = at_.camera_goal();
  const double far = glm::distance(camera.position, camera.target), angle = glm::radians(degrees);
  camera.target = state_.shown->model.bounds_mm.centre();
  camera.position = camera.target +
                    far * (std::cos(angle) * tooth.buccal + std::sin(angle) * glm::cross(tooth.occlusal, tooth.buccal));
  camera.up = tooth.occlusal;
  at_.jump_to(camera);
}

void VolumeMode::show_film() {
  if (!state_.shown || !at_.modes.effects().from_outside) return;
  constexpr double room = 1.08;
  const Camera goal = at_.camera_goal();
  const double aspect = at_.front().area.aspect();
  Camera camera = fit_without(hidden_in(state_.scene), goal, state_.shown->model, aspect);
  const glm::dvec2& film = state_.scene.volume.film_mm;
  const double height = room * std::max(film.y, film.x / aspect);
  const glm::dvec3 towards = camera.position - camera.target;
  const double far = 0.5 * height / std::tan(glm::radians(camera.field_of_view_deg) / 2);
  if (film.x > 0) camera.target = state_.shown->model.bounds_mm.centre();
  camera.position = camera.target + std::max(1.0, far / glm::length(towards)) * towards;
  camera.height_mm = std::max(camera.height_mm, height);
  at_.jump_to(camera);
}

std::vector<PanelSection> VolumeMode::panel() {
  return {{SectionPlace::volume, [this] { volume_section(layout_, asked_, state_, at_.interface); }},
          {SectionPlace::film, [this] { film_section(asked_, state_, at_.interface); }}};
}

}  // namespace odontoscope
