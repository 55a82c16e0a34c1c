#pragma once
// What happens in the headset, as pure functions: hands, head and time in; where the model stands and what is seen out.
// Needs no runtime.
//
// Outside, the tooth stands in the room: one hand carries it, two scale and turn it, a stick turns it by steps and
// brings it nearer; a trigger on a cavity that can be seen leads into it; a section plane is held by its frame. Inside,
// a trigger glides where the hand points, sticks move and turn, and neither they nor the head get through a wall. A
// panel stands beside the person: menu fetches it and puts it away, a hand's ray is its mouse, and what is chosen on it
// is asked for by VisitAction. Menu held down leads out again; outside it changes between enlarged and true size. A
// tour leads along a canal: the place moves, the view never turns. Nothing happens without the system's focus.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/headset/hands.h"
#include "engine/headset/room_panel.h"
#include "engine/headset/stage.h"
#include "engine/measure/pick.h"
#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/labels.h"
#include "engine/navigate/ride.h"

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
  double menu_seconds = 0.7;        // that menu is held down to go out, or to change the size
  double tour_room = 0.5;           // m to the wall in the middle of a canal that a tour leads along,
  double tour_down_deg = 25;        // which leads ahead and so much down: the tooth is laid so while it is dark
};

struct VisitWorld {
  const Model& model;
  const Pickable& pickable;
  const Scene& scene;  // as seen from outside when the visit begins
  std::span<const FlightSpace> cavities;
};

/// What a trigger does on the model, where the panel is not. look: enters a cavity, names what else it meets. distance:
/// marks its ends.
enum class HandTool { look, distance };

/// How a trigger moves the person inside. glide: it leads where the hand points. leap: it shows a place there, and
/// letting it go leads to it in the dark.
enum class Travel { glide, leap };

/// What is asked for on the panel and done in the next step.
enum class VisitAction {
  enter,
  leave,
  change_size,
  toggle_section,
  flip_section,
  forget_marks,
  show_dt,
  show_db,
  tour_play,
  tour_back,
  end_tour,
  put_panel_away,
  leave_headset
};

/// What the two hands did last, and what they do now.
struct VisitHands {
  enum class Held { nothing, model, panel, section };

  std::array<HandInput, 2> before;
  std::array<Held, 2> held{};
  std::array<std::optional<Hit>, 2> pointed;          // what they point at, unless it is the panel
  std::array<std::optional<glm::dvec3>, 2> on_frame;  // the place of the section's frame that they mean, in the room
  std::array<std::optional<PanelPlace>, 2> on_panel;  // of those that point at it, or hold a press that began on it
  std::array<bool, 2> pressing{};                     // that press
  std::array<double, 2> menu_held{};                  // seconds; below 0: it has done what it does when held
  std::array<std::optional<glm::dvec3>, 2> leap_mm;   // where a trigger would lead when it is let go
  std::array<double, 2> pulse{};                      // what they shall feel of this step, 0 to 1
};

/// What passes over what is seen.
struct VisitSight {
  double dark = 0;      // of the fade: 1 hides everything
  double vignette = 0;  // 0 to 1
  double told = 0;      // seconds for which the magnification is still to be seen
};

/// Along a canal, inside.
struct VisitTour {
  std::optional<Ride> ride;
  glm::dvec3 off_mm{0};       // where the head leans
  double speed_factor = 0.5;  // the person's part of the usual pace
  /// Of rideable(), of the cavity one is in, else of the largest; begun in the next step.
  std::optional<std::size_t> asked;
};

/// What was pointed out.
struct VisitMarks {
  std::optional<Hit> named;  // what a trigger met last
  std::vector<Hit> ends;     // of a distance: one or two
};

/// Chosen on the panel.
struct VisitChoices {
  bool db = false;  // the other method's model is wanted in place of the certified one
  HandTool tool = HandTool::look;
  Travel travel = Travel::glide;
  bool labels = true;                      // names of canals, inside
  WallNumber on_wall = WallNumber::depth;  // Scene::wall_depth, or Scene::wall_thickness, inside
};

struct Visit {
  /// Where a fade leads.
  struct Way {
    std::optional<std::size_t> into;        // none: out
    std::optional<std::size_t> along = {};  // of rideable(): a tour begins there
    std::optional<glm::dvec3> to_mm = {};   // a leap within the cavity, nothing else
    friend bool operator==(const Way&, const Way&) = default;
  };
  using Held = VisitHands::Held;

  Stage stage;
  bool placed = false;                      // before the person, once there is one
  Scene scene;                              // as seen from outside: the world's, and what was changed on the panel
  std::optional<Section> section_put_away;  // what switching the section off and on again brings back
  std::optional<std::size_t> cavity;        // that one is in
  Stage stage_outside;                      // to come back to
  glm::dvec3 eye_mm{0}, velocity{0};        // inside: the middle of the eyes, and mm/s that sticks and triggers gave it
  bool at_wall = false;                     // the head's ball touches it
  VisitHands hands;
  std::optional<Way> way;
  VisitSight seen;
  std::optional<RoomPanel> panel;
  VisitChoices chosen;
  VisitMarks marks;
  VisitTour tour;
  std::vector<VisitAction> pending_actions;
  bool leaving = false;  // asked for on the panel: the headset itself
};

/// `seconds` later. Precondition: finite input.
Visit advance_visit(Visit visit, const HeadsetInput& input, const VisitWorld& world, const ComfortRules& rules,
                    double seconds);

/// The stage on which the roomiest place of the cavity is where the head is, upright.
Stage inside(const FlightSpace& cavity, const Pose& head, const Model& model, const ComfortRules& rules);

/// What the person sees: from outside, or the cavity's wall and nothing else.
Scene scene_of(const Visit& visit, const VisitWorld& world);

/// The hand whose ray is the panel's mouse: that which presses, else one that points, the right one first; none if
/// neither does.
std::optional<std::size_t> panel_hand(const Visit& visit);

}  // namespace odontoscope
