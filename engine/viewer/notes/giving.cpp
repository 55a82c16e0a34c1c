// A lesson that is given: how one gets from note to note.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/viewer/compare/compare_mode.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/measure/measure_mode.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/workspace.h"

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

void NotesMode::go_to_note(std::size_t number) {
  if (number >= notes_.lesson.notes.size() || !state_.shown) return;
  drop_draft(notes_);
  notes_.shown = number;
  at_.modes.get<NamesMode>().forget();
  at_.modes.get<MeasureMode>().lay_down_tool();
  lesson_.enter(notes_);
  const LessonNote note = notes_.lesson.notes[number];
  if (note.tour.empty() || !ride_for_note(note)) show_view_of(note);
}

void NotesMode::show_view_of(const LessonNote& note) {
  if (note.inside)
    show_inside(note);
  else
    show_outside(note);
}

void NotesMode::show_inside(const LessonNote& note) {
  const FlightSpaces* spaces = state_.shown->flight.get();
  const glm::dvec3 eye = note.camera.position;
  const auto fits = [&](const FlightSpace& space) {
    return space.walls.locate(eye) == Walls::Side::inside &&
           space.walls.nearest(eye).distance >= spaces->rules.clearance;
  };
  const auto found = spaces ? std::find_if(spaces->cavities.begin(), spaces->cavities.end(), fits)
                            : std::vector<FlightSpace>::const_iterator{};
  if (!spaces || found == spaces->cavities.end()) {
    notice("This note was taken inside another tooth: at its place there is no cavity here.", NoticeKind::bad);
    return;
  }
  at_.modes.get<FlyMode>().remember_view();
  const auto cavity = static_cast<std::size_t>(found - spaces->cavities.begin());
  at_.fade.darken_then([this, cavity, note] {
    const Camera& camera = note.camera;
    FlyMode& fly = at_.modes.get<FlyMode>();
    fly.arrive(cavity, looking(camera.position, camera.target - camera.position, camera.up));
    state_.scene = of_model(note.scene_over(state_.scene, state_.scene), state_.shown->model);
    fly.see_as(camera.field_of_view_deg);
  });
}

/// Down the canal that the note names; false: there is none of that name, or it is not to be ridden.
bool NotesMode::ride_for_note(const LessonNote& note) {
  FlyMode& fly = at_.modes.get<FlyMode>();
  if (!fly.possible() || state_.settings.comfort.reduced_motion) return false;
  const auto& cavities = state_.shown->flight->cavities;
  for (std::size_t cavity = 0; cavity < cavities.size(); ++cavity) {
    const auto lines = rideable(cavities[cavity].lines);
    for (std::size_t line = 0; line < lines.size(); ++line)
      if (lines[line]->name == note.tour) {
        if (track_of(*lines[line], state_.shown->flight->rules.clearance).points.empty()) return false;
        fly.ride_canal(cavity, line);
        return true;
      }
  }
  notice(fmt::format("This model has no canal called {}.", note.tour), NoticeKind::bad);
  return false;
}

/// The usual looks are the model's own, over the background that the person chose.
void NotesMode::show_outside(const LessonNote& note) {
  Scene usual = state_.shown->scene;
  usual.background = background_of(state_.settings.backdrop);
  const auto in_the_dark = [this, note, usual] {
    at_.modes.get<FlyMode>().leave();
    at_.modes.get<CompareMode>().leave();
    state_.scene = of_model(note.scene_over(state_.scene, usual), state_.shown->model);
  };
  if (!at_.modes.effects().from_outside || state_.settings.comfort.reduced_motion) {
    at_.fade.darken_then(in_the_dark);
    return;
  }
  if (!note.scene.empty()) at_.modes.get<CompareMode>().leave();  // its looks are its own
  const Scene goal = of_model(note.scene_over(state_.scene, usual), state_.shown->model);
  at_.go_to(note.camera, lesson_seconds);
  at_.motion.looks.emplace(state_.scene, goal);
}

}  // namespace odontoscope
