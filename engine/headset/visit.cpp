#include "engine/headset/visit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/headset/visit_steps.h"

namespace odontoscope {

namespace {

using namespace visit_steps;

/// The lamp's reach, in clearances of the roomiest place: near walls are bright, and a canal's end is dark.
constexpr double lamp_reach = 1.5;

/// The side that the window's camera looks at is the side towards the person.
glm::dvec3 facing(const Camera& camera) { return camera.position - camera.target; }

/// In the dark.
void go(Visit& visit, const Visit::Way& way, const HeadsetInput& input, const VisitWorld& world,
        const ComfortRules& rules) {
  visit.velocity = glm::dvec3(0);
  visit.hands.leap_mm = {};
  visit.at_wall = false;
  if (way.to_mm) {
    visit.eye_mm = *way.to_mm;
    visit.stage = moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));
    return;
  }
  if (!visit.cavity) visit.stage_outside = visit.stage;
  visit.tour.ride.reset();
  if (way.into) {
    const FlightSpace& cavity = world.cavities[*way.into];
    visit.stage = inside(cavity, input.head, world.model, rules);
    visit.eye_mm = cavity.middle;
    if (way.along) begin_tour(visit, cavity, *way.along, input, world, rules);
  } else {
    visit.stage = visit.stage_outside;
  }
  visit.cavity = way.into;
  visit.hands.held = {};
  visit.hands.pointed = {};
  visit.hands.on_frame = {};
  visit.marks.named.reset();
  visit.marks.ends.clear();  // they are seen from one side of the wall only
}

void fade(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds) {
  const double share = seconds / rules.fade_seconds;
  visit.seen.dark = std::clamp(visit.seen.dark + (visit.way ? share : -share), 0.0, 1.0);
  if (!visit.way || visit.seen.dark < 1) return;
  go(visit, *visit.way, input, world, rules);
  visit.way.reset();
}

/// Before the person, for the first time or because they asked the system for it.
void place(Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  const bool again = visit.placed;
  if (again && !input.recentred) return;
  if (!again) visit.scene = world.scene;
  if (visit.cavity)
    visit.stage =
        moved(visit.stage, input.head.position - to_room(visit.stage, visit.eye_mm));  // only the numbers changed
  else
    visit.stage = before(input.head, world.model, again ? visit.stage.magnification : usual_magnification,
                         facing(world.scene.camera));
  if (!again || visit.panel) visit.panel = place_panel(input.head, 1);
  visit.placed = true;
}

}  // namespace

Stage inside(const FlightSpace& cavity, const Pose& head, const Model& model, const ComfortRules& rules) {
  const Stage stage = before(head, model, rules.roomy / (metres_per_mm * cavity.clearance_mm));
  return moved(stage, head.position - to_room(stage, cavity.middle));
}

Scene scene_of(const Visit& visit, const VisitWorld& world) {
  if (!visit.cavity) return visit.scene;
  const FlightSpace& space = world.cavities[*visit.cavity];
  Scene inside = seen_within(visit.scene, world.model, space.wall(), lamp_reach * space.clearance_mm);
  inside.wall_depth = visit.chosen.on_wall == WallNumber::depth;
  inside.wall_thickness = visit.chosen.on_wall == WallNumber::thickness;
  return inside;
}

Visit advance_visit(Visit visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                    double seconds) {
  visit.hands.pulse = {};
  if (!input.head_tracked) return visit;
  const double magnified = visit.stage.magnification;
  place(visit, input, world);
  if (!input.focused) {  // what was held is let go; nothing jumps when the focus comes back
    visit.hands.held = {};
    visit.hands.before = {};
    visit.hands.pointed = {};
    visit.hands.on_panel = {};
    visit.hands.on_frame = {};
    visit.hands.leap_mm = {};
    visit.hands.pressing = {};
    visit.hands.menu_held = {-1, -1};
    visit.velocity = glm::dvec3(0);
    return visit;
  }
  fade(visit, input, world, rules, seconds);
  if (!visit.way) {
    perform(visit, input, world);
    use_menu(visit, input, world, rules, seconds);
    point_at_panel(visit, input);
    HeadsetInput rest = input;  // a stick over the panel moves what is written there
    for (std::size_t i = 0; i < 2; ++i)
      if (at_panel(visit, i)) rest.hands[i].stick = {0, 0};
    if (visit.cavity)
      step_inside(visit, rest, world, rules, seconds);
    else
      step_outside(visit, rest, world, rules, seconds);
  }
  constexpr double told_for = 3;
  if (!visit.cavity && visit.stage.magnification != magnified)
    visit.seen.told = told_for;
  else
    visit.seen.told = std::max(0.0, visit.seen.told - seconds);
  const double speed = visit.cavity ? glm::length(visit.velocity) / mm_per_metre(visit.stage) / rules.most_speed : 0;
  const double share = 1 - std::exp(-seconds / rules.vignette_seconds);
  visit.seen.vignette += share * (std::min(speed, 1.0) - visit.seen.vignette);
  visit.hands.before = input.hands;
  return visit;
}

}  // namespace odontoscope
