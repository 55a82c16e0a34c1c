#include "engine/viewer/compare/compare_mode.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/viewer/compare/compare_panel.h"
#include "engine/viewer/compare/comparison_run.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double line_slack = 9;  // interface pixels

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

}  // namespace

bool CompareMode::perform(Action action) {
  if (!state_.shown) return false;
  switch (action) {
    case Action::toggle_comparison:
      if (compared_.on)
        leave();
      else
        enter();
      return true;
    case Action::toggle_faulty_edges:
      state_.scene.overlays.edges = !state_.scene.overlays.edges;
      return true;
    case Action::next_comparison_layout:
      if (compared_.on) compared_.layout = after(compared_.layout);
      return true;
    case Action::swap_methods:
      if (!compared_.on) return true;
      compared_.db_in_place = compared_.layout == ComparisonLayout::in_place && !compared_.db_in_place;
      compared_.layout = ComparisonLayout::in_place;
      return true;
    case Action::next_artefact:
      step_artefact(1);
      return true;
    case Action::previous_artefact:
      step_artefact(-1);
      return true;
    case Action::toggle_lesson:
      if (compared_.lesson)
        compared_.lesson.reset();
      else
        begin_lesson();
      return true;
    case Action::next_step:
      if (compared_.lesson && compared_.step + 1 < compared_.lesson->steps.size()) go_to_step(compared_.step + 1);
      return true;
    case Action::previous_step:
      if (compared_.lesson && compared_.step > 0) go_to_step(compared_.step - 1);
      return true;
    default:
      return false;
  }
}

void CompareMode::enter() {
  if (compared_.on) return;
  if (!comparison_possible(*state_.shown)) {
    notice("DB needs contours: open a contour stack, a volume or the sample molar.");
    return;
  }
  compared_.on = true;
  compared_.looks_before = state_.scene.looks;
  compared_.back_faces_before = state_.scene.back_faces;
  compared_.overlays_before = state_.scene.overlays;
  make_opaque(state_.scene);  // what one method hides, the other must hide as well
  if (!worker_) worker_ = worker_for(state_.shown);
}

void CompareMode::leave() {
  if (worker_) {
    worker_->leave();
    left_workers_.push_back(std::move(worker_));
  }
  if (compared_.on) {
    state_.scene.looks = compared_.looks_before;
    state_.scene.back_faces = compared_.back_faces_before;
    state_.scene.overlays = compared_.overlays_before;
  }
  ComparisonState left;  // the next time begins as this one ended
  left.layout = compared_.layout;
  left.db_in_place = compared_.db_in_place;
  left.split = compared_.split;
  left.wanted = compared_.wanted;
  compared_ = std::move(left);
  asked_.reset();
  edges_of_.reset();
  gpu_model_ = {};
  gpu_edges_ = {};
  artefact_when_made_ = false;
}

void CompareMode::update() {
  std::erase_if(left_workers_, [](const auto& worker) { return worker->gone(); });
  if (!compared_.on) return;
  if (asked_ != compared_.wanted) {
    asked_ = compared_.wanted;
    compared_.trouble.clear();
    worker_->want(compared_.wanted);
  }
  const DbWorker::Stage stage = worker_->stage();
  if (auto outcome = worker_->take()) {
    if (outcome->trouble)
      compared_.trouble = words_for(outcome->trouble);
    else
      take_result(std::move(outcome->result));
  }
  compared_.run = {worker_->working(), stage.name, stage.fraction};
  if (compared_.made) draw_edges();
}

void CompareMode::take_result(std::shared_ptr<const ComparisonResult> made) {
  compared_.made = std::move(made);
  put_artefact_away();
  gpu_model_ = upload(at_.gl, compared_.made->model);
  other_ = {&compared_.made->model, compared_.made->pickable.get(), &gpu_model_, &gpu_edges_, other_.version + 1};
  if (std::exchange(artefact_when_made_, false) && !compared_.made->artefacts.empty()) lead_to_artefact(0);
  if (at_.layout.panes.size() == 1) at_.frames_to_settle = 3;
}

void CompareMode::draw_edges() {
  if (edges_of_ == compared_.made && edges_near_ == compared_.artefact) return;
  const ComparisonResult& made = *compared_.made;
  gpu_edges_ =
      upload(at_.gl, Overlay{compared_.artefact ? edges_near(made, *compared_.artefact) : made.faulty_edges, {}});
  edges_of_ = compared_.made;
  edges_near_ = compared_.artefact;
  ++other_.version;
}

bool CompareMode::suspend() {
  if (!compared_.on) return false;
  leave();
  return true;
}

void CompareMode::loaded(const LoadRequest&) {
  if (std::exchange(lesson_after_load_, false)) begin_lesson();
}

ModeEffects CompareMode::effects() const {
  return {.names = !compared_.on, .first_hints = !compared_.on, .remember_looks = !compared_.on};
}

std::vector<ViewPane> CompareMode::panes(const Area& whole) const {
  if (!compared_.on || !compared_.made) return {};
  const Camera& camera = state_.scene.camera;
  switch (compared_.layout) {
    case ComparisonLayout::in_place:
      return {{whole, camera, compared_.db_in_place}};
    case ComparisonLayout::side_by_side: {
      const double half = std::floor(whole.width / 2);
      if (half < 1) break;
      return {{{whole.left, whole.top, half, whole.height}, camera},
              {{whole.left + half, whole.top, half, whole.height}, camera, true}};
    }
    case ComparisonLayout::split: {
      const double left = std::round(std::clamp(compared_.split, 0.0, 1.0) * whole.width);
      return {{whole, camera, false, Area{whole.left, whole.top, left, whole.height}},
              {whole, camera, true, Area{whole.left + left, whole.top, whole.width - left, whole.height}}};
    }
  }
  return {};
}

bool CompareMode::on_split_line(double x, double y) const {
  const std::vector<ViewPane>& panes = at_.layout.panes;
  return panes.size() == 2 && panes[1].seen && at_.layout.viewport.holds(x, y) && !at_.interface.covers(x, y) &&
         std::abs(x - panes[1].seen->left) < line_slack * at_.layout.scale;
}

std::optional<Drag> CompareMode::press(const Press& press) {
  if (press.button != MouseButton::left || !on_split_line(press.x, press.y)) return {};
  const auto move = [this](const DragMove& drag) {
    const Area& viewport = at_.layout.viewport;
    compared_.split = std::clamp((drag.x - viewport.left) / viewport.width, 0.02, 0.98);
  };
  return Drag{.move = move, .may_be_click = false};
}

bool CompareMode::hover(const Hover& hover) {
  if (on_split_line(hover.x, hover.y)) at_.pointing.pointer = Pointer::hand;
  return false;
}

bool CompareMode::put_away(PutAway what) {
  if (what != PutAway::step || (!compared_.lesson && !compared_.artefact)) return false;
  if (compared_.lesson)
    compared_.lesson.reset();
  else
    put_artefact_away();
  return true;
}

void CompareMode::draw(DrawLayer layer, const DrawnPane&) {
  if (layer == DrawLayer::windows && compared_.on)
    draw_comparison(compared_, state_, at_.layout.panes, at_.interface, at_.layout.viewport, at_.layout.scale);
}

std::vector<PanelSection> CompareMode::panel() {
  return {{compared_.on ? SectionPlace::compared : SectionPlace::comparison,
           [this] { comparison_section(compared_, state_, at_.interface); }}};
}

}  // namespace odontoscope
