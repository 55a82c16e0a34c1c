// Flying: into the pulp and out again, keys and sticks, and what each frame does with them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"
#include "engine/navigate/wall_depth.h"
#include "engine/ui/actions.h"
#include "engine/ui/fly_annotations.h"
#include "engine/ui/viewer.h"
#include "engine/view/gamepad.h"

namespace odontoscope {

namespace {

constexpr double darken_seconds = 0.30, brighten_seconds = 0.40;
constexpr double dive_zoom = 2.2;
constexpr double notch_speed_factor = 1.16, shift_speed_factor = 3;
/// A drag as long as the picture is high turns by so many fields of view.
constexpr double drag_fields = 1.3;
/// As parts of the model's radius: how far the lamp reaches, and what still darkens a corner.
constexpr double lamp_reach = 0.14;
constexpr float crevice_reach = 0.035f;
/// Before the outer surface, in parts of the model's radius.
constexpr double outdoors_before = 0.45, outdoors_beyond = 1.5;
constexpr double widest_picture = 2.4;  // width over height
constexpr std::size_t most_trail = 4000;
constexpr double trail_step = 3;  // clearances

/// As one number: letters by place, other keys beyond them.
int held_as(const KeyChanged& key) { return key.place ? key.place : 256 + static_cast<int>(key.key); }
int held_as(Key key) { return 256 + static_cast<int>(key); }

constexpr double reading_seconds = 14;

/// Why one cannot fly inside, and what to do.
std::string words_without_cavity(const LoadedModel& shown) {
  if (!shown.flight) return "One cannot fly in this model: nothing is known of its walls.";
  if (shown.certificate.verdict == Certificate::Verdict::wanting)
    return "There is no cavity in this model to fly in: its surface is not closed (see Report), so it has no inside. "
           "Open a sound model, or fly around this one (A).";
  const char* volume =
      shown.values ? " A lower grey value keeps thin walls closed: open the volume again with one." : "";
  return fmt::format(
      "There is no cavity in this model to fly in: nothing in it is hollow all round. Where a root is open at its tip, "
      "fly around (A) and in through the opening.{}"
      " A structure with \"pulp\" in its name counts as a cavity, too.",
      volume);
}

}  // namespace

bool Viewer::flight_possible() const { return state_.shown && state_.shown->flight; }

const Walls& Viewer::walls_now() const {
  const FlightSpaces& spaces = *state_.shown->flight;
  return state_.fly.cavity ? spaces.cavities[*state_.fly.cavity].walls : spaces.outside;
}

FlightRules Viewer::flight_rules() const {
  FlightRules rules = state_.shown->flight->rules;
  const Comfort& comfort = state_.settings.comfort;
  const bool hurry = held_.contains(held_as(Key::shift)) || gamepad_.faster;
  rules.speed_factor = std::min(state_.fly.speed_factor * (hurry ? shift_speed_factor : 1), comfort.speed_limit);
  if (comfort.reduced_motion) rules.turn_deg_per_second = 45;
  return rules;
}

/// Fades to dark, does it, and fades in again. What comes while it is dark waits for no second fade.
void Viewer::darken_then(std::function<void()> at_dark) {
  if (fade_ && !fade_->done) fade_->at_dark();
  fade_ = Fade{0, false, std::move(at_dark)};
}

void Viewer::enter_cavity(std::size_t cavity, std::function<void()> then) {
  if (!flight_possible() || cavity >= state_.shown->flight->cavities.size()) {
    notice(words_without_cavity(*state_.shown), false, reading_seconds);
    return;
  }
  const FlightSpace& space = state_.shown->flight->cavities[cavity];
  if (!state_.fly.on && !state_.settings.comfort.reduced_motion)
    go_to(zoom(state_.scene.camera, dive_zoom, space.middle));
  darken_then([this, cavity, then = std::move(then)] {
    const FlightSpace& there = state_.shown->flight->cavities[cavity];
    const glm::dvec3 sight = longest_free_direction(there.walls, there.middle);
    arrive(cavity, looking(there.middle, sight));
    if (then) then();
  });
}

void Viewer::enter_outdoors() {
  if (!flight_possible()) return;
  const SightLine line = sight_line(state_.scene.camera, {0, 0});
  darken_then([this, line] {
    const FlightSpaces& spaces = *state_.shown->flight;
    const Model& model = state_.shown->model;
    const double far = spaces.outside.free_distance(line.origin, line.direction);
    glm::dvec3 eye = line.origin + (far - outdoors_before * model.radius_mm) * line.direction;
    if (!std::isfinite(far) || !spaces.outdoors(eye) || spaces.outside.nearest(eye).distance < spaces.rules.clearance)
      eye = model.bounds_mm.centre() - outdoors_beyond * model.radius_mm * line.direction;
    arrive(std::nullopt, looking(eye, line.direction));
  });
}

/// Where the eye is now, and what it sees there.
void Viewer::arrive(std::optional<std::size_t> cavity, const Flight& flight) {
  FlyState& fly = state_.fly;
  if (!fly.on) {
    settle_looks();
    fly.lab_before = state_.lab.on;
    leave_lab();
    fly.scene_before = state_.scene;
    if (camera_before_dive_) fly.scene_before.camera = *std::exchange(camera_before_dive_, std::nullopt);
    state_.tool = Tool::look;
    state_.measured = {};
    state_.lab.lesson.reset();
  }
  transition_.reset();
  drag_.reset();
  interface_.leave_keys();  // arrows look around now
  fly.on = true;
  fly.cavity = cavity;
  fly.flight = flight;
  fly.trail = {flight.eye};
  fly.ride.reset();
  fly.labels = cavity ? labels_inside(state_.shown->flight->cavities[*cavity])
                      : labels_outside(state_.shown->model, *state_.shown->flight);
  state_.scene = fly.scene_before;
  if (cavity) {
    const Model& model = state_.shown->model;
    state_.scene = seen_within(fly.scene_before, model, state_.shown->flight->cavities[*cavity].wall(),
                               lamp_reach * model.radius_mm);
    state_.scene.occlusion = {.on = true, .strength = 1.1f, .reach = crevice_reach};
    const auto depths = depth_labels(state_.shown->flight->cavities[*cavity], state_.shown->model.depth_step_mm);
    fly.labels.insert(fly.labels.end(), depths.begin(), depths.end());
  }
  see_from_flight();
}

void Viewer::see_from_flight() {
  const FlyState& fly = state_.fly;
  if (fly.cavity) state_.scene.wall_depth = state_.settings.comfort.wall_depth;
  const double aspect = panes_.front().area.aspect(), angle = state_.settings.comfort.field_of_view_deg;
  const double ahead = walls_now().free_distance(fly.flight.eye, fly.flight.view_direction);
  state_.scene.camera = camera_of(fly.flight, angle, std::isfinite(ahead) ? ahead : state_.shown->model.radius_mm);
  // Wide enough for pictures of another shape, too.
  state_.scene.camera.near_mm =
      safe_near_mm(state_.shown->flight->rules.clearance, angle, std::max(aspect, widest_picture));
}

void Viewer::leave_flight() {
  if (!state_.fly.on) return;
  darken_then([this] {
    const bool lab = state_.fly.lab_before;
    end_flight();
    if (lab) enter_lab();  // what one came from
  });
}

/// At once: the view from before.
void Viewer::end_flight() {
  if (!state_.fly.on) return;
  state_.scene = state_.fly.scene_before;
  FlyState ended;  // the next flight begins as this one ended
  ended.speed_factor = state_.fly.speed_factor;
  ended.show_labels = state_.fly.show_labels;
  ended.show_where = state_.fly.show_where;
  ended.inset_from = state_.fly.inset_from;
  ended.dark = state_.fly.dark;
  state_.fly = std::move(ended);
  held_.clear();
  transition_.reset();
}

void Viewer::pass_wall() {
  const auto passage = passage_ahead(*state_.shown->flight, state_.fly.cavity, state_.fly.flight);
  if (!passage) {
    notice("Straight ahead there is no room beyond the wall. Look another way.");
    return;
  }
  darken_then([this, passage = *passage] {  // outside one turns round: ahead there would be nothing
    const Flight& flight = state_.fly.flight;
    arrive(passage.cavity,
           looking(passage.at, passage.cavity ? flight.view_direction : -flight.view_direction, flight.up));
  });
}

bool Viewer::perform_in_flight(Action action) {
  FlyState& fly = state_.fly;
  switch (action) {
    case Action::enter_pulp:
      if (fade_ && !fade_->done) return true;  // on the way already: a key that is held repeats
      state_.help = false;
      if (!fly.on) camera_before_dive_ = transition_ ? transition_->goal() : state_.scene.camera;
      if (!fly.on)
        enter_cavity(0);
      else if (fly.cavity)
        leave_flight();
      else
        enter_cavity(0);
      return true;
    case Action::fly_outdoors:
      if (fade_ && !fade_->done) return true;
      if (!fly.on) camera_before_dive_ = transition_ ? transition_->goal() : state_.scene.camera;
      enter_outdoors();
      return true;
    default:
      break;
  }
  if (!fly.on) return false;
  if (perform_on_ride(action)) return true;
  switch (action) {
    case Action::leave_flight:
      leave_flight();
      return true;
    case Action::pass_wall:
      pass_wall();
      return true;
    case Action::catch_mouse:
      fly.mouse_caught = !fly.mouse_caught;
      return true;
    case Action::faster:
      fly.speed_factor = std::min(fly.speed_factor * notch_speed_factor, most_speed_factor);
      return true;
    case Action::slower:
      fly.speed_factor = std::max(fly.speed_factor / notch_speed_factor, least_speed_factor);
      return true;
    case Action::take_picture:
    case Action::save_scene:
    case Action::toggle_wire:
      return false;
    default:
      return true;  // what is for looking from outside
  }
}

void Viewer::on_flight_key(const KeyChanged& key) {
  if (!key.down) {
    held_.erase(held_as(key));
    return;
  }
  if (key.with.control || key.with.alt) return;
  held_.insert(held_as(key));
  if (key.key == Key::backspace) state_.pending_actions.push_back(Action::leave_flight);
}

void Viewer::on_gamepad(const GamepadChanged& gamepad) {
  const GamepadChanged before = std::exchange(gamepad_, gamepad);
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
  if (!state_.fly.on) {
    ask(&GamepadChanged::play, Action::enter_pulp);
    ask(&GamepadChanged::leave, Action::escape);
    return;
  }
  ask(&GamepadChanged::pass, Action::pass_wall);
  ask(&GamepadChanged::play, state_.fly.cavity ? Action::ride_play : Action::enter_pulp);
  ask(&GamepadChanged::next, Action::next_canal);
  ask(&GamepadChanged::labels, Action::toggle_labels);
  ask(&GamepadChanged::pictures, Action::toggle_where);
  if (pressed(&GamepadChanged::leave))
    state_.pending_actions.push_back(state_.help ? Action::escape : Action::leave_flight);
}

FlightWish Viewer::flight_wish() const {
  const auto either = [&](int a, int b) { return held_.contains(a) || held_.contains(b) ? 1.0 : 0.0; };
  FlightWish wish;
  wish.move = {either('d', 'l') - either('a', 'j'), either('e', 'o') - either('q', 'u'),
               either('w', 'i') - either('s', 'k')};
  wish.turn = {either(held_as(Key::right), 0) - either(held_as(Key::left), 0),
               either(held_as(Key::up), 0) - either(held_as(Key::down), 0)};
  wish.move += glm::dvec3(gamepad_.move_right, gamepad_.rise, gamepad_.move_ahead);
  wish.turn += glm::dvec2(gamepad_.turn_right, gamepad_.turn_up);
  return wish;
}

/// The hand went so many pixels.
void Viewer::look_by(double across, double down) {
  const double per_pixel =
      glm::radians(drag_fields * state_.settings.comfort.field_of_view_deg) / std::max(panes_.front().area.height, 1.0);
  const glm::dvec2 angles = per_pixel * glm::dvec2(across, -down);
  if (state_.fly.ride)
    state_.fly.ride->look += angles;
  else
    state_.fly.flight = turned(state_.fly.flight, angles, flight_rules());
}

void Viewer::advance_flight(double seconds) {
  FlyState& fly = state_.fly;
  if (fade_) {
    fade_->seconds += seconds;
    if (!fade_->done && fade_->seconds >= darken_seconds) {
      fade_->done = true;
      const std::function<void()> at_dark = std::exchange(fade_->at_dark, nullptr);
      at_dark();
    }
    const double light = (fade_->seconds - darken_seconds) / brighten_seconds;
    fly.dark = fade_->done ? std::clamp(1 - light, 0.0, 1.0) : fade_->seconds / darken_seconds;
    if (fade_->done && light >= 1) fade_.reset();
  }
  if (!fly.on) return;
  const glm::dvec3 sight_before = fly.sight_before;
  const bool may_move = !fade_ || fade_->done;
  const FlightWish wish = may_move ? flight_wish() : FlightWish{};
  if (fly.ride) advance_ride(wish, seconds);
  if (!fly.ride) fly.flight = flight_after(fly.flight, wish, walls_now(), flight_rules(), seconds);
  if (fly.cavity)
    fly.place = canal_place(state_.shown->flight->cavities[*fly.cavity].lines, fly.flight.eye);
  else
    fly.place.reset();
  const double step = trail_step * state_.shown->flight->rules.clearance;
  if (fly.trail.empty() || glm::length(fly.flight.eye - fly.trail.back()) > step) fly.trail.push_back(fly.flight.eye);
  if (fly.trail.size() > most_trail) fly.trail.erase(fly.trail.begin());
  // How fast the picture turns, evened out over a few frames.
  const double angle = sight_before == glm::dvec3(0)
                           ? 0
                           : std::acos(std::clamp(glm::dot(sight_before, fly.flight.view_direction), -1.0, 1.0));
  constexpr double quick = 1.2, evened = 0.15;  // rad/s, seconds
  const double now = seconds > 0 ? std::min(angle / seconds / quick, 1.0) : fly.turning;
  fly.turning += (1 - std::exp(-seconds / evened)) * (now - fly.turning);
  if (fly.turning < 0.01) fly.turning = 0;
  fly.sight_before = fly.flight.view_direction;
  see_from_flight();
}

bool Viewer::flight_moves() const {
  if (fade_) return true;
  if (!state_.fly.on) return false;
  if (state_.fly.ride && (state_.fly.ride->playing || state_.fly.ride->pace != 0)) return true;
  const FlightWish wish = flight_wish();
  return wish.move != glm::dvec3(0) || wish.turn != glm::dvec2(0) || state_.fly.turning > 0 ||
         !resting(state_.fly.flight, state_.shown->flight->rules);
}

}  // namespace odontoscope
