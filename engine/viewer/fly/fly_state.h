#pragma once
// Flight as plain values: where the eye is, what is seen there, and what leaving brings back.

#include <optional>
#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/labels.h"
#include "engine/navigate/ride.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// Slower and faster than usual, at most.
inline constexpr double least_speed_factor = 0.2, most_speed_factor = 8;

/// The next flight begins as this one ended.
struct FlightHabits {
  double speed_factor = 1;  // the person's, on all speeds
  bool labels = true;
  bool inset = true;                         // the small picture of the tooth,
  NamedView inset_from = NamedView::buccal;  // and its side
};

struct FlyState {
  bool on = false;
  std::optional<std::size_t> cavity;  // of LoadedModel::flight; none: outdoors
  Flight flight;
  bool mouse_caught = false;      // every move of the mouse turns the eye
  double turning = 0;             // 0 to 1, how fast the picture turns: for the vignette,
  glm::dvec3 view_before{0};      // since the frame before
  std::vector<glm::dvec3> trail;  // where the eye was, one place every few clearances
  Scene scene_before;
  std::optional<double> view_deg;  // the angle of view of the note that led here; none: the person's own

  std::optional<Ride> ride;               // along a canal; any key that flies ends it
  std::optional<std::size_t> ride_asked;  // of rideable(), begun in the next frame
  std::optional<CanalPlace> place;        // in terms of the cavity's lines; none outdoors, or where it has none
  std::vector<FlightLabel> labels;
  FlightHabits habits;
};

}  // namespace odontoscope
