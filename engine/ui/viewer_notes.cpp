// A teacher's notes: written, saved, opened, and played as a lesson.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/ui/viewer.h"
#include "recon/core/atomic_file.h"
#include "recon/core/error.h"

namespace odontoscope {

namespace {

/// Without looks of structures that this model does not have.
Scene of_model(Scene scene, const Model& model) {
  std::erase_if(scene.looks, [&](const Look& look) { return std::none_of(model.parts.begin(), model.parts.end(), [&](const ModelPart& part) { return part.structure == look.structure; }); });
  return scene;
}

}  // namespace

void keep_draft(NotesState& notes) {
  TourNote note = std::move(*std::exchange(notes.draft, std::nullopt));
  if (note.title.empty()) note.title = fmt::format("Note {}", notes.tour.notes.size() + 1);
  notes.tour.notes.push_back(std::move(note));
  notes.unsaved = true;
}

/// What the panels asked for.
void Viewer::tend_notes() {
  NotesState& notes = state_.notes;
  if (std::exchange(notes.write, false)) write_note();
  if (std::exchange(notes.save, false)) save_notes();
  if (const auto wanted = std::exchange(notes.go_to, {})) go_to_note(*wanted);
  answer_about_notes();
}

bool Viewer::notes_at_risk() const {
  const NotesState& notes = state_.notes;
  return notes.unsaved || (notes.draft && !(notes.draft->title.empty() && notes.draft->text.empty()));
}

bool Viewer::may_close() {
  if (!notes_at_risk()) return true;
  if (!state_.notes.leaving) state_.notes.leaving = LeavingNotes{};
  return false;
}

void Viewer::answer_about_notes() {
  using Answer = LeavingNotes::Answer;
  NotesState& notes = state_.notes;
  if (!notes.leaving || notes.leaving->answer == Answer::none) return;
  const LeavingNotes leaving = std::move(*std::exchange(notes.leaving, std::nullopt));
  if (leaving.answer == Answer::save) save_notes();
  if (leaving.answer == Answer::stay || (leaving.answer == Answer::save && notes_at_risk())) {   // or it could not be written
    lesson_after_load_ = false;
    return;
  }
  if (!leaving.to_open) {
    state_.close = true;
    return;
  }
  notes_may_go_ = true;
  open(*leaving.to_open);
  if (!job_) notes_may_go_ = false;
}

bool Viewer::perform_on_notes(Action action) {
  NotesState& notes = state_.notes;
  settle_looks();
  if (action == Action::write_note) {
    if (!notes.draft) write_note();
    return true;
  }
  if (!notes.shown) return false;
  if (action == Action::next_step) {
    if (*notes.shown + 1 < notes.tour.notes.size()) go_to_note(*notes.shown + 1);
    return true;
  }
  if (action == Action::previous_step) {
    if (*notes.shown > 0) go_to_note(*notes.shown - 1);
    return true;
  }
  return false;
}

void Viewer::write_note() {
  if (!state_.shown) return;
  NotesState& notes = state_.notes;
  if (notes.tour.notes.size() >= most_notes) {
    notice(fmt::format("A lesson has at most {} notes.", most_notes));
    return;
  }
  held_.clear();
  state_.fly.mouse_caught = false;
  settle_looks();
  Scene seen = state_.scene;
  if (transition_) seen.camera = transition_->goal();
  notes.draft = note_of(seen, state_.fly.on && state_.fly.cavity.has_value());
  notes.shown.reset();
}

void Viewer::save_notes() {
  NotesState& notes = state_.notes;
  if (notes.draft && notes_at_risk()) keep_draft(notes);
  if (notes.tour.notes.empty() || !state_.shown) return;
  try {
    if (notes.tour.title.empty()) notes.tour.title = state_.shown->title;
    const std::filesystem::path file = new_file(notes.tour.title, std::string(tour_ending));
    notes.tour.model.clear();
    std::error_code error;
    if (!file_shown_.empty()) notes.tour.model = std::filesystem::proximate(std::filesystem::absolute(file_shown_), std::filesystem::absolute(file).parent_path(), error).generic_string();
    const std::string text = to_json(notes.tour);
    if (text.size() > most_tour_bytes)
      throw UsageError(fmt::format("The notes are {} bytes long; a lesson has at most {}", text.size(), most_tour_bytes), "Make two lessons of them.");
    AtomicFile written(file);
    written.write(text);
    written.commit();
    notes.unsaved = false;
    notice(fmt::format("Saved {}. Drop it on the window, or odontoscope view it.", file.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

/// True: the request is done, or goes on as that of the tour's model.
bool Viewer::open_tour(LoadRequest& request) {
  if (!named_like_a_tour(request.file)) return false;
  failure_ = nullptr;
  TourNotes tour;
  try {
    tour = read_tour(request.file);
  } catch (const Error& error) {
    failure_ = std::current_exception();
    state_.trouble = error.what();
    return true;
  }
  const std::filesystem::path folder = std::filesystem::path(request.file).parent_path();
  const std::string model = tour.model.empty() ? "" : (folder / tour.model).lexically_normal().string();
  const bool there = state_.shown && (tour.model.empty() || (!file_shown_.empty() && std::filesystem::weakly_canonical(file_shown_) == std::filesystem::weakly_canonical(model)));
  if (there) {
    take_tour(std::move(tour));
    return true;
  }
  tour_after_load_ = std::move(tour);
  request.file = model;
  return false;
}

void Viewer::take_tour(TourNotes tour) {
  state_.notes = {};
  state_.notes.tour = std::move(tour);
  go_to_note(0);
}

void Viewer::go_to_note(std::size_t number) {
  NotesState& notes = state_.notes;
  if (number >= notes.tour.notes.size() || !state_.shown) return;
  notes.draft.reset();
  notes.shown = number;
  const TourNote note = notes.tour.notes[number];
  if (!note.inside) {
    show_note_outside(note);
    return;
  }
  const FlightSpaces* spaces = state_.shown->flight.get();
  const glm::dvec3 eye = note.camera.position;
  const auto fits = [&](const FlightSpace& space) { return space.walls.locate(eye) == Walls::Side::inside && space.walls.nearest(eye).distance >= spaces->rules.clearance; };
  const auto found = spaces ? std::find_if(spaces->cavities.begin(), spaces->cavities.end(), fits) : std::vector<FlightSpace>::const_iterator{};
  if (!spaces || found == spaces->cavities.end()) {
    notice("This note was taken inside another tooth: at its place there is no cavity here.", true);
    return;
  }
  if (!state_.fly.on) camera_before_dive_ = transition_ ? transition_->goal() : state_.scene.camera;
  const auto cavity = static_cast<std::size_t>(found - spaces->cavities.begin());
  darken_then([this, cavity, note] {
    const Camera& camera = note.camera;
    arrive(cavity, looking(camera.position, camera.target - camera.position, camera.up));
    state_.scene = of_model(note.scene_over(state_.scene, state_.scene), state_.shown->model);
    see_from_flight();
  });
}

/// The usual looks are the model's own, over the background that the person chose.
void Viewer::show_note_outside(const TourNote& note) {
  Scene usual = state_.shown->scene;
  usual.background = background_of(state_.settings.backdrop);
  const auto in_the_dark = [this, note, usual] {
    end_flight();
    leave_lab();
    state_.scene = of_model(note.scene_over(state_.scene, usual), state_.shown->model);
  };
  if (state_.fly.on || state_.settings.comfort.reduced_motion) {
    darken_then(in_the_dark);
    return;
  }
  if (!note.scene.empty()) leave_lab();   // its looks are its own
  const Scene goal = of_model(note.scene_over(state_.scene, usual), state_.shown->model);
  go_to(note.camera, lesson_seconds);
  look_transition_.emplace(state_.scene, goal);
}

void Viewer::settle_looks() {
  if (!look_transition_) return;
  const Camera camera = state_.scene.camera;
  state_.scene = look_transition_->goal();
  state_.scene.camera = camera;
  look_transition_.reset();
}

}  // namespace odontoscope
