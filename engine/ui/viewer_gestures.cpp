// Mouse and keys in the picture.

#include <algorithm>
#include <cmath>

#include "engine/navigate/moves.h"
#include "engine/ui/actions.h"
#include "engine/ui/annotations.h"
#include "engine/ui/fly_annotations.h"
#include "engine/ui/names.h"
#include "engine/ui/viewer.h"

namespace odontoscope {

namespace {

constexpr double turn_over_height_deg = 200;  // for a drag as long as the picture is high
constexpr double notch_factor = 1.16, key_factor = 1.2, key_turn_deg = 10, key_pan = 0.08;
constexpr double click_slack = 4, double_click_slack = 6, double_click_seconds = 0.4;  // interface pixels

}  // namespace

const ViewPane* Viewer::pane_at(double x, double y) const {
  if (interface_.covers(x, y)) return nullptr;
  const auto found =
      std::find_if(panes_.begin(), panes_.end(), [&](const ViewPane& pane) { return pane.shown().holds(x, y); });
  return found == panes_.end() ? nullptr : &*found;
}

void Viewer::set_camera(const Camera& camera) {
  transition_.reset();
  state_.scene.camera = within_reach(camera, state_.shown->model);
  for (ViewPane& pane : panes_) pane.camera = state_.scene.camera;
}

std::optional<Hit> Viewer::hit_at(const ViewPane& pane, double x, double y) const {
  if (!state_.shown) return std::nullopt;
  const SightLine line = sight_line(pane.camera, place_in(pane.area, x, y));
  return pick(pickable_of(pane), state_.scene, {line.origin, line.direction});
}

glm::dvec3 Viewer::anchor_at(const ViewPane& pane, double x, double y) const {
  if (const auto hit = hit_at(pane, x, y)) return hit->point_mm;
  return point_at_depth_of(pane.camera, place_in(pane.area, x, y), pane.camera.target);
}

void Viewer::react(const Event& event) {
  if (std::holds_alternative<KeyChanged>(event) || std::holds_alternative<MouseButtonChanged>(event))
    state_.pad_in_hand = false;
  if (const auto* move = std::get_if<MouseMoved>(&event))
    on_move(*move);
  else if (const auto* button = std::get_if<MouseButtonChanged>(&event))
    on_button(*button);
  else if (const auto* scroll = std::get_if<Scrolled>(&event))
    on_scroll(*scroll);
  else if (const auto* key = std::get_if<KeyChanged>(&event))
    on_key(*key);
  else if (const auto* text = std::get_if<TextTyped>(&event))
    on_text(*text);
  else if (const auto* drop = std::get_if<FilesDropped>(&event))
    on_drop(*drop);
  else if (const auto* gamepad = std::get_if<GamepadChanged>(&event))
    on_gamepad(*gamepad);
  else if (std::get_if<FocusLost>(&event)) {
    drag_.reset();
    held_.clear();
    state_.fly.mouse_caught = false;
  }
}

void Viewer::on_move(const MouseMoved& move) {
  if (state_.fly.on && state_.fly.mouse_caught && !drag_) look_by(move.x - mouse_x_, move.y - mouse_y_);
  mouse_x_ = move.x;
  mouse_y_ = move.y;
  if (!drag_ || !state_.shown) return;
  Drag& drag = *drag_;
  drag.moved = drag.moved || std::hypot(move.x - drag.start_x, move.y - drag.start_y) > click_slack * scale_;
  if (!drag.moved) return;
  const ViewPane& pane = panes_[std::min(drag.pane, panes_.size() - 1)];
  const glm::dvec2 from = place_in(pane.area, drag.x, drag.y), to = place_in(pane.area, move.x, move.y);
  const Camera camera = state_.scene.camera;
  switch (drag.what) {
    case Drag::What::orbit: {
      const glm::dvec2 degrees = 0.5 * turn_over_height_deg * (to - from);
      set_camera(orbit(camera, {degrees.x, -degrees.y, camera.target}));
      break;
    }
    case Drag::What::pan:
      set_camera(pan(camera, from, to, drag.anchor));
      break;
    case Drag::What::look:
      look_by(move.x - drag.x, move.y - drag.y);
      break;
    case Drag::What::split:
      state_.lab.split = std::clamp((move.x - viewport_.left) / viewport_.width, 0.02, 0.98);
      break;
    case Drag::What::section:
      if (state_.scene.section)
        state_.scene.section = dragged(*state_.scene.section, drag.grip, camera, handle_reach(pane.area, scale_), from,
                                       to, state_.shown->model);
      break;
  }
  drag.x = move.x;
  drag.y = move.y;
}

void Viewer::on_button(const MouseButtonChanged& button) {
  if (button.down) {
    settle_looks();
    interface_.leave_keys();
    if (!drag_ && state_.shown && (!job_ || state_.draft)) on_press(button);
    return;
  }
  if (!drag_ || drag_->button != button.button) return;
  if (state_.fly.on) state_.fly.mouse_caught = state_.fly.mouse_caught && !drag_->moved;
  const Drag drag = *drag_;
  drag_.reset();
  if (!drag.moved && drag.button == MouseButton::left && drag.what != Drag::What::section &&
      drag.what != Drag::What::split)
    on_click(mouse_x_, mouse_y_);
}

void Viewer::on_press(const MouseButtonChanged& button) {
  const ViewPane* pane = pane_at(mouse_x_, mouse_y_);
  if (!pane) return;
  if (button.button == MouseButton::left) {
    if (const auto named = compass_hit(panes_.back(), scale_, mouse_x_, mouse_y_)) {
      state_.pending_actions.push_back(*named);
      return;
    }
  }
  if (state_.fly.on) {
    drag_ = Drag{.what = Drag::What::look,
                 .button = button.button,
                 .x = mouse_x_,
                 .y = mouse_y_,
                 .start_x = mouse_x_,
                 .start_y = mouse_y_};
    return;
  }
  Drag drag{.button = button.button, .x = mouse_x_, .y = mouse_y_, .start_x = mouse_x_, .start_y = mouse_y_};
  drag.anchor = anchor_at(*pane, mouse_x_, mouse_y_);
  drag.pane = static_cast<std::size_t>(pane - panes_.data());
  if (button.button == MouseButton::left && on_split_line(mouse_x_, mouse_y_))
    drag.what = Drag::What::split;
  else if (button.button != MouseButton::left || button.with.shift)
    drag.what = Drag::What::pan;
  else if (handle_shown()) {
    const auto handle = section_handle(*state_.scene.section, pane->camera, handle_reach(pane->area, scale_));
    const auto grip =
        handle ? grip_at(*handle, place_in(pane->area, mouse_x_, mouse_y_), handle_tolerance(pane->area, scale_))
               : std::nullopt;
    if (grip) {
      drag.what = Drag::What::section;
      drag.grip = *grip;
    }
  }
  drag_ = drag;
}

void Viewer::on_click(double x, double y) {
  const bool second = now_ - last_click_.when < double_click_seconds &&
                      std::hypot(x - last_click_.x, y - last_click_.y) < double_click_slack * scale_;
  last_click_ = second ? Click{} : Click{x, y, now_};
  const ViewPane* pane = pane_at(x, y);
  if (!pane) return;
  if (point_for_lesson(*pane, x, y)) {
    last_click_ = {};
    return;
  }
  const auto hit = hit_at(*pane, x, y);
  if (state_.fly.on) {
    if (const auto small = canal_in_small_picture(x, y))
      ride_canal(small->cavity, small->line);
    else if (const auto line = label_hit(state_, *pane, interface_, scale_, x, y))
      begin_ride(*line);
    return;
  }
  if (const auto name =
          names_shown() && pane == &panes_.front() ? name_hit(state_, *pane, interface_, scale_, x, y) : std::nullopt) {
    state_.name_told = state_.name_told == name ? std::nullopt : name;
    return;
  }
  state_.name_told.reset();
  if (state_.tool != Tool::look) {
    if (hit) measure_at(pickable_of(*pane), *hit);
    return;
  }
  state_.canal = canal_at(*pane, x, y);
  if (second && state_.canal && !state_.canal->in_chamber)
    enter_here();
  else if (second && hit)
    go_to(centred_on(state_.scene.camera, hit->point_mm));
}

void Viewer::measure_at(const Pickable& pickable, const Hit& hit) {
  Measured& measured = state_.measured;
  if (state_.tool == Tool::distance) {
    if (measured.ends.size() != 1) measured = {};
    measured.ends.push_back(hit);
    return;
  }
  measured = {};
  measured.wall_at = hit;
  measured.wall = wall_thickness(pickable, hit);
  if (!measured.wall)
    notice(hit.triangle ? "No wall here: straight into the material there is no other side."
                        : "Measure walls on a surface, not on the cut.");
}

void Viewer::on_scroll(const Scrolled& scroll) {
  const ViewPane* pane = pane_at(mouse_x_, mouse_y_);
  if (!pane || !state_.shown || scroll.along == 0) return;
  const double notches = std::clamp(scroll.along, -10.0, 10.0);
  if (state_.fly.on) {
    state_.fly.speed_factor =
        std::clamp(state_.fly.speed_factor * std::pow(notch_factor, notches), least_speed_factor, most_speed_factor);
    return;
  }
  set_camera(zoom(state_.scene.camera, std::pow(notch_factor, notches), anchor_at(*pane, mouse_x_, mouse_y_)));
}

bool Viewer::on_panel_key(const KeyChanged& key) {
  if (!key.down) return false;  // what was held before it came here is let go
  if (key.key == Key::tab) {
    if (!dialog_open()) state_.settings.panel = true;
    tabs_ += key.with.shift ? -1 : 1;
    return true;
  }
  if (key.key == Key::enter && !interface_.by_keys() && answer_by_enter()) return true;
  if (!interface_.by_keys()) return false;
  switch (key.key) {
    case Key::left:
    case Key::right:
    case Key::up:
    case Key::down:
    case Key::space:
    case Key::enter:
      return true;
    case Key::escape:
      if (interface_.popup_open()) return true;  // ImGui closes it
      interface_.leave_keys();
      return !dialog_open();
    default:
      return false;
  }
}

/// What a dialog's first button says.
bool Viewer::answer_by_enter() {
  if (interface_.wants_text()) return false;
  if (!state_.trouble.empty())
    state_.trouble.clear();
  else if (state_.notes.leaving)
    state_.notes.leaving->answer = LeavingNotes::Answer::save;
  else if (state_.question) {
    if (!state_.question->answered()) return true;
    state_.to_load = answer_of(*state_.question);
    state_.question.reset();
  } else if (state_.help)
    state_.help = false;
  else
    return false;
  return true;
}

void Viewer::on_key(const KeyChanged& key) {
  if (key.down && key.place) last_place_ = key.place;
  if (on_panel_key(key)) return;
  if (key.down && key.key == Key::enter && state_.notes.placing != NotesState::Placing::none) return point_at_middle();
  if (!interface_.wants_text() && lesson_.handle(key, state_)) return;
  if (state_.fly.on && !(key.down && state_.notes.draft) && !(key.down && interface_.wants_text())) on_flight_key(key);
  if (!key.down) return;
  if (interface_.wants_text() && key.key != Key::escape) return;
  if (state_.fly.on)
    if (const auto action = action_for(key, flight_keys())) {
      state_.pending_actions.push_back(*action);
      return;
    }
  if (const auto action = action_for(key)) {
    state_.pending_actions.push_back(*action);
    return;
  }
  if (!state_.shown || state_.fly.on) return;
  glm::dvec2 direction{0};
  if (key.key == Key::left)
    direction = {-1, 0};
  else if (key.key == Key::right)
    direction = {1, 0};
  else if (key.key == Key::up)
    direction = {0, 1};
  else if (key.key == Key::down)
    direction = {0, -1};
  else
    return;
  const Camera& camera = state_.scene.camera;
  if (key.with.shift)
    set_camera(pan(camera, {0, 0}, key_pan * direction, camera.target));
  else
    set_camera(orbit(camera, {key_turn_deg * direction.x, -key_turn_deg * direction.y, camera.target}));
}

void Viewer::on_text(const TextTyped& typed) {
  if (interface_.wants_text()) return;
  // Greek or Cyrillic letters command as the American ones in their places do.
  constexpr char32_t beyond_latin = 0x250;
  const TextTyped text{typed.character >= beyond_latin && last_place_ ? static_cast<char32_t>(last_place_)
                                                                      : typed.character};
  if (!(dialog_open() && !lesson_.menu()) && lesson_.handle(text, state_)) return;
  if ((dialog_open() && !lesson_.menu() && text.character != U'?') || state_.notes.draft)
    return;  // letters are for what is being written
  if (state_.fly.on) {
    if (const auto action = action_for(text, flight_keys()))
      state_.pending_actions.push_back(*action);
    else if (text.character >= U'1' && text.character <= U'9')
      begin_ride(text.character - U'1');
    return;
  }
  if (const auto action = action_for(text)) {
    state_.pending_actions.push_back(*action);
    return;
  }
  if (!state_.shown) return;
  if (text.character == U'+' || text.character == U'=')
    set_camera(zoom(state_.scene.camera, key_factor, state_.scene.camera.target));
  if (text.character == U'-') set_camera(zoom(state_.scene.camera, 1 / key_factor, state_.scene.camera.target));
}

void Viewer::on_drop(const FilesDropped& drop) {
  if (!drop.files.empty()) state_.to_load = LoadRequest{.file = drop.files.front(), .volume = {}};
  if (drop.files.size() > 1) notice("One file at a time: the first was taken.");
}

void Viewer::show_hovered() {
  hovered_compass_.reset();
  hovered_grip_.reset();
  state_.under_pointer.reset();
  state_.canal_under_pointer.reset();
  pointer_ = interface_.pointer();
  if (!state_.shown || drag_) return;
  if (state_.fly.on && state_.fly.mouse_caught) {
    pointer_ = Pointer::caught;
    return;
  }
  const ViewPane* pane = pane_at(mouse_x_, mouse_y_);
  if (!pane) return;
  hovered_compass_ = compass_hit(panes_.back(), scale_, mouse_x_, mouse_y_);
  if (!hovered_compass_ && handle_shown()) {
    const auto handle = section_handle(*state_.scene.section, pane->camera, handle_reach(pane->area, scale_));
    if (handle)
      hovered_grip_ = grip_at(*handle, place_in(pane->area, mouse_x_, mouse_y_), handle_tolerance(pane->area, scale_));
  }
  if (!hovered_compass_ && !hovered_grip_) state_.under_pointer = hit_at(*pane, mouse_x_, mouse_y_);
  if (lesson_.wants_click(state_.notes) || state_.notes.placing != NotesState::Placing::none) {
    state_.under_pointer.reset();  // what is there is the question
    if (!hovered_compass_ && !hovered_grip_) pointer_ = Pointer::cross;
    return;
  }
  if (lesson_.asked(state_.notes)) {
    state_.under_pointer.reset();
    return;
  }
  const bool over_picture = !hovered_compass_ && !hovered_grip_ && state_.tool == Tool::look;
  if (over_picture)
    state_.canal_under_pointer =
        state_.fly.on ? canal_in_small_picture(mouse_x_, mouse_y_) : canal_at(*pane, mouse_x_, mouse_y_);
  const bool canal = state_.canal_under_pointer && (state_.fly.on || !state_.canal_under_pointer->in_chamber);
  if (hovered_compass_ || hovered_grip_ || canal || on_split_line(mouse_x_, mouse_y_))
    pointer_ = Pointer::hand;
  else if (state_.tool != Tool::look)
    pointer_ = Pointer::cross;
}

}  // namespace odontoscope
