#include "engine/viewer/fly/fly_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/fly/fly_panel.h"
#include "engine/viewer/help/help_mode.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

namespace {

constexpr double dive_zoom = 2.2;
constexpr double notch_speed_factor = 1.16, shift_speed_factor = 3;
/// As parts of the model's radius: how far the lamp reaches, and what still darkens a corner.
constexpr double lamp_reach = 0.14;
constexpr float crevice_reach = 0.035f;
/// Before the outer surface, in parts of the model's radius.
constexpr double outdoors_before = 0.45, outdoors_beyond = 1.5;
constexpr double widest_picture = 2.4;  // width over height
constexpr std::size_t most_trail = 4000;
constexpr double trail_step = 3;  // clearances
constexpr double reading_seconds = 14;

/// Why one cannot fly inside, and what to do.
std::string words_without_cavity(const LoadedModel& shown) {
  if (!shown.flight) return "This model has no cavity to fly in: nothing is known of its walls.";
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

const FlightSpace* FlyMode::inside() const {
  return fly_.on && fly_.cavity ? &state_.shown->flight->cavities[*fly_.cavity] : nullptr;
}

std::string FlyMode::canal_here() const {
  const FlightSpace* space = inside();
  return space && fly_.place ? rideable(space->lines)[fly_.place->line]->name : std::string();
}

const Walls& FlyMode::walls() const {
  const FlightSpaces& spaces = *state_.shown->flight;
  return fly_.cavity ? spaces.cavities[*fly_.cavity].walls : spaces.outside;
}

FlightRules FlyMode::rules() const {
  FlightRules rules = state_.shown->flight->rules;
  const Comfort& comfort = state_.settings.comfort;
  rules.speed_factor =
      std::min(fly_.habits.speed_factor * (input_.hurries() ? shift_speed_factor : 1), comfort.speed_limit);
  if (comfort.reduced_motion) rules.turn_deg_per_second = 45;
  return rules;
}

void FlyMode::remember_view() {
  if (!fly_.on) view_before_dive_ = at_.camera_goal();
}

void FlyMode::dive(std::size_t cavity, std::function<void()> then) {
  remember_view();
  enter_cavity(cavity, std::move(then));
}

void FlyMode::enter_cavity(std::size_t cavity, std::function<void()> then) {
  if (!possible() || cavity >= state_.shown->flight->cavities.size()) {
    notice(words_without_cavity(*state_.shown), NoticeKind::told, reading_seconds);
    return;
  }
  const FlightSpace& space = state_.shown->flight->cavities[cavity];
  if (!fly_.on && !state_.settings.comfort.reduced_motion)
    at_.go_to(zoom(state_.scene.camera, dive_zoom, space.middle));
  at_.fade.darken_then([this, cavity, then = std::move(then)] {
    const FlightSpace& there = state_.shown->flight->cavities[cavity];
    const glm::dvec3 sight = longest_free_direction(there.walls, there.middle);
    arrive(cavity, looking(there.middle, sight));
    if (then) then();
  });
}

void FlyMode::enter_outdoors() {
  if (!possible()) return;
  const SightLine line = sight_line(state_.scene.camera, {0, 0});
  at_.fade.darken_then([this, line] {
    const FlightSpaces& spaces = *state_.shown->flight;
    const Model& model = state_.shown->model;
    const double far = spaces.outside.free_distance(line.origin, line.direction);
    glm::dvec3 eye = line.origin + (far - outdoors_before * model.radius_mm) * line.direction;
    if (!std::isfinite(far) || !spaces.outdoors(eye) || spaces.outside.nearest(eye).distance < spaces.rules.clearance)
      eye = model.bounds_mm.centre() - outdoors_beyond * model.radius_mm * line.direction;
    arrive(std::nullopt, looking(eye, line.direction));
  });
}

void FlyMode::arrive(std::optional<std::size_t> cavity, const Flight& flight) {
  if (!fly_.on) {
    at_.settle_looks();
    suspended_.clear();
    for (const auto& mode : at_.modes)
      if (mode->suspend()) suspended_.push_back(mode.get());
    fly_.scene_before = state_.scene;
    if (view_before_dive_) fly_.scene_before.camera = *std::exchange(view_before_dive_, std::nullopt);
  }
  at_.motion.camera.reset();
  at_.pointing.held.reset();
  at_.interface.leave_keys();  // arrows look around now
  fly_.on = true;
  fly_.cavity = cavity;
  fly_.flight = flight;
  fly_.trail = {flight.eye};
  fly_.ride.reset();
  fly_.view_deg.reset();
  fly_.labels = cavity ? labels_inside(state_.shown->flight->cavities[*cavity])
                       : labels_outside(state_.shown->model, *state_.shown->flight);
  state_.scene = fly_.scene_before;
  if (cavity) {
    const Model& model = state_.shown->model;
    state_.scene = seen_within(fly_.scene_before, model, state_.shown->flight->cavities[*cavity].wall(),
                               lamp_reach * model.radius_mm);
    state_.scene.occlusion = {.on = true, .strength = 1.1f, .reach = crevice_reach};
    const auto depths = depth_labels(state_.shown->flight->cavities[*cavity], state_.shown->model.depth_step_mm);
    fly_.labels.insert(fly_.labels.end(), depths.begin(), depths.end());
    const auto thin = thickness_labels(state_.shown->flight->cavities[*cavity]);
    fly_.labels.insert(fly_.labels.end(), thin.begin(), thin.end());
  }
  see();
}

void FlyMode::see() {
  if (fly_.cavity) {
    state_.scene.wall_depth = state_.settings.comfort.wall_depth;
    state_.scene.wall_thickness = state_.settings.comfort.wall_thickness;
  }
  const double aspect = at_.front().area.aspect(),
               angle = fly_.view_deg.value_or(state_.settings.comfort.field_of_view_deg);
  const double ahead = walls().free_distance(fly_.flight.eye, fly_.flight.view_direction);
  state_.scene.camera = camera_of(fly_.flight, angle, std::isfinite(ahead) ? ahead : state_.shown->model.radius_mm);
  // Wide enough for pictures of another shape, too.
  state_.scene.camera.near_mm =
      safe_near_mm(state_.shown->flight->rules.clearance, angle, std::max(aspect, widest_picture));
}

void FlyMode::see_as(double field_of_view_deg) {
  fly_.view_deg = field_of_view_deg;
  see();
}

void FlyMode::go_out() {
  if (!fly_.on) return;
  at_.fade.darken_then([this] {
    const std::vector<Mode*> suspended = suspended_;
    leave();
    for (Mode* mode : suspended) mode->resume();  // what one came from
  });
}

/// The view from before.
void FlyMode::leave() {
  if (!fly_.on) return;
  state_.scene = fly_.scene_before;
  FlyState ended;
  ended.habits = fly_.habits;
  fly_ = std::move(ended);
  suspended_.clear();
  input_.release_all();
  at_.motion.camera.reset();
}

void FlyMode::pass_wall() {
  const auto passage = passage_ahead(*state_.shown->flight, fly_.cavity, fly_.flight);
  if (!passage) {
    notice("Straight ahead there is no room beyond the wall. Look another way.");
    return;
  }
  at_.fade.darken_then([this, passage = *passage] {  // outside one turns round: ahead there would be nothing
    const Flight& flight = fly_.flight;
    arrive(passage.cavity,
           looking(passage.at, passage.cavity ? flight.view_direction : -flight.view_direction, flight.up));
  });
}

bool FlyMode::perform(Action action) {
  if (!state_.shown) {
    if (action == Action::enter_pulp)
      notice(at_.modes.loading() ? "The model is still being made." : "Open a model first.");
    return false;
  }
  switch (action) {
    case Action::enter_pulp:
      if (at_.fade.darkening()) return true;  // on the way already: a key that is held repeats
      at_.modes.get<HelpMode>().close();
      if (fly_.on && fly_.cavity)
        go_out();
      else
        dive(0);
      return true;
    case Action::fly_outdoors:
      if (at_.fade.darkening()) return true;
      remember_view();
      enter_outdoors();
      return true;
    default:
      break;
  }
  if (!fly_.on) return false;
  if (perform_on_ride(action)) return true;
  switch (action) {
    case Action::leave_flight:
      go_out();
      return true;
    case Action::pass_wall:
      pass_wall();
      return true;
    case Action::catch_mouse:
      fly_.mouse_caught = !fly_.mouse_caught;
      return true;
    case Action::faster:
      fly_.habits.speed_factor = std::min(fly_.habits.speed_factor * notch_speed_factor, most_speed_factor);
      return true;
    case Action::slower:
      fly_.habits.speed_factor = std::max(fly_.habits.speed_factor / notch_speed_factor, least_speed_factor);
      return true;
    case Action::take_picture:
    case Action::save_scene:
    case Action::toggle_wire:
      return false;
    default:
      return true;  // what is for looking from outside
  }
}

void FlyMode::take_requests() {
  if (const auto line = std::exchange(fly_.ride_asked, {})) begin_ride(*line);
}

void FlyMode::advance(double seconds) {
  if (!fly_.on) return;
  const FlightWish wish = at_.fade.darkening() ? FlightWish{} : input_.wish();
  if (fly_.ride) advance_ride(wish, seconds);
  if (!fly_.ride) fly_.flight = flight_after(fly_.flight, wish, walls(), rules(), seconds);
  if (fly_.cavity)
    fly_.place = canal_place(state_.shown->flight->cavities[*fly_.cavity].lines, fly_.flight.eye);
  else
    fly_.place.reset();
  const double step = trail_step * state_.shown->flight->rules.clearance;
  if (fly_.trail.empty() || glm::length(fly_.flight.eye - fly_.trail.back()) > step)
    fly_.trail.push_back(fly_.flight.eye);
  if (fly_.trail.size() > most_trail) fly_.trail.erase(fly_.trail.begin());
  note_turning(seconds);
  see();
}

/// How fast the picture turns, evened out over a few frames.
void FlyMode::note_turning(double seconds) {
  const glm::dvec3 before = std::exchange(fly_.view_before, fly_.flight.view_direction);
  const double angle =
      before == glm::dvec3(0) ? 0 : std::acos(std::clamp(glm::dot(before, fly_.flight.view_direction), -1.0, 1.0));
  constexpr double quick = 1.2, evened = 0.15;  // rad/s, seconds
  const double now = seconds > 0 ? std::min(angle / seconds / quick, 1.0) : fly_.turning;
  fly_.turning += (1 - std::exp(-seconds / evened)) * (now - fly_.turning);
  if (fly_.turning < 0.01) fly_.turning = 0;
}

bool FlyMode::moving() const {
  if (!fly_.on) return false;
  if (fly_.ride && (fly_.ride->playing || fly_.ride->pace != 0)) return true;
  const FlightWish wish = input_.wish();
  return wish.move != glm::dvec3(0) || wish.turn != glm::dvec2(0) || fly_.turning > 0 ||
         !resting(fly_.flight, state_.shown->flight->rules);
}

ModeEffects FlyMode::effects() const {
  if (!fly_.on) return {};
  return {.from_outside = false, .names = false, .first_hints = false, .shadows_while_moving = false};
}

void FlyMode::draw_inset(const Target& target) {
  if (fly_.on && fly_.habits.inset) inset_.draw(at_, fly_.habits.inset_from, target);
}

void FlyMode::draw(DrawLayer layer, const DrawnPane& drawn) {
  if (layer != DrawLayer::ground || !fly_.on) return;
  draw_flight(fly_, state_, drawn.pane, at_.interface, at_.layout.scale);
  if (state_.settings.comfort.vignette && fly_.turning > 0) draw_vignette(at_.layout.viewport, fly_.turning);
}

std::vector<PanelSection> FlyMode::panel() {
  if (!fly_.on) return {{SectionPlace::entrance, [this] { fly_entrance(fly_, state_, at_.interface); }}};
  return {{SectionPlace::entrance, [this] { fly_sections(fly_, state_, at_.interface); }, true}};
}

}  // namespace odontoscope
