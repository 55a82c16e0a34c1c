// Models that are opened: asked for, shown as a draft, shown, or given up.
#include <algorithm>
#include <utility>

#include "engine/scene/fit_visible.h"
#include "engine/ui/names.h"
#include "engine/ui/trouble.h"
#include "engine/ui/viewer.h"

namespace odontoscope {

void Viewer::open(LoadRequest request) {
  if (job_) {
    job_->cancel();
    stopped_jobs_.push_back(std::move(job_));
  }
  state_.trouble.clear();
  failure_ = nullptr;
  if (notes_at_risk() && !notes_may_go_) {
    state_.notes.leaving = LeavingNotes{std::move(request)};
    return;
  }
  if (open_lesson(request)) return;
  if (options_.wants_level(request)) return ask_about(std::move(request));
  job_ = std::make_unique<LoadJob>(options_.load, request, options_.with_drafts && (!state_.shown || state_.draft));
}

void Viewer::take_finished_load() {
  std::erase_if(stopped_jobs_, [](const auto& job) { return job->finished(); });
  if (std::exchange(state_.cancel_loading, false) && job_) job_->cancel();
  if (!job_) return;
  take_draft();
  if (!job_->finished()) return;
  const std::unique_ptr<LoadJob> job = std::move(job_);
  failure_ = nullptr;
  const bool lesson_follows = std::exchange(lesson_after_load_, false);
  try {
    auto made = std::make_shared<const LoadedModel>(job->take());
    // Who turned the draft goes on from there.
    const std::optional<Camera> turned =
        state_.draft && draft_camera_ && !made->camera_given && state_.scene.camera != *draft_camera_
            ? std::optional(state_.scene.camera)
            : std::nullopt;
    show(std::move(made));
    if (turned) state_.scene.camera = *turned;
    sample_shown_ = job->request().file.empty();
    // As if it were opened by its name alone: of a volume that would be asked about.
    const bool by_name = !job->request().volume && !options_.wants_level({.file = job->request().file, .volume = {}});
    file_shown_ = by_name ? job->request().file : std::string();
    if (!job->request().file.empty()) remember_file(state_.settings, job->request().file);
    if (notes_at_risk() && !notes_may_go_) save_notes();  // written while it loaded: nobody was asked
    notes_may_go_ = false;
    state_.notes = {};
    lesson_.leave();
    if (auto tour = std::exchange(lesson_to_load_, std::nullopt)) take_lesson(std::move(*tour));
    if (lesson_follows) begin_lesson();
  } catch (const Cancelled&) {
    give_up_loading();
    notice("Stopped.");
  } catch (...) {
    give_up_loading();
    failure_ = std::current_exception();
    state_.trouble = words_for_current_exception();
  }
}

void Viewer::give_up_loading() {
  lesson_to_load_.reset();
  notes_may_go_ = false;
  if (!std::exchange(state_.draft, false)) return;
  end_flight();
  state_.shown.reset();  // it stood for a model that will not be
  state_.names.clear();
}

void Viewer::take_draft() {
  if (job_->finished() || job_->cancelling() || (state_.shown && !state_.draft)) return;
  if (auto draft = job_->take_draft()) {
    show(std::move(draft));
    state_.draft = true;
    draft_camera_ = state_.scene.camera;
  }
}

void Viewer::show(std::shared_ptr<const LoadedModel> shown) {
  state_.draft = false;
  end_flight();
  fade_.reset();
  state_.fly.dark = 0;
  leave_lab();
  gpu_model_ = upload(*gl_, shown->model);
  gpu_overlay_ = {};
  overlays_made_ = {};
  gpu_volume_.reset();
  gpu_values_.reset();
  state_.scene = shown->scene;
  if (shown->greys) state_.volume_layout = {.air = shown->greys->air, .dentine = shown->greys->dentine};
  // The same plane, its handle where the model is.
  if (auto& section = state_.scene.section)
    section = with_offset(*section, offset_of(*section, shown->model), shown->model);
  if (!shown->back_faces_given) state_.scene.back_faces = state_.settings.back_faces;
  if (!shown->looks_given) apply_remembered(state_.settings, state_.scene);
  if (!shown->background_given) state_.scene.background = background_of(state_.settings.backdrop);
  if (!shown->camera_given)
    state_.scene.camera = fit_without(hidden_in(state_.scene), NamedView::three_quarter, shown->model,
                                      panes_.front().area.aspect(), state_.settings.projection);
  state_.shown = std::move(shown);
  state_.names = named_places(state_.shown->model, state_.shown->scene);
  state_.name_told.reset();
  state_.section_put_away.reset();
  state_.tool = Tool::look;
  state_.measured = {};
  state_.looked_at.reset();
  state_.under_pointer.reset();
  state_.canal.reset();
  state_.canal_under_pointer.reset();
  transition_.reset();
  look_transition_.reset();
  drag_.reset();
}

}  // namespace odontoscope
