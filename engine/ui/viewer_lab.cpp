// DB mode: DT and DB of the same contours beside each other. The work is done by a DbWorker; a frame only asks whether
// something is ready.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/ui/lab_panel.h"
#include "engine/ui/viewer.h"

namespace odontoscope {

namespace {

constexpr double line_slack = 9;  // interface pixels
/// Steps through a volume while the picture moves on a slow machine, over usual ones.
constexpr float moving_coarseness = 2;

ComparisonLayout after(ComparisonLayout layout) {
  switch (layout) {
    case ComparisonLayout::side_by_side:
      return ComparisonLayout::split;
    case ComparisonLayout::split:
      return ComparisonLayout::in_place;
    case ComparisonLayout::in_place:
      break;
  }
  return ComparisonLayout::side_by_side;
}

/// Of thousands, those that the artefact is made of.
std::vector<LineSet> edges_near(const ComparisonResult& made, std::size_t artefact) {
  constexpr double cells = 2.5;
  const glm::vec3 at(metres_per_mm * (made.artefacts[artefact].at - made.model.origin_mm));
  const auto reach = static_cast<float>(metres_per_mm * cells * made.spacing_mm);
  std::vector<LineSet> near;
  for (const LineSet& set : made.faulty_edges) {
    LineSet kept{set.kind, set.structure, {}};
    for (std::size_t i = 0; i + 1 < set.points.size(); i += 2)
      if (glm::distance(0.5f * (set.points[i] + set.points[i + 1]), at) < reach)
        kept.points.insert(kept.points.end(), {set.points[i], set.points[i + 1]});
    if (!kept.points.empty()) near.push_back(std::move(kept));
  }
  return near;
}

std::string words_of(const std::exception_ptr& trouble) {
  try {
    std::rethrow_exception(trouble);
  } catch (const std::bad_alloc&) {
    return "This machine has not enough memory for that. Choose a coarser grid.";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

bool Viewer::perform_in_lab(Action action) {
  ComparisonState& lab = state_.lab;
  switch (action) {
    case Action::toggle_lab:
      if (lab.on)
        leave_lab();
      else
        enter_lab();
      return true;
    case Action::toggle_faulty_edges:
      state_.scene.overlays.edges = !state_.scene.overlays.edges;
      return true;
    case Action::next_lab_layout:
      if (lab.on) lab.layout = after(lab.layout);
      return true;
    case Action::swap_methods:
      if (!lab.on) return true;
      lab.db_in_place = lab.layout == ComparisonLayout::in_place && !lab.db_in_place;
      lab.layout = ComparisonLayout::in_place;
      return true;
    case Action::next_artefact:
      step_artefact(1);
      return true;
    case Action::previous_artefact:
      step_artefact(-1);
      return true;
    case Action::toggle_lesson:
      if (lab.lesson)
        lab.lesson.reset();
      else
        begin_lesson();
      return true;
    case Action::next_step:
      if (lab.lesson && lab.step + 1 < lab.lesson->steps.size()) go_to_step(lab.step + 1);
      return true;
    case Action::previous_step:
      if (lab.lesson && lab.step > 0) go_to_step(lab.step - 1);
      return true;
    default:
      return false;
  }
}

void Viewer::enter_lab() {
  if (state_.lab.on) return;
  if (!lab_possible(state_)) {
    notice("DB needs contours: open a contour stack, a volume or the sample molar.");
    return;
  }
  ComparisonState& lab = state_.lab;
  lab.on = true;
  lab.looks_before = state_.scene.looks;
  lab.back_faces_before = state_.scene.back_faces;
  lab.overlays_before = state_.scene.overlays;
  for (Look& look : state_.scene.looks) look.opacity = 1;  // what one method hides, the other must hide as well
  state_.scene.back_faces = BackFaces::cull;
  if (!lab_worker_)
    lab_worker_ =
        std::make_unique<DbWorker>(std::shared_ptr<const ContourStack>(state_.shown, &state_.shown->overlays.contours));
}

void Viewer::leave_lab() {
  ComparisonState& lab = state_.lab;
  if (lab_worker_) {
    lab_worker_->leave();
    left_workers_.push_back(std::move(lab_worker_));
  }
  if (lab.on) {
    state_.scene.looks = lab.looks_before;
    state_.scene.back_faces = lab.back_faces_before;
    state_.scene.overlays = lab.overlays_before;
  }
  ComparisonState left;  // the next time begins as this one ended
  left.layout = lab.layout;
  left.db_in_place = lab.db_in_place;
  left.split = lab.split;
  left.wanted = lab.wanted;
  lab = std::move(left);
  lab_asked_.reset();
  lab_edges_of_.reset();
  lab_gpu_model_ = {};
  lab_gpu_overlay_ = {};
  artefact_when_made_ = false;
}

void Viewer::update_lab() {
  std::erase_if(left_workers_, [](const auto& worker) { return worker->gone(); });
  ComparisonState& lab = state_.lab;
  if (!lab.on) return;
  if (lab_asked_ != lab.wanted) {
    lab_asked_ = lab.wanted;
    lab.trouble.clear();
    lab_worker_->want(lab.wanted);
  }
  const DbWorker::Stage stage = lab_worker_->stage();
  lab.stage = stage.name;
  lab.fraction = stage.fraction;
  if (auto outcome = lab_worker_->take()) {
    if (outcome->trouble) {
      lab.trouble = words_of(outcome->trouble);
    } else {
      lab.made = std::move(outcome->result);
      put_artefact_away();
      lab_gpu_model_ = upload(*gl_, lab.made->model);
      if (std::exchange(artefact_when_made_, false) && !lab.made->artefacts.empty()) lead_to_artefact(0);
      if (panes_.size() == 1) frames_to_settle_ = 3;
    }
  }
  lab.working = lab_worker_->working();
  if (lab.made && (lab_edges_of_ != lab.made || lab_edges_near_ != lab.artefact)) {
    lab_gpu_overlay_ =
        upload(*gl_, Overlay{lab.artefact ? edges_near(*lab.made, *lab.artefact) : lab.made->faulty_edges, {}});
    lab_edges_of_ = lab.made;
    lab_edges_near_ = lab.artefact;
  }
}

void Viewer::lay_out_lab(const Area& whole) {
  const ComparisonState& lab = state_.lab;
  const Camera& camera = state_.scene.camera;
  if (!lab.on || !lab.made) {
    panes_ = {{whole, camera}};
    return;
  }
  switch (lab.layout) {
    case ComparisonLayout::in_place:
      panes_ = {{whole, camera, lab.db_in_place}};
      return;
    case ComparisonLayout::side_by_side: {
      const double half = std::floor(whole.width / 2);
      if (half < 1) break;
      panes_ = {{{whole.left, whole.top, half, whole.height}, camera},
                {{whole.left + half, whole.top, half, whole.height}, camera, true}};
      return;
    }
    case ComparisonLayout::split: {
      const double left = std::round(std::clamp(lab.split, 0.0, 1.0) * whole.width);
      panes_ = {{whole, camera, false, Area{whole.left, whole.top, left, whole.height}},
                {whole, camera, true, Area{whole.left + left, whole.top, whole.width - left, whole.height}}};
      return;
    }
  }
  panes_ = {{whole, camera}};
}

bool Viewer::on_split_line(double x, double y) const {
  return panes_.size() == 2 && panes_[1].seen && viewport_.holds(x, y) && !interface_.covers(x, y) &&
         std::abs(x - panes_[1].seen->left) < line_slack * scale_;
}

/// Into the kept picture. A pane of which only a part is seen is drawn whole and cut out, so that a pixel is the same
/// on either side of the line.
void Viewer::draw_pane(const ViewPane& pane, PixelSize size, int side) {
  const auto left = static_cast<int>(pane.area.left), top = static_cast<int>(pane.area.top);
  const PixelSize pane_size{static_cast<int>(pane.area.width), static_cast<int>(pane.area.height)};
  if (pane_size.width < 1 || pane_size.height < 1) return;
  const int bottom = size.height - top - pane_size.height;
  const bool partly = pane.seen.has_value();
  if (partly && !(other_half_.size() == size)) other_half_ = Framebuffer(*gl_, {size, {GL_RGBA8}});
  const Framebuffer& target = partly ? other_half_ : picture_;
  const Pane eye{odontoscope::view_of(pane.camera, model_of(pane), pane.area.aspect()),
                 {target.id(), left, bottom, pane_size}};
  Scene scene = state_.scene;
  // On a slow machine a flight's moving pictures do without it, as without fine samples.
  if (state_.fly.on && side < options_.side) scene.occlusion.on = false;
  GpuVolume* const grey = pane.db ? nullptr : volume();
  const bool moving = side < options_.side;
  if (grey) grey->set_coarseness(moving ? moving_coarseness : 1);
  const RenderOptions options{.side = side, .rays = moving ? RenderOptions::Rays::few : RenderOptions::Rays::as_usual};
  renderer_.draw(pane.db ? lab_gpu_model_ : gpu_model_, scene, {&eye, 1}, options,
                 pane.db ? (state_.scene.overlays.edges ? &lab_gpu_overlay_ : nullptr) : &gpu_overlay_, cap_values(),
                 grey);
  if (!partly) return;
  const int from = static_cast<int>(pane.seen->left), to = from + static_cast<int>(pane.seen->width);
  if (to <= from) return;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, other_half_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_.id());
  gl_->BlitFramebuffer(from, bottom, to, bottom + pane_size.height, from, bottom, to, bottom + pane_size.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Viewer::lead_to_artefact(std::size_t artefact) {
  ComparisonState& lab = state_.lab;
  lab.artefact = artefact;
  const ComparisonArtefact& broken = lab.made->artefacts[artefact];
  state_.scene.overlays.edges = true;
  // Enamel hides what is broken in dentine; DT's dentine has its cavity as a part of its own.
  const auto belongs = [&](const Look& look) {
    return look.structure == broken.structure ||
           std::any_of(state_.shown->model.parts.begin(), state_.shown->model.parts.end(), [&](const ModelPart& part) {
             return part.structure == look.structure && part.solid == broken.structure;
           });
  };
  for (Look& look : state_.scene.looks) look.visible = belongs(look);
  if (!lab.db_in_place) lab.db_in_place = true;
  go_to(camera_at(broken, lab.made->spacing_mm, state_.scene.camera, *lab.made->pickable, state_.scene));
}

void Viewer::put_artefact_away() {
  ComparisonState& lab = state_.lab;
  if (!lab.artefact) return;
  lab.artefact.reset();
  for (Look& look : state_.scene.looks) {
    const auto before = std::find_if(lab.looks_before.begin(), lab.looks_before.end(),
                                     [&](const Look& known) { return known.structure == look.structure; });
    look.visible = before == lab.looks_before.end() || before->visible;
  }
}

void Viewer::step_artefact(int by) {
  ComparisonState& lab = state_.lab;
  if (!lab.on || !lab.made) return;
  const auto count = static_cast<long>(lab.made->artefacts.size());
  if (count == 0) {
    notice("There is no artefact here: every edge has two triangles that agree.");
    return;
  }
  const long now = lab.artefact ? static_cast<long>(*lab.artefact) : by > 0 ? -1 : 0;
  lead_to_artefact(static_cast<std::size_t>((now + by + count) % count));
}

void Viewer::begin_lesson() {
  if (!sample_shown_) {  // its steps speak of the sample molar
    lesson_after_load_ = true;
    open({});
    return;
  }
  ArtefactLesson lesson = artefact_lesson();
  enter_lab();
  if (!state_.lab.on) return;
  state_.lab.lesson = std::move(lesson);
  go_to_step(0);
}

void Viewer::go_to_step(std::size_t number) {
  ComparisonState& lab = state_.lab;
  lab.step = number;
  const ArtefactLessonStep& step = lab.lesson->steps[number];
  lab.layout = step.layout;
  lab.db_in_place = step.shows_db;
  lab.split = 0.5;
  lab.artefact.reset();
  Scene usual = state_.shown->scene;
  for (Look& look : usual.looks) look.opacity = 1;
  usual.back_faces = BackFaces::cull;
  usual.background = state_.scene.background;
  constexpr double shrink = 0.85, lift = 0.14;  // the dialog covers the lower part of the view
  const double aspect = viewport_.aspect() / (step.layout == ComparisonLayout::side_by_side ? 2 : 1);
  usual.camera = fit(NamedView::three_quarter, state_.shown->model, aspect, state_.scene.camera.projection);
  usual.camera = zoom(usual.camera, shrink, usual.camera.target);
  usual.camera = pan(usual.camera, {0, 0}, {0, lift}, usual.camera.target);
  Scene scene = step.scene_over(usual);
  const Camera goal = std::exchange(scene.camera, state_.scene.camera);
  state_.scene = std::move(scene);
  const bool made = lab.made && lab.made->options == step.db;
  lab.wanted = step.db;
  go_to(goal);
  artefact_when_made_ = step.at_artefact && !made;
  if (step.at_artefact && made && !lab.made->artefacts.empty()) lead_to_artefact(0);
}

}  // namespace odontoscope
