// Flying by hand: keys, mouse and gamepad.

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "engine/navigate/screen.h"
#include "engine/view/gamepad.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/help/help_mode.h"
#include "engine/viewer/names/canals.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

/// A drag as long as the picture is high turns by so many fields of view.
constexpr double drag_fields = 1.3;
constexpr double scrolled_speed_factor = 1.16;

}  // namespace

const KeyTable* FlyMode::keys() const { return fly_.on ? &flight_keys() : nullptr; }

void FlyMode::let_go() {
  input_.release_all();
  fly_.mouse_caught = false;
}

bool FlyMode::handle(const Event& event) {
  if (const auto* gamepad = std::get_if<GamepadChanged>(&event)) {
    on_gamepad(*gamepad);
    return true;
  }
  if (std::holds_alternative<FocusLost>(event)) let_go();
  if (!fly_.on) return false;
  if (const auto* move = std::get_if<MouseMoved>(&event)) {
    const Pointing& hand = at_.pointing;
    if (fly_.mouse_caught && !hand.held) look_by({move->x - hand.x, move->y - hand.y});
  } else if (const auto* wheel = std::get_if<Scrolled>(&event)) {
    fly_.habits.speed_factor = std::clamp(fly_.habits.speed_factor * std::pow(scrolled_speed_factor, wheel->along),
                                          least_speed_factor, most_speed_factor);
    return true;
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    return on_key(*key);
  } else if (const auto* text = std::get_if<TextTyped>(&event)) {
    if (const auto action = action_for(*text, flight_keys().keys))
      state_.pending_actions.push_back(*action);
    else if (text->character >= U'1' && text->character <= U'9')
      begin_ride(text->character - U'1');
    return true;
  }
  return false;
}

bool FlyMode::on_key(const KeyChanged& key) {
  if (!key.down) {
    input_.release(key);
    return false;
  }
  const bool written_to = at_.interface.wants_text();
  if (!written_to && !at_.modes.writing() && !key.with.control && !key.with.alt) {
    input_.press(key);
    if (key.key == Key::backspace) state_.pending_actions.push_back(Action::leave_flight);
  }
  if (written_to && key.key != Key::escape) return false;
  const auto action = action_for(key, flight_keys().keys);
  if (action) state_.pending_actions.push_back(*action);
  return action.has_value();
}

void FlyMode::on_gamepad(const GamepadChanged& gamepad) {
  const GamepadChanged before = input_.take(gamepad);
  if (gamepad.present != before.present)
    notice(gamepad.present ? "A gamepad is there: Start shows what it does."
                           : "The gamepad is gone. Keys and mouse go on.");
  state_.pad_in_hand = gamepad.present && (state_.pad_in_hand || in_use(gamepad));
  if (!gamepad.present) return;
  const auto pressed = [&](bool GamepadChanged::*button) { return gamepad.*button && !(before.*button); };
  const auto ask = [&](bool GamepadChanged::*button, Action action) {
    if (pressed(button)) state_.pending_actions.push_back(action);
  };
  ask(&GamepadChanged::help, Action::toggle_help);
  ask(&GamepadChanged::next_note, Action::next_step);
  ask(&GamepadChanged::previous_note, Action::previous_step);
  ask(&GamepadChanged::outdoors, Action::fly_outdoors);
  if (!fly_.on) {
    ask(&GamepadChanged::play, Action::enter_pulp);
    ask(&GamepadChanged::leave, Action::escape);
    return;
  }
  ask(&GamepadChanged::pass, Action::pass_wall);
  ask(&GamepadChanged::play, fly_.cavity ? Action::ride_play : Action::enter_pulp);
  ask(&GamepadChanged::next, Action::next_canal);
  ask(&GamepadChanged::labels, Action::toggle_labels);
  ask(&GamepadChanged::pictures, Action::toggle_where);
  if (pressed(&GamepadChanged::leave))
    state_.pending_actions.push_back(at_.modes.get<HelpMode>().dialog_open() ? Action::escape : Action::leave_flight);
}

/// The hand went so many pixels.
void FlyMode::look_by(const glm::dvec2& pixels) {
  const double per_pixel =
      glm::radians(drag_fields * state_.settings.comfort.field_of_view_deg) / std::max(at_.front().area.height, 1.0);
  const glm::dvec2 angles = per_pixel * glm::dvec2(pixels.x, -pixels.y);
  if (fly_.ride)
    fly_.ride->look += angles;
  else
    fly_.flight = turned(fly_.flight, angles, rules());
}

std::optional<Drag> FlyMode::press(const Press&) {
  if (!fly_.on) return {};
  return Drag{.move = [this](const DragMove& move) { look_by(move.pixels); },
              .end = [this](bool moved) { fly_.mouse_caught = fly_.mouse_caught && !moved; }};
}

bool FlyMode::click(const Click& click) {
  if (!fly_.on) return false;
  if (const auto canal = canal_in_inset(click.x, click.y))
    ride_canal(canal->cavity, canal->line);
  else if (const auto line = label_hit(fly_, state_, click.pane, at_.interface, at_.layout.scale, click.x, click.y))
    begin_ride(*line);
  return true;
}

bool FlyMode::hover(const Hover& hover) {
  Pointing& pointing = at_.pointing;
  if (!fly_.on || !pointing.at_model()) return false;
  pointing.canal = canal_in_inset(hover.x, hover.y);
  if (pointing.canal) pointing.pointer = Pointer::hand;
  return false;
}

std::optional<CanalPick> FlyMode::canal_in_inset(double x, double y) const {
  if (!fly_.habits.inset || at_.layout.panes.empty()) return std::nullopt;
  const Area area = inset_area(at_.front(), at_.layout.scale);
  if (!area.holds(x, y)) return std::nullopt;
  const Camera camera = inset_camera(state_.shown->model, fly_.habits.inset_from, area);
  const SightLine sight = from_before(sight_line(camera, place_in(area, x, y)), camera, state_.shown->model);
  return pick_canal(*state_.shown->flight, sight, {.slack_mm = canal_slack_mm(camera, area, at_.layout.scale)});
}

bool FlyMode::put_away(PutAway what) {
  if (what != PutAway::step || !fly_.on) return false;
  go_out();
  return true;
}

}  // namespace odontoscope
