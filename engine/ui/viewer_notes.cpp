// A teacher's notes: written, saved, opened, and played as a lesson.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/ui/viewer.h"
#include "recon/core/atomic_file.h"

namespace odontoscope {

/// What the panels asked for.
void Viewer::tend_notes() {
  NotesState& notes = state_.notes;
  if (std::exchange(notes.write, false)) write_note();
  if (std::exchange(notes.save, false)) save_notes();
  if (const auto wanted = std::exchange(notes.go_to, {})) go_to_note(*wanted);
}

bool Viewer::perform_on_notes(Action action) {
  NotesState& notes = state_.notes;
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
  Camera camera = transition_ ? transition_->goal() : state_.scene.camera;
  camera.near_mm = 0;   // follows from the flight, not from the note
  notes.draft = TourNote{"", "", camera, state_.fly.on && state_.fly.cavity.has_value()};
  notes.shown.reset();
}

void Viewer::save_notes() {
  NotesState& notes = state_.notes;
  if (notes.tour.notes.empty() || !state_.shown) return;
  try {
    if (notes.tour.title.empty()) notes.tour.title = state_.shown->title;
    const std::filesystem::path file = new_file(notes.tour.title, std::string(tour_ending));
    notes.tour.model.clear();
    std::error_code error;
    if (!file_shown_.empty()) notes.tour.model = std::filesystem::proximate(std::filesystem::absolute(file_shown_), std::filesystem::absolute(file).parent_path(), error).generic_string();
    AtomicFile written(file);
    written.write(to_json(notes.tour));
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
    if (!state_.fly.on) {
      go_to(note.camera);
      return;
    }
    darken_then([this, camera = note.camera] {
      end_flight();
      state_.scene.camera = camera;
    });
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
  darken_then([this, cavity, camera = note.camera] { arrive(cavity, looking(camera.position, camera.target - camera.position, camera.up)); });
}

}  // namespace odontoscope
