// A teacher's notes: written, saved, opened, and played as a lesson.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/ui/lesson_words.h"
#include "engine/ui/note_editor.h"
#include "engine/ui/viewer.h"
#include "recon/core/atomic_file.h"
#include "recon/core/error.h"

namespace odontoscope {

namespace {

/// Without looks of structures that this model does not have.
Scene of_model(Scene scene, const Model& model) {
  std::erase_if(scene.looks, [&](const Look& look) {
    return std::none_of(model.parts.begin(), model.parts.end(),
                        [&](const ModelPart& part) { return part.structure == look.structure; });
  });
  return scene;
}

}  // namespace

void keep_draft(NotesState& notes) {
  LessonNote note = std::move(*std::exchange(notes.draft, std::nullopt));
  const std::optional<std::size_t> place = std::exchange(notes.draft_of, std::nullopt);
  notes.placing = NotesState::Placing::none;
  if (note.title.empty()) note.title = fmt::format("Note {}", place.value_or(notes.lesson.notes.size()) + 1);
  if (place && *place < notes.lesson.notes.size())
    notes.lesson.notes[*place] = std::move(note);
  else
    notes.lesson.notes.push_back(std::move(note));
  notes.unsaved = true;
}

void drop_draft(NotesState& notes) {
  notes.draft.reset();
  notes.draft_of.reset();
  notes.placing = NotesState::Placing::none;
}

void edit_note(NotesState& notes, std::size_t number) {
  notes.draft = notes.lesson.notes[number];
  notes.draft_of = number;
  notes.fresh_draft = true;
}

void move_note(NotesState& notes, std::size_t number, int by) {
  const std::size_t to = number + static_cast<std::size_t>(by);  // below 0 is beyond the last
  if (number >= notes.lesson.notes.size() || to >= notes.lesson.notes.size()) return;
  std::swap(notes.lesson.notes[number], notes.lesson.notes[to]);
  if (notes.shown == number) notes.shown = to;
  notes.unsaved = true;
}

void remove_note(NotesState& notes, std::size_t number) {
  if (number >= notes.lesson.notes.size()) return;
  notes.removed.emplace_back(number, std::move(notes.lesson.notes[number]));
  notes.lesson.notes.erase(notes.lesson.notes.begin() + static_cast<std::ptrdiff_t>(number));
  notes.shown.reset();
  notes.unsaved = !notes.lesson.notes.empty();
}

void bring_back_note(NotesState& notes) {
  auto [number, note] = std::move(notes.removed.back());
  notes.removed.pop_back();
  number = std::min(number, notes.lesson.notes.size());
  notes.lesson.notes.insert(notes.lesson.notes.begin() + static_cast<std::ptrdiff_t>(number), std::move(note));
  notes.shown.reset();
  notes.unsaved = true;
}

/// What the panels asked for.
void Viewer::update_notes() {
  NotesState& notes = state_.notes;
  if (std::exchange(notes.write, false)) write_note();
  if (std::exchange(notes.retake, false) && notes.draft) {
    const LessonNote now = view_now();
    notes.draft->camera = now.camera;
    notes.draft->scene = now.scene;
    notes.draft->inside = now.inside;
  }
  if (std::exchange(notes.save, false)) save_notes();
  if (std::exchange(lesson_.save_marks, false)) save_marks();
  if (std::exchange(lesson_.pick_middle, false)) point_at_middle();
  if (const auto wanted = std::exchange(notes.go_to, {})) go_to_note(*wanted);
  answer_about_notes();
}

bool Viewer::notes_at_risk() const {
  const NotesState& notes = state_.notes;
  if (notes.unsaved || !notes.draft) return notes.unsaved;
  const LessonNote& draft = *notes.draft;
  if (notes.draft_of)
    return *notes.draft_of >= notes.lesson.notes.size() || !(draft == notes.lesson.notes[*notes.draft_of]);
  return !draft.title.empty() || !draft.text.empty() || !draft.marks.empty() || draft.question;
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
  if (leaving.answer == Answer::stay ||
      (leaving.answer == Answer::save && notes_at_risk())) {  // or it could not be written
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
  if (action == Action::toggle_lessons) {
    lesson_.toggle_menu();
    return true;
  }
  if (!notes.shown) return false;
  if (action == Action::next_step && lesson_.step(1, notes)) return true;
  if (action == Action::previous_step && lesson_.step(-1, notes)) return true;
  if (action == Action::next_step) {
    if (*notes.shown + 1 < notes.lesson.notes.size()) go_to_note(*notes.shown + 1);
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
  if (notes.lesson.notes.size() >= most_notes) {
    notice(fmt::format("A lesson has at most {} notes.", most_notes));
    return;
  }
  notes.draft = view_now();
  notes.draft_of.reset();
  notes.fresh_draft = true;
  notes.shown.reset();
}

/// The view as it is, or is on its way to.
LessonNote Viewer::view_now() {
  held_.clear();
  state_.fly.mouse_caught = false;
  settle_looks();
  Scene seen = state_.scene;
  if (transition_) seen.camera = transition_->goal();
  return note_of(seen, state_.fly.on && state_.fly.cavity.has_value());
}

/// Two files, written both or none.
void Viewer::save_marks() {
  const auto& quiz = lesson_.quiz();
  if (!quiz) return;
  try {
    const std::string stem = (quiz->title.empty() ? "Quiz" : quiz->title) + "-marks";
    std::filesystem::path csv, json;
    std::error_code error;
    do {
      csv = new_file(stem, ".csv");
      json = std::filesystem::path(csv).replace_extension(".json");
    } while (std::filesystem::exists(json, error));
    AtomicFile first(csv), second(json);
    first.write(marks_csv(*quiz));
    second.write(marks_json(*quiz));
    first.commit();
    second.commit();
    notice(fmt::format("Saved {} and the same as .json.", csv.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

/// What a click here means for the lesson: a pin or an answer for the draft, or an answer to the question. true: it was
/// for the lesson.
bool Viewer::point_for_lesson(const ViewPane& pane, double x, double y) {
  NotesState& notes = state_.notes;
  const bool placing = notes.draft && notes.placing != NotesState::Placing::none;
  if (!placing && !lesson_.wants_click(notes)) return false;
  const auto clicked = pointed_at(pane, x, y);
  if (placing && notes.placing == NotesState::Placing::pin) {
    if (const auto hit = hit_at(pane, x, y)) {
      notes.draft->marks.push_back({hit->point_mm, ""});
      notes.placing = NotesState::Placing::none;
      return true;
    }
  } else if (clicked && placing) {
    if (notes.draft->question) {
      notes.draft->question->structure = clicked->structure;
      notes.draft->question->part = clicked->part;
    }
    notes.placing = NotesState::Placing::none;
    return true;
  } else if (clicked) {
    lesson_.answer(notes, *clicked);
    return true;
  }
  notice("There is nothing at this place: point at the tooth.");
  return true;
}

void Viewer::point_at_middle() {
  if (panes_.empty() || !state_.shown) return;
  const ViewPane& pane = panes_.front();
  point_for_lesson(pane, pane.area.left + pane.area.width / 2, pane.area.top + pane.area.height / 2);
}

void Viewer::save_notes() {
  NotesState& notes = state_.notes;
  if (notes.draft && notes_at_risk()) {
    if (const std::string fault = fault_of_draft(*notes.draft); !fault.empty()) {
      notice(fmt::format("The note that is being written cannot be kept yet. {}", fault), true);
      return;
    }
    keep_draft(notes);
  }
  if (notes.lesson.notes.empty() || !state_.shown) return;
  try {
    if (notes.lesson.title.empty()) notes.lesson.title = state_.shown->title;
    const std::filesystem::path file = new_file(notes.lesson.title, std::string(tour_ending));
    notes.lesson.model.clear();
    std::error_code error;
    if (!file_shown_.empty())
      notes.lesson.model = std::filesystem::proximate(std::filesystem::absolute(file_shown_),
                                                      std::filesystem::absolute(file).parent_path(), error)
                               .generic_string();
    const std::string text = to_json(notes.lesson);
    if (text.size() > most_lesson_bytes)
      throw UsageError(
          fmt::format("The notes are {} bytes long; a lesson has at most {}", text.size(), most_lesson_bytes),
          "Make two lessons of them.");
    AtomicFile written(file);
    written.write(text);
    written.commit();
    notes.unsaved = false;
    notice(fmt::format("Saved {}. Drop it on the window, or odontoscope view it.", file.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

/// True: the request is done, or goes on as that of the lesson's model.
bool Viewer::open_lesson(LoadRequest& request) {
  if (!request.lesson && !named_like_a_tour(request.file)) return false;
  failure_ = nullptr;
  Lesson lesson;
  try {
    lesson = request.lesson ? translated(built_in_lesson(*request.lesson), interface_.language())
                            : read_lesson(request.file);
  } catch (const Error& error) {
    failure_ = std::current_exception();
    state_.trouble = error.what();
    return true;
  }
  if (!request.lesson) remember_file(state_.settings, request.file);
  const std::filesystem::path folder = std::filesystem::path(request.file).parent_path();
  const std::string model = lesson.model.empty() ? "" : (folder / lesson.model).lexically_normal().string();
  const bool there = state_.shown && (!request.lesson || sample_shown_) &&
                     (lesson.model.empty() || (!file_shown_.empty() && std::filesystem::weakly_canonical(file_shown_) ==
                                                                           std::filesystem::weakly_canonical(model)));
  if (there) {
    take_lesson(std::move(lesson));
    return true;
  }
  lesson_to_load_ = std::move(lesson);
  request.file = model;
  request.lesson.reset();
  return false;
}

void Viewer::take_lesson(Lesson lesson) {
  state_.notes = {};
  state_.notes.lesson = std::move(lesson);
  lesson_.leave();
  go_to_note(0);
}

void Viewer::go_to_note(std::size_t number) {
  NotesState& notes = state_.notes;
  if (number >= notes.lesson.notes.size() || !state_.shown) return;
  drop_draft(notes);
  notes.shown = number;
  state_.canal.reset();
  state_.name_told.reset();
  state_.tool = Tool::look;
  lesson_.enter(notes);
  const LessonNote note = notes.lesson.notes[number];
  if (!note.tour.empty() && ride_for_note(note)) return;
  if (!note.inside) {
    show_note_outside(note);
    return;
  }
  const FlightSpaces* spaces = state_.shown->flight.get();
  const glm::dvec3 eye = note.camera.position;
  const auto fits = [&](const FlightSpace& space) {
    return space.walls.locate(eye) == Walls::Side::inside &&
           space.walls.nearest(eye).distance >= spaces->rules.clearance;
  };
  const auto found = spaces ? std::find_if(spaces->cavities.begin(), spaces->cavities.end(), fits)
                            : std::vector<FlightSpace>::const_iterator{};
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

/// Down the canal that the note names; false: there is none of that name, or it is not to be ridden.
bool Viewer::ride_for_note(const LessonNote& note) {
  if (!flight_possible() || state_.settings.comfort.reduced_motion) return false;
  const auto& cavities = state_.shown->flight->cavities;
  for (std::size_t cavity = 0; cavity < cavities.size(); ++cavity) {
    const auto lines = rideable(cavities[cavity].lines);
    for (std::size_t line = 0; line < lines.size(); ++line)
      if (lines[line]->name == note.tour) {
        if (track_of(*lines[line], state_.shown->flight->rules.clearance).points.empty()) return false;
        ride_canal(cavity, line);
        return true;
      }
  }
  notice(fmt::format("This model has no canal called {}.", note.tour), true);
  return false;
}

/// The usual looks are the model's own, over the background that the person chose.
void Viewer::show_note_outside(const LessonNote& note) {
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
  if (!note.scene.empty()) leave_lab();  // its looks are its own
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
