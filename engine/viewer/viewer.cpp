#include "engine/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/ui/theme.h"
#include "engine/viewer/look/annotations.h"

namespace odontoscope {

Viewer::Viewer(const Gl& gl, const ShaderLibrary& shaders, ViewerOptions options)
    : at_(gl, shaders, std::move(options)), interface_pass_(gl, shaders) {}

void Viewer::draw(const FrameInput& input, const Target& target) {
  at_.layout.scale = input.scale * at_.state.settings.text_scale;
  follow_language();
  lay_out(input);
  if (!events_.empty())
    at_.frames_to_settle = 3;
  else if (at_.frames_to_settle > 0)
    --at_.frames_to_settle;
  for (const Event& event : std::exchange(events_, {})) {
    at_.interface.feed(event);
    react(event);
  }
  for (const Action action : std::exchange(at_.state.pending_actions, {})) perform(action);
  for (const auto& mode : at_.modes) mode->take_requests();
  if (auto request = std::exchange(at_.state.to_load, {})) open(std::move(*request));
  lay_out(input);
  for (const auto& mode : at_.modes) mode->update();
  advance(input.seconds);
  show_hovered();
  lay_out(input);
  at_.picture.draw(at_, input.size, target);
  for (const auto& mode : at_.modes) mode->draw_inset(target);
  draw_interface(input, target);
}

void Viewer::follow_language() {
  const std::string& wanted = at_.state.settings.language;
  if (wanted.empty() || wanted == at_.interface.language().tag) return;
  const auto& known = at_.state.languages;
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const Language& language) { return language.tag == wanted; });
  if (found != known.end()) at_.interface.speak(*found);
}

/// One view, or as many as a mode wants, beside the panel and above what stands at the lower edge.
void Viewer::lay_out(const FrameInput& input) {
  Layout& layout = at_.layout;
  layout.size = input.size;
  const double left =
      at_.state.settings.panel ? std::min<double>(theme::panel_width * layout.scale, input.size.width / 2.0) : 0;
  const double whole = std::round(left);
  constexpr double least_share = 0.3;  // of the picture, above the dock
  double dock = 0;
  for (const auto& mode : at_.modes) dock = std::max(dock, std::ceil(mode->dock_height()));
  dock = at_.state.shown ? std::min(dock, (1 - least_share) * input.size.height) : 0;
  layout.viewport = {whole, 0, input.size.width - whole, input.size.height - std::ceil(dock)};
  for (const auto& mode : at_.modes)
    if (layout.panes = mode->panes(layout.viewport); !layout.panes.empty()) return;
  layout.panes = {{layout.viewport, at_.state.scene.camera}};
}

void Viewer::advance(double seconds) {
  ViewerState& state = at_.state;
  CameraMotion& motion = at_.motion;
  at_.now += seconds;
  for (Notice& shown : state.notices) shown.seconds_left -= seconds;
  std::erase_if(state.notices, [](const Notice& shown) { return shown.seconds_left <= 0; });
  if (motion.camera) {
    state.scene.camera = motion.camera->advance(seconds);
    if (motion.camera->over()) motion.camera.reset();
  }
  if (motion.looks) {
    state.scene = motion.looks->advance(seconds, state.scene.camera, state.shown->model);
    if (motion.looks->over()) motion.looks.reset();
  }
  at_.fade.advance(seconds);
  for (const auto& mode : at_.modes) mode->advance(seconds);
}

void Viewer::perform(Action action) {
  if (action == Action::toggle_panel) {
    at_.state.settings.panel = !at_.state.settings.panel;
    return;
  }
  if (action == Action::escape) {
    put_away();
    return;
  }
  for (const auto& mode : at_.modes)
    if (mode->perform(action)) return;
}

void Viewer::put_away() {
  for (const PutAway what : {PutAway::dialog, PutAway::step})
    for (const auto& mode : at_.modes)
      if (mode->put_away(what)) return;
  for (auto mode = at_.modes.rbegin(); mode != at_.modes.rend(); ++mode)
    if ((*mode)->put_away(PutAway::mark)) return;
}

void Viewer::show_hovered() {
  Pointing& pointing = at_.pointing;
  pointing.compass.reset();
  pointing.grip.reset();
  pointing.hit.reset();
  pointing.canal.reset();
  pointing.pointer = at_.interface.pointer();
  if (!at_.state.shown || pointing.held) return;
  if (at_.modes.any(&Mode::catches_mouse)) {
    pointing.pointer = Pointer::caught;
    return;
  }
  const ViewPane* pane = at_.pane_at(pointing.x, pointing.y);
  if (!pane) return;
  pointing.compass = compass_hit(at_.layout.panes.back(), at_.layout.scale, pointing.x, pointing.y);
  const Hover hover{*pane, pointing.x, pointing.y};
  if (!pointing.compass) pointing.grip = at_.modes.grip_at(hover);
  if (pointing.at_model()) pointing.hit = at_.hit_at(*pane, pointing.x, pointing.y);
  for (const auto& mode : at_.modes)
    if (mode->hover(hover)) return;
  if (!pointing.at_model()) pointing.pointer = Pointer::hand;
}

double Viewer::wait_timeout() const {
  const ViewerState& state = at_.state;
  if (at_.fade.on() || at_.motion.camera || at_.motion.looks || at_.modes.any(&Mode::moving) ||
      at_.frames_to_settle > 0 || !state.pending_actions.empty() || state.to_load || !events_.empty())
    return 0;
  constexpr double loading = 1.0 / 30, refining = 0.05, idle = 0.5;
  if (at_.modes.any(&Mode::working)) return loading;
  return at_.picture.refining(at_) ? refining : idle;
}

bool Viewer::may_close() {
  return std::all_of(at_.modes.begin(), at_.modes.end(), [](const auto& mode) { return mode->may_close(); });
}

std::string Viewer::title() const {
  if (!at_.state.shown) return "Odontoscope";
  const LoadedModel& shown = *at_.state.shown;
  return fmt::format("{}{}{} \xE2\x80\x94 Odontoscope", at_.interface.say(shown.title), shown.tooth.empty() ? "" : ", ",
                     at_.interface.say(shown.tooth));
}

}  // namespace odontoscope
