#pragma once
// What happens in the headset, as pure functions: hands, head and time in; where the model stands and what is seen out. Needs no runtime.
//
// Outside, the tooth stands in the room: one hand carries it, two scale and turn it, a stick turns it by steps and brings it nearer; a trigger on a
// cavity that can be seen leads into it. Inside, a trigger glides where the hand points, sticks move and turn, and neither they nor the head get
// through a wall. Menu leads out again; outside it changes between enlarged and true size. Nothing happens without the system's focus.

#include <array>
#include <optional>
#include <span>

#include "engine/headset/hands.h"
#include "engine/headset/stage.h"
#include "engine/measure/pick.h"
#include "engine/navigate/flight_spaces.h"

namespace odontoscope {

/// What keeps people well. Lengths and speeds are those of the room, however much the model is enlarged.
struct ComfortRules {
  double snap_turn_deg = 30;        // turns are sudden: smooth ones make ill
  double most_speed = 1.2;          // m/s
  double speed_per_distance = 1.2;  // 1/s: slower where walls are near
  double clearance = 0.12;          // m from the middle of the eyes to any wall
  double roomy = 1.3;               // m to the nearest wall where one comes in
  double fade_seconds = 0.3;        // into the dark, and out of it again
  double vignette_seconds = 0.15;   // in which the edges of sight darken while one glides
};

struct VisitWorld {
  const Model& model;
  const Pickable& pickable;
  const Scene& scene;               // as seen from outside
  std::span<const FlightSpace> cavities;
};

struct Visit {
  /// Where a fade leads.
  struct Way {
    std::optional<std::size_t> into;   // none: out
    friend bool operator==(const Way&, const Way&) = default;
  };
  enum class Held { nothing, model };

  Stage stage;
  bool placed = false;                   // before the person, once there is one
  std::optional<std::size_t> cavity;     // that one is in
  Stage stage_outside;                   // to come back to
  glm::dvec3 eye_mm{0}, velocity{0};     // inside: the middle of the eyes, and mm/s that sticks and triggers gave it
  std::array<HandInput, 2> before;       // what the hands did last
  std::array<Held, 2> held{};
  std::array<std::optional<Hit>, 2> pointed;   // outside: what the hands point at
  std::optional<Way> way;
  double dark = 0;                       // of the fade: 1 hides everything
  double vignette = 0;                   // 0 to 1
  double told = 0;                       // seconds for which the magnification is still to be seen
};

/// `seconds` later. Precondition: finite input.
Visit stepped(const Visit& visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules, double seconds);

/// The stage on which the roomiest place of the cavity is where the head is, upright.
Stage inside(const FlightSpace& cavity, const Pose& head, const Model& model, const ComfortRules& rules);

}  // namespace odontoscope
