#include "engine/ui/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/gpu/graphics_error.h"
#include "engine/navigate/moves.h"
#include "engine/scene/fit_visible.h"
#include "engine/ui/actions.h"
#include "engine/ui/annotations.h"
#include "engine/ui/dialogs.h"
#include "engine/ui/fly_annotations.h"
#include "engine/ui/lab_panel.h"
#include "engine/ui/lesson_dialogs.h"
#include "engine/ui/names.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

/// A fine picture that takes longer than the first is drawn only once nothing moves, for so long; one that takes longer
/// than the last not at all, since nothing would answer meanwhile.
constexpr double slow_picture_seconds = 0.030, still_seconds = 0.15, too_slow_seconds = 0.8;
/// Samples beyond which a picture on the screen is not refined, for the memory that it takes.
constexpr double most_screen_samples = 10e6;

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

BackFaces after(BackFaces mode) {
  switch (mode) {
    case BackFaces::cull:
      return BackFaces::show;
    case BackFaces::show:
      return BackFaces::tint;
    case BackFaces::tint:
      break;
  }
  return BackFaces::cull;
}

}  // namespace

Viewer::Viewer(const Gl& gl, const ShaderLibrary& shaders, ViewerOptions options)
    : gl_(&gl),
      shaders_(shaders),
      options_(std::move(options)),
      interface_(options_.clipboard),
      interface_pass_(gl, shaders),
      renderer_(gl, shaders) {
  state_.settings = options_.settings;
  state_.languages = known_languages();
  if (std::none_of(state_.languages.begin(), state_.languages.end(),
                   [&](const Language& known) { return known == options_.language; }))
    state_.languages.push_back(options_.language);
  interface_.speak(options_.language);
}

Viewer::~Viewer() {
  for (std::future<std::string>& writing : writing_) writing.wait();
}

void Viewer::draw(const FrameInput& input, const Target& target) {
  scale_ = input.scale * state_.settings.text_scale;
  follow_language();
  lay_out(input);
  if (!events_.empty())
    frames_to_settle_ = 3;
  else if (frames_to_settle_ > 0)
    --frames_to_settle_;
  for (const Event& event : std::exchange(events_, {})) {
    interface_.feed(event);
    react(event);
  }
  for (const Action action : std::exchange(state_.pending_actions, {})) perform(action);
  if (const auto place = std::exchange(state_.look_at, {})) lead_to(*place);
  if (const auto degrees = std::exchange(state_.tube_asked, {})) swing_tube(*degrees);
  if (std::exchange(state_.film_asked, false)) show_film();
  if (const auto line = std::exchange(state_.fly.ride_asked, {})) begin_ride(*line);
  update_notes();
  if (auto request = std::exchange(state_.to_load, {})) open(std::move(*request));
  lay_out(input);
  take_finished_load();
  update_question();
  update_deviations();
  take_written();
  update_lab();
  advance(input.seconds);
  show_hovered();
  lay_out(input);
  draw_model(input, target);
  draw_inset(target);
  draw_interface(input, target);
}

void Viewer::follow_language() {
  const std::string& wanted = state_.settings.language;
  if (wanted.empty() || wanted == interface_.language().tag) return;
  const auto found = std::find_if(state_.languages.begin(), state_.languages.end(),
                                  [&](const Language& known) { return known.tag == wanted; });
  if (found != state_.languages.end()) interface_.speak(*found);
}

/// One view, or in DB mode two.
void Viewer::lay_out(const FrameInput& input) {
  const double left = state_.settings.panel ? std::min<double>(theme::panel_width * scale_, input.size.width / 2.0) : 0;
  const double whole = std::round(left);
  constexpr double least_share = 0.3;  // of the picture, above a lesson's words
  const double dock =
      state_.shown ? std::min(std::ceil(lesson_.dock_height), (1 - least_share) * input.size.height) : 0;
  viewport_ = {whole, 0, input.size.width - whole, input.size.height - std::ceil(dock)};
  lay_out_lab(viewport_);
}

void Viewer::advance(double seconds) {
  now_ += seconds;
  for (Notice& shown : state_.notices) shown.seconds_left -= seconds;
  std::erase_if(state_.notices, [](const Notice& shown) { return shown.seconds_left <= 0; });
  if (transition_) {
    state_.scene.camera = transition_->advance(seconds);
    if (transition_->over()) transition_.reset();
  }
  if (look_transition_) {
    state_.scene = look_transition_->advance(seconds, state_.scene.camera, state_.shown->model);
    if (look_transition_->over()) look_transition_.reset();
  }
  advance_flight(seconds);
  lesson_.advance(state_.notes, seconds);
  if (hints_.follow(state_)) notice("That is all it takes. ? lists the keys, G the lessons.", false, 10);
}

void Viewer::go_to(const Camera& camera, double seconds) { transition_.emplace(state_.scene.camera, camera, seconds); }

/// From where one looks now, a few millimetres of the model round the place.
void Viewer::lead_to(const glm::dvec3& place) {
  if (!state_.shown || state_.fly.on) return;
  constexpr double seen = 0.4;  // half the picture's height, over the radius of the model
  Camera goal = transition_ ? transition_->goal() : state_.scene.camera;
  goal.position += place - goal.target;
  goal.target = place;
  const double half = half_height_at(goal, depth_of(goal, place)), wanted = seen * state_.shown->model.radius_mm;
  go_to(within_reach(zoom(goal, half / wanted, place), state_.shown->model));
  state_.looked_at = place;
}

void Viewer::perform(Action action) {
  ViewerState& state = state_;
  switch (action) {
    case Action::toggle_panel:
      state.settings.panel = !state.settings.panel;
      return;
    case Action::toggle_help:
      state.help = !state.help;
      return;
    case Action::open_file:
      state.file_asked_for = "";
      state.folder = list_folder(state.settings.recent.empty()
                                     ? std::filesystem::path()
                                     : std::filesystem::path(state.settings.recent.front()).parent_path());
      if (!state.folder.trouble.empty()) state.folder = list_folder({});
      return;
    case Action::escape:
      escape();
      return;
    default:
      break;
  }
  if (!state.shown && action == Action::toggle_lessons) lesson_.toggle_menu();
  if (!state.shown && action == Action::enter_pulp)
    notice(job_ ? "The model is still being made." : "Open a model first.");
  if (!state.shown || perform_on_notes(action) || perform_in_flight(action) || perform_in_lab(action)) return;
  const Camera& goal = transition_ ? transition_->goal() : state.scene.camera;
  const double aspect = panes_.front().area.aspect();
  if (const auto view = view_of(action))
    return go_to(fit_without(hidden_in(state.scene), *view, state.shown->model, aspect, goal.projection));
  switch (action) {
    case Action::fit:
      go_to(fit_without(hidden_in(state.scene), goal, state.shown->model, aspect));
      break;
    case Action::toggle_projection: {
      const bool parallel = goal.projection == Camera::Projection::parallel;
      transition_.reset();
      state.scene.camera =
          with_projection(goal, parallel ? Camera::Projection::perspective : Camera::Projection::parallel);
      state.settings.projection = state.scene.camera.projection;
      break;
    }
    case Action::next_back_faces:
      state.scene.back_faces = after(state.scene.back_faces);
      break;
    case Action::toggle_names:
      state.settings.names = !state.settings.names;
      break;
    case Action::toggle_wire:
      state.scene.wire = !state.scene.wire;
      break;
    case Action::toggle_section:
      toggle_section();
      break;
    case Action::flip_section:
      if (state.scene.section) state.scene.section->normal = -state.scene.section->normal;
      break;
    case Action::measure_distance:
      choose(Tool::distance);
      break;
    case Action::measure_thickness:
      choose(Tool::thickness);
      break;
    case Action::enter_here:
      enter_here();
      break;
    case Action::take_picture:
      take_picture();
      break;
    case Action::save_scene:
      save_scene();
      break;
    default:
      break;
  }
}

/// The tool, or looking if it was already that.
void Viewer::choose(Tool tool) {
  state_.tool = state_.tool == tool ? Tool::look : tool;
  state_.measured = {};
}

void Viewer::toggle_section() {
  if (state_.scene.section) {
    state_.section_put_away = std::exchange(state_.scene.section, std::nullopt);
    return;
  }
  if (state_.section_put_away) {
    state_.scene.section = state_.section_put_away;
    return;
  }
  // The half towards the eye goes: one sees into the other.
  const AnatomicalFrame tooth;
  const glm::dvec3 eye = axes_of(state_.scene.camera).towards_eye;
  glm::dvec3 normal = tooth.buccal;
  for (const glm::dvec3& side : {-tooth.buccal, tooth.mesial, -tooth.mesial})
    if (glm::dot(side, eye) > glm::dot(normal, eye)) normal = side;
  state_.scene.section = Section{state_.shown->model.bounds_mm.centre(), normal};
}

void Viewer::escape() {
  if (job_)
    job_->cancel();
  else if (!state_.trouble.empty())
    state_.trouble.clear();
  else if (state_.notes.leaving)
    state_.notes.leaving->answer = LeavingNotes::Answer::stay;
  else if (state_.question)
    state_.question.reset();
  else if (state_.file_asked_for)
    state_.file_asked_for.reset();
  else if (state_.help)
    state_.help = false;
  else if (lesson_.menu())
    lesson_.close_menu();
  else if (state_.notes.placing != NotesState::Placing::none)
    state_.notes.placing = NotesState::Placing::none;
  else if (state_.notes.draft)
    drop_draft(state_.notes);
  else if (state_.notes.shown)
    state_.notes.shown.reset();
  else if (state_.fly.on)
    leave_flight();
  else if (state_.tool != Tool::look)
    state_.tool = Tool::look;
  else if (state_.name_told)
    state_.name_told.reset();
  else if (state_.canal)
    state_.canal.reset();
  else if (state_.lab.lesson)
    state_.lab.lesson.reset();
  else if (state_.lab.artefact)
    put_artefact_away();
  else if (state_.looked_at)
    state_.looked_at.reset();
  else
    state_.measured = {};
}

bool Viewer::dialog_open() const {
  return !state_.trouble.empty() || state_.notes.leaving || state_.question || state_.file_asked_for || state_.help ||
         lesson_.menu();
}

bool Viewer::pins_shown() const {
  const NotesState& notes = state_.notes;
  if (notes.draft) return !notes.draft->marks.empty();
  return notes.shown && *notes.shown < notes.lesson.notes.size() && !notes.lesson.notes[*notes.shown].marks.empty();
}

void Viewer::notice(std::string words, bool bad, double seconds) {
  constexpr std::size_t most = 3;
  std::erase_if(state_.notices, [&](const Notice& shown) { return shown.words == words; });  // said again, not twice
  state_.notices.push_back({std::move(words), bad, seconds});
  if (state_.notices.size() > most) state_.notices.erase(state_.notices.begin());
}

void Viewer::make_overlays() {
  if (!state_.shown || state_.scene.overlays == overlays_made_) return;
  gpu_overlay_ = upload(*gl_, make_overlay(state_.shown->overlays, state_.scene.overlays, state_.shown->model));
  overlays_made_ = state_.scene.overlays;
}

bool Viewer::upload_values() {
  if (gpu_values_) return true;
  try {
    gpu_values_ = upload(*gl_, *state_.shown->values, gpu_model_);
    return true;
  } catch (const GraphicsError& error) {
    state_.scene.cap.shows = CapLook::Shows::material;
    state_.scene.volume.shows = VolumeLook::Shows::surfaces;
    state_.trouble = error.what();
    return false;
  }
}

const GpuValueGrid* Viewer::cap_values() {
  const bool shown = state_.scene.cap.shows == CapLook::Shows::ct && state_.scene.section && state_.shown->values;
  return shown && upload_values() ? &*gpu_values_ : nullptr;
}

GpuVolume* Viewer::volume() {
  if (!state_.scene.volume.shows_volume() || !state_.shown->values || !upload_values()) return nullptr;
  if (!gpu_volume_) gpu_volume_.emplace(*gl_, *state_.shown->values, gpu_values_->field());
  return &*gpu_volume_;
}

void Viewer::draw_model(const FrameInput& input, const Target& target) {
  if (!(picture_.size() == input.size)) {
    picture_ = Framebuffer(*gl_, {input.size, {GL_RGBA8}});
    drawn_ = {};
  }
  DrawnModel wanted{state_.shown, state_.scene, panes_, state_.lab.made, state_.lab.artefact, input.size, drawn_.side};
  const bool changed = wanted != drawn_;
  if (changed) still_since_ = now_;
  const bool too_large =
      static_cast<double>(input.size.width) * input.size.height * options_.side * options_.side > most_screen_samples;
  const bool too_slow = options_.coarse_when_slow && fine_picture_seconds_ > too_slow_seconds;
  const bool wait =
      options_.coarse_when_slow && fine_picture_seconds_ > slow_picture_seconds && now_ - still_since_ < still_seconds;
  wanted.side = changed && (too_large || too_slow || wait) ? 1
                : too_large || too_slow || wait            ? drawn_.side
                                                           : options_.side;
  if (wanted != drawn_) {
    if (!state_.shown) {
      const GLfloat ground[4] = {0.085f, 0.1f, 0.118f, 1};
      picture_.bind();
      gl_->ClearBufferfv(GL_COLOR, 0, ground);
    } else {
      const double start = clock_seconds();
      make_overlays();
      for (const ViewPane& pane : panes_) draw_pane(pane, input.size, wanted.side);
      gl_->Finish();
      const double finer = static_cast<double>(options_.side) / wanted.side;
      fine_picture_seconds_ = 0.5 * fine_picture_seconds_ + 0.5 * finer * finer * (clock_seconds() - start);
    }
    drawn_ = std::move(wanted);
  }
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  gl_->BlitFramebuffer(0, 0, input.size.width, input.size.height, target.left, target.bottom,
                       target.left + input.size.width, target.bottom + input.size.height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
}

void Viewer::draw_interface(const FrameInput& input, const Target& target) {
  FrameInput scaled = input;
  scaled.scale = scale_;
  interface_.begin(scaled);
  const Area& viewport = viewport_;
  if (state_.shown) {
    if (state_.fly.on) draw_flight(state_, panes_.front(), interface_, scale_);
    draw_fade(state_, viewport);
    for (const ViewPane& pane : panes_) {
      const bool first = &pane == &panes_.front(),
                 last = &pane == &panes_.back();                              // cameras are linked: one of each will do
      if (first && !state_.fly.on) draw_scale_bar(pane, interface_, scale_);  // in a canal, nothing lies at one depth
      if (names_shown() && first) draw_names(state_, pane, interface_, scale_);
      if (!state_.fly.on && !pane.db && (!pane.seen || first)) draw_canal(pane, state_, interface_, scale_);
      if (!pane.seen || first) draw_measured(pane, state_, interface_, scale_);
      if (first && !pane.db) draw_pins(state_, pane, interface_, scale_);
      if (first && (lesson_.wants_click(state_.notes) || state_.notes.placing != NotesState::Placing::none))
        draw_cross(pane, scale_);
      if (state_.looked_at) draw_place(pane, *state_.looked_at, scale_);
      if (last) draw_readout(pane, state_, interface_, scale_);
      if (last) draw_compass(pane, interface_, scale_, hovered_compass_, state_.fly.on);
      if (pane.seen && !first) continue;  // over the same place as the other half
      if (handle_shown())
        draw_section_handle(pane, *state_.scene.section, scale_,
                            drag_ && drag_->what == Drag::What::section ? drag_->grip : hovered_grip_);
    }
  }
  const double height = static_cast<double>(input.size.height), dock_before = lesson_.dock_height;
  if (state_.settings.panel) draw_panel(state_, interface_, {0, 0, viewport.left, height});
  if (state_.shown) draw_lesson_dock(state_, lesson_, interface_, {viewport.left, 0, viewport.width, height}, scale_);
  if (lesson_.dock_height != dock_before) frames_to_settle_ = 3;
  hints_.draw(state_, interface_, viewport, scale_);
  if (state_.lab.on) draw_lab(state_, panes_, interface_, viewport, scale_);
  draw_cards(state_, job_.get(), interface_, viewport);
  if (!job_) draw_lesson_menu(state_, lesson_, interface_, viewport);
  const ImDrawData* drawn = interface_.end();
  if (const int by = std::exchange(tabs_, 0)) interface_.step(by, !dialog_open() && !state_.notes.draft);
  const VolumeQuestion* asked = state_.question ? &*state_.question : nullptr;
  interface_pass_.draw(interface_, *drawn, target, asked ? &asked->drawn.picture : nullptr);
  state_.settings.back_faces = state_.shown ? state_.scene.back_faces : state_.settings.back_faces;
}

double Viewer::wait_timeout() const {
  if (flight_moves() || transition_ || look_transition_ || frames_to_settle_ > 0 || !state_.pending_actions.empty() ||
      state_.to_load || state_.cancel_loading || !events_.empty())
    return 0;
  constexpr double loading = 1.0 / 30, refining = 0.05, idle = 0.5;
  if (job_ || preview_job_ || deviation_job_ || !writing_.empty() || state_.lab.working) return loading;
  if (state_.shown && drawn_.side < options_.side && now_ - still_since_ < 1) return refining;
  return idle;
}

std::string Viewer::title() const {
  if (!state_.shown) return "Odontoscope";
  const LoadedModel& shown = *state_.shown;
  return fmt::format("{}{}{} \xE2\x80\x94 Odontoscope", interface_.say(shown.title), shown.tooth.empty() ? "" : ", ",
                     interface_.say(shown.tooth));
}

}  // namespace odontoscope
