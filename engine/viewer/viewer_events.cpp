// Mouse and keys: what becomes of an event before modes are asked, and after.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/viewer/look/annotations.h"
#include "engine/viewer/viewer.h"

namespace odontoscope {

namespace {

constexpr double click_slack = 4, double_click_slack = 6, double_click_seconds = 0.4;  // interface pixels

}  // namespace

void Viewer::react(const Event& event) {
  if (std::holds_alternative<KeyChanged>(event) || std::holds_alternative<MouseButtonChanged>(event))
    at_.state.pad_in_hand = false;
  if (const auto* button = std::get_if<MouseButtonChanged>(&event)) return on_button(*button);
  if (const auto* scroll = std::get_if<Scrolled>(&event)) return on_scroll(*scroll);
  if (const auto* key = std::get_if<KeyChanged>(&event)) return on_key(*key);
  if (const auto* text = std::get_if<TextTyped>(&event)) return on_text(*text);
  offer(event);
  if (const auto* move = std::get_if<MouseMoved>(&event)) on_move(*move);
  if (std::holds_alternative<FocusLost>(event)) at_.pointing.held.reset();
}

bool Viewer::offer(const Event& event) {
  return std::any_of(at_.modes.begin(), at_.modes.end(), [&](const auto& mode) { return mode->handle(event); });
}

void Viewer::on_move(const MouseMoved& move) {
  Pointing& pointing = at_.pointing;
  pointing.x = move.x;
  pointing.y = move.y;
  if (!pointing.held || !at_.state.shown) return;
  HeldDrag& held = *pointing.held;
  held.moved = held.moved || std::hypot(move.x - held.start_x, move.y - held.start_y) > click_slack * at_.layout.scale;
  if (!held.moved) return;
  const ViewPane& pane = at_.layout.panes[std::min(held.pane, at_.layout.panes.size() - 1)];
  held.drag.move({pane,
                  place_in(pane.area, held.x, held.y),
                  place_in(pane.area, move.x, move.y),
                  {move.x - held.x, move.y - held.y},
                  move.x});
  held.x = move.x;
  held.y = move.y;
}

void Viewer::on_button(const MouseButtonChanged& button) {
  Pointing& pointing = at_.pointing;
  if (button.down) {
    at_.settle_looks();
    at_.interface.leave_keys();
    if (!pointing.held && at_.state.shown && (!loading() || at_.state.origin.draft)) on_press(button);
    return;
  }
  if (!pointing.held || pointing.held->button != button.button) return;
  const HeldDrag held = *std::exchange(pointing.held, std::nullopt);
  if (held.drag.end) held.drag.end(held.moved);
  if (!held.moved && held.button == MouseButton::left && held.drag.may_be_click) on_click(pointing.x, pointing.y);
}

void Viewer::on_press(const MouseButtonChanged& button) {
  Pointing& pointing = at_.pointing;
  const ViewPane* pane = at_.pane_at(pointing.x, pointing.y);
  if (!pane) return;
  if (button.button == MouseButton::left) {
    if (const auto named = compass_hit(at_.layout.panes.back(), at_.layout.scale, pointing.x, pointing.y)) {
      at_.state.pending_actions.push_back(*named);
      return;
    }
  }
  const Press press{*pane, pointing.x, pointing.y, button.button, button.with};
  for (const auto& mode : at_.modes)
    if (auto drag = mode->press(press)) {
      pointing.held = HeldDrag{.drag = std::move(*drag),
                               .button = button.button,
                               .x = pointing.x,
                               .y = pointing.y,
                               .start_x = pointing.x,
                               .start_y = pointing.y,
                               .pane = static_cast<std::size_t>(pane - at_.layout.panes.data())};
      return;
    }
}

void Viewer::on_click(double x, double y) {
  auto& last = at_.pointing.last_click;
  const bool second = at_.now - last.when < double_click_seconds &&
                      std::hypot(x - last.x, y - last.y) < double_click_slack * at_.layout.scale;
  last = {};
  if (!second) last = {x, y, at_.now};
  const ViewPane* pane = at_.pane_at(x, y);
  if (!pane) return;
  for (const auto& mode : at_.modes)
    if (mode->click({*pane, x, y, second})) return;
}

void Viewer::on_scroll(const Scrolled& scroll) {
  if (!at_.pane_at(at_.pointing.x, at_.pointing.y) || !at_.state.shown || scroll.along == 0) return;
  offer(Scrolled{scroll.across, std::clamp(scroll.along, -10.0, 10.0), scroll.with});
}

bool Viewer::on_panel_key(const KeyChanged& key) {
  if (!key.down) return false;  // what was held before it came here is let go
  Interface& interface = at_.interface;
  if (key.key == Key::tab) {
    if (!at_.modes.dialog_open()) at_.state.settings.panel = true;
    steps_by_tab_ += key.with.shift ? -1 : 1;
    return true;
  }
  if (key.key == Key::enter && !interface.by_keys() && answer_by_enter()) return true;
  if (!interface.by_keys()) return false;
  switch (key.key) {
    case Key::left:
    case Key::right:
    case Key::up:
    case Key::down:
    case Key::space:
    case Key::enter:
      return true;
    case Key::escape:
      if (interface.popup_open()) return true;  // ImGui closes it
      interface.leave_keys();
      return !at_.modes.dialog_open();
    default:
      return false;
  }
}

/// What a dialog's first button says.
bool Viewer::answer_by_enter() {
  if (at_.interface.wants_text()) return false;
  return std::any_of(at_.modes.begin(), at_.modes.end(), [](const auto& mode) { return mode->answer(); });
}

void Viewer::on_key(const KeyChanged& key) {
  if (key.down && key.place) last_place_ = key.place;
  if (on_panel_key(key) || offer(key)) return;
  if (!key.down || (at_.interface.wants_text() && key.key != Key::escape)) return;
  if (const auto action = action_for(key)) at_.state.pending_actions.push_back(*action);
}

void Viewer::on_text(const TextTyped& typed) {
  if (at_.interface.wants_text()) return;
  // Greek or Cyrillic letters command as the American ones in their places do.
  constexpr char32_t beyond_latin = 0x250;
  const TextTyped text{typed.character >= beyond_latin && last_place_ ? static_cast<char32_t>(last_place_)
                                                                      : typed.character};
  const bool choosing = at_.modes.any(&Mode::chooses_by_letter);
  if (at_.modes.dialog_open() && !choosing && text.character != U'?') return;
  if (offer(text)) return;
  if (const auto action = action_for(text)) at_.state.pending_actions.push_back(*action);
}

}  // namespace odontoscope
