#pragma once
// The parts of a step of visit.h, one file each. Private to this room.

#include <algorithm>

#include "engine/headset/visit.h"
#include "engine/navigate/flight.h"

namespace odontoscope::visit_steps {

/// Buttons that give numbers: pressed above the first, released below the second, so that a tremor is no second press.
inline constexpr double pressed_above = 0.6, released_below = 0.4;
inline constexpr double stick_at_rest = 0.15;

inline bool went_down(double before, double now) { return before <= pressed_above && now > pressed_above; }
inline bool pulled(const Visit& visit, const HeadsetInput& input, std::size_t hand) {
  return visit.hands.before[hand].tracked && went_down(visit.hands.before[hand].trigger, input.hands[hand].trigger);
}
/// The hand's ray and trigger are the panel's.
inline bool at_panel(const Visit& visit, std::size_t hand) { return visit.hands.on_panel[hand].has_value(); }

/// What a hand feels: that a trigger did something, that there is a wall.
inline constexpr double tap = 0.4, knock = 0.7;
inline void feel(Visit& visit, std::size_t hand, double strength) {
  visit.hands.pulse[hand] = std::max(visit.hands.pulse[hand], strength);
}

/// +1 or -1 in the moment in which the stick is pushed to a side.
int snap_of(const HandInput& before, const HandInput& hand);
/// The stick forth and back, from -1 to 1.
double along(const HandInput& hand);

// visit_panel.cpp
void use_menu(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
              double seconds);
void point_at_panel(Visit& visit, const HeadsetInput& input);
void perform(Visit& visit, const HeadsetInput& input, const VisitWorld& world);
void change_size(Visit& visit, const HeadsetInput& input, const VisitWorld& world);

// visit_hands.cpp
/// What the hand's ray meets on the model: what is opaque first, otherwise the first that can be seen.
void point_at_model(Visit& visit, const HeadsetInput& input, const VisitWorld& world);
/// Measures or names what a trigger met; false: that was not for it.
bool use_tool(Visit& visit, std::size_t hand);
void step_outside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                  double seconds);

// visit_inside.cpp
/// How far the ball gets from `from` along `direction` (unit length) before it touches a wall, mm, at most `most`.
/// Precondition: it touches none at `from`.
double free_way(const Walls& walls, const glm::dvec3& from, const glm::dvec3& direction, double most, double clearance);
FlightRules flight_rules(const Stage& stage, const ComfortRules& rules);
void step_inside(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                 double seconds);

// visit_tour.cpp
/// In the dark: at the line's start, in a room of the tour's own scale. Nothing is changed where the line is nowhere
/// wide enough.
void begin_tour(Visit& visit, const FlightSpace& cavity, std::size_t line, const HeadsetInput& input,
                const VisitWorld& world, const ComfortRules& rules);
void step_tour(Visit& visit, const HeadsetInput& input, const ComfortRules& rules, double seconds);
/// Stops or goes on; at the line's end the way back.
void play(Ride& tour);

}  // namespace odontoscope::visit_steps
