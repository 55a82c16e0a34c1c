// Where the comparison leads: from artefact to artefact, and through the lesson about them.

#include <algorithm>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/viewer/compare/compare_mode.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

void CompareMode::lead_to_artefact(std::size_t artefact) {
  compared_.artefact = artefact;
  const ComparisonArtefact& broken = compared_.made->artefacts[artefact];
  state_.scene.overlays.edges = true;
  // Enamel hides what is broken in dentine; DT's dentine has its cavity as a part of its own.
  const auto belongs = [&](const Look& look) {
    return look.structure == broken.structure ||
           std::any_of(state_.shown->model.parts.begin(), state_.shown->model.parts.end(), [&](const ModelPart& part) {
             return part.structure == look.structure && part.solid == broken.structure;
           });
  };
  for (Look& look : state_.scene.looks) look.visible = belongs(look);
  if (!compared_.db_in_place) compared_.db_in_place = true;
  at_.go_to(
      camera_at(broken, compared_.made->spacing_mm, state_.scene.camera, *compared_.made->pickable, state_.scene));
}

void CompareMode::put_artefact_away() {
  if (!compared_.artefact) return;
  compared_.artefact.reset();
  for (Look& look : state_.scene.looks) {
    const auto before = std::find_if(compared_.looks_before.begin(), compared_.looks_before.end(),
                                     [&](const Look& known) { return known.structure == look.structure; });
    look.visible = before == compared_.looks_before.end() || before->visible;
  }
}

void CompareMode::step_artefact(int by) {
  if (!compared_.on || !compared_.made) return;
  const auto count = static_cast<long>(compared_.made->artefacts.size());
  if (count == 0) {
    notice("There is no artefact here: every edge has two triangles that agree.");
    return;
  }
  const long now = compared_.artefact ? static_cast<long>(*compared_.artefact) : by > 0 ? -1 : 0;
  lead_to_artefact(static_cast<std::size_t>((now + by + count) % count));
}

void CompareMode::begin_lesson() {
  if (!state_.origin.sample) {  // its steps speak of the sample molar
    lesson_after_load_ = true;
    at_.open({});
    return;
  }
  ArtefactLesson lesson = artefact_lesson();
  enter();
  if (!compared_.on) return;
  compared_.lesson = std::move(lesson);
  go_to_step(0);
}

void CompareMode::go_to_step(std::size_t number) {
  compared_.step = number;
  const ArtefactLessonStep& step = compared_.lesson->steps[number];
  compared_.layout = step.layout;
  compared_.db_in_place = step.shows_db;
  compared_.split = 0.5;
  compared_.artefact.reset();
  Scene usual = state_.shown->scene;
  make_opaque(usual);
  usual.background = state_.scene.background;
  constexpr double shrink = 0.85, lift = 0.14;  // the dialog covers the lower part of the view
  const double aspect = at_.layout.viewport.aspect() / (step.layout == ComparisonLayout::side_by_side ? 2 : 1);
  usual.camera = fit(NamedView::three_quarter, state_.shown->model, aspect, state_.scene.camera.projection);
  usual.camera = zoom(usual.camera, shrink, usual.camera.target);
  usual.camera = pan(usual.camera, {0, 0}, {0, lift}, usual.camera.target);
  Scene scene = step.scene_over(usual);
  const Camera goal = std::exchange(scene.camera, state_.scene.camera);
  state_.scene = std::move(scene);
  const bool made = compared_.made && compared_.made->options == step.db;
  compared_.wanted = step.db;
  at_.go_to(goal);
  artefact_when_made_ = step.at_artefact && !made;
  if (step.at_artefact && made && !compared_.made->artefacts.empty()) lead_to_artefact(0);
}

}  // namespace odontoscope
